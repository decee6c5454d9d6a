// Replies of a process that may send anything.
#include "tests/judge/code/replies.hpp"

#include <cstring>
#include <functional>

#include "judge/code/runner.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof::judge;
using replies::bytes_of;
using replies::Fake;

constexpr Answer returned{};
constexpr Answer stuck{.ending = {.end = End::endless}};

TEST(Replies, AnswersAreReadAsTheyAre) {
  Answer answer{.broken = Call::moves_segments, .changed = 0xFF};
  answer.words = {1, 2, 3};
  const auto read = read_answers(bytes_of({answer, stuck}), 4, 8);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), 2U);
  EXPECT_EQ((*read)[0].words, answer.words);
  EXPECT_EQ((*read)[1].ending.end, End::endless);
}

TEST(Replies, FalseAnswersAreRefused) {
  const auto is_read = [](const std::string& reply, std::size_t asked) {
    return read_answers(reply, asked, 8).has_value();
  };
  const std::string two = bytes_of({returned, returned});
  EXPECT_TRUE(is_read(two, 2));
  EXPECT_FALSE(is_read("", 2));
  EXPECT_FALSE(is_read(two, 1)) << "more than asked";
  EXPECT_FALSE(is_read(two, 3)) << "fewer, and none is stuck";
  EXPECT_FALSE(is_read(two.substr(1), 2)) << "cut";
  EXPECT_FALSE(is_read(two + "x", 2)) << "too long";
  EXPECT_FALSE(is_read(bytes_of({stuck, returned}), 2)) << "goes on after a stuck call";
  const auto with = [](auto change) {
    Answer answer;
    change(answer);
    return bytes_of({answer});
  };
  EXPECT_FALSE(is_read(with([](Answer& a) { a.ending.end = static_cast<End>(200); }), 1));
  EXPECT_FALSE(is_read(with([](Answer& a) { a.broken = 1U << 12U; }), 1));
  EXPECT_FALSE(is_read(with([](Answer& a) { a.changed = 1U << 8U; }), 1));
  Answer wide;
  wide.changed = 1U << 15U;
  EXPECT_TRUE(read_answers(bytes_of({wide}), 1, 16)) << "R15";
  wide.changed = 1U << 16U;
  EXPECT_FALSE(read_answers(bytes_of({wide}), 1, 16));
}

std::string trace(std::uint32_t claimed, const std::vector<Step>& steps,
                  const std::vector<Access>& accesses) {
  return bytes_of({returned}) + replies::bytes_of_all(std::vector{claimed}) +
         replies::bytes_of_all(steps) + replies::bytes_of_all(accesses);
}

TEST(Replies, FalseTracesAreRefused) {
  const Access access{.step = 1, .address = 0x800000000008, .bytes = 4};
  const auto read = read_trace(trace(2, {{}, {.at = 5}}, {access}), 8);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->trace.steps.at(1).at, 5U);
  EXPECT_EQ(read->trace.accesses.at(0).address, 0x800000000008U);
  EXPECT_FALSE(read_trace("", 8));
  EXPECT_FALSE(read_trace(trace(3, {{}, {}}, {}), 8));
  EXPECT_FALSE(read_trace(trace(0xFFFFFFFF, {{}, {}}, {}), 8));
  EXPECT_FALSE(read_trace(trace(2, {{}, {}}, {access}) + "x", 8));
  EXPECT_FALSE(read_trace(trace(1, {{}}, {access}), 8)) << "an access of no step";
  EXPECT_FALSE(read_trace(trace(1, {{}}, {{.bytes = 65}}), 8)) << "an access of all memory";
  std::string cut = trace(2, {{}, {}}, {access});
  for (; !cut.empty(); cut.pop_back()) {
    if (const auto part = read_trace(cut, 8)) {
      EXPECT_LE(part->trace.steps.size() * sizeof(Step), cut.size());
    }
  }
}

TEST(Replies, AFalseByteIsNoRegister) {
  std::string reply = trace(1, {{.bytes = 0xF1F1F1F1}}, {});
  const std::size_t flag = reply.size() - sizeof(Step) + offsetof(Step, registers) +
                           offsetof(Registers, has_own_segments);
  reply[flag] = static_cast<char>(0x77);
  const auto read = read_trace(reply, 8);
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->trace.steps[0].registers.has_own_segments);
  EXPECT_EQ(read->trace.steps[0].bytes, 15U);
}

class Runners : public testing::Test {
 protected:
  std::vector<Answer> answers(std::size_t cases, Fake::Act act) {
    Runner runner(subject_, [act] { return std::make_unique<Fake>(act); });
    const std::vector<std::uint32_t> words(cases * words_in(subject_.variant), 1);
    auto all = runner.answers(words);
    downfall_ = runner.downfall();
    return all;
  }

  Subject subject_ = replies::subject();
  Downfall downfall_ = Downfall::none;
};

TEST_F(Runners, TakesAnswersOfAllBatches) {
  EXPECT_EQ(answers(10'000, [](std::size_t cases) { return Fake::answers(cases); }).size(),
            10'000U);
  EXPECT_EQ(downfall_, Downfall::none);
}

TEST_F(Runners, ForgedNumbersOfAnswersAreAFault) {
  for (const std::size_t forged : {0U, 1U, 2U, 4U, 5000U, 1'000'000U}) {
    const auto all = answers(3, [forged](std::size_t) { return Fake::answers(forged); });
    ASSERT_EQ(all.size(), 1U) << forged;
    EXPECT_EQ(all[0].ending.end, End::fault);
    EXPECT_EQ(downfall_, Downfall::false_reply);
  }
}

TEST_F(Runners, AForgedCounterLeadsToNoMoreAnswersThanCases) {
  for (const std::uint64_t steps : {std::uint64_t{0}, std::uint64_t{2}, ~std::uint64_t{0}}) {
    const auto all = answers(3, [steps](std::size_t cases) {
      auto said = cases == 3 ? Fake::Said{.downfall = Downfall::crashed} : Fake::answers(cases);
      said.steps = steps;
      return said;
    });
    EXPECT_EQ(all.size(), std::min<std::uint64_t>(steps, 2) + 1);
    EXPECT_EQ(all.back().ending.end, End::fault);
  }
}

}  // namespace
