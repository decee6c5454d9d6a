// Traced calls share a process, and find the memory that the first one found.
#include <fstream>
#include <iterator>

#include "judge/code/frame.hpp"
#include "judge/code/load.hpp"
#include "judge/code/runner.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace tracer_test {

namespace {

using namespace fixproof;

/// A multiply of EAX and EBX, in 32-bit code.
judge::Subject subject_of(const std::string& code) {
  const ScratchFolder folder;
  const judge::Image image = judge::load(folder.write("code.asm", "bits 32\n" + code), {});
  const cases::Variant product{};
  return {image, judge::frame_for(image, "eax, ebx -> eax", product), product};
}

/// Expects that each of three calls returns `result` in EAX, in as many steps.
void expect_always(std::uint32_t result, const std::string& code) {
  const judge::Subject subject = subject_of(code);
  judge::Tracer tracer(subject);
  std::size_t steps = 0;
  for (int i = 0; i < 3; ++i) {
    const auto call = tracer.call(std::vector<std::uint32_t>{7, 9});
    ASSERT_TRUE(call) << code;
    EXPECT_EQ(call->answer.ending.end, judge::End::returned) << code;
    EXPECT_EQ(call->answer.words.front(), result) << code << i;
    EXPECT_TRUE(i == 0 || call->trace.steps.size() == steps) << code << i;
    steps = call->trace.steps.size();
  }
}

const std::string counts = "inc dword [count]\nmov eax, [count]\nret\n";

TEST(Tracer, AVariableIsAsInTheFirstCall) {
  expect_always(6, counts + "times 8192 nop\ncount: dd 5\n");
  // In the page of the code.
  expect_always(6, counts + "count: dd 5\n");
}

TEST(Tracer, TheStackIsAsInTheFirstCall) {
  expect_always(0xF4F4F4F4, "mov eax, [esp-64]\nmov dword [esp-64], 5\nret\n");
}

TEST(Tracer, ACallThatChangesItsCodeChangesItForNoOther) {
  const judge::Subject subject =
      subject_of("test eax, eax\njz code\ninc byte [code+1]\ncode: mov eax, 1\nret\n");
  judge::Tracer tracer(subject);
  for (const std::uint32_t eax : {1U, 0U, 1U}) {
    const auto call = tracer.call(std::vector<std::uint32_t>{eax, 9});
    ASSERT_TRUE(call);
    EXPECT_EQ(call->answer.words.front(), 1 + eax);
  }
}

TEST(Tracer, ACallThatFaultsIsFollowedByOthers) {
  const std::string good = "test eax, eax\njz .zero\nmov eax, 3\nret\n.zero: ";
  for (const auto& [code, end] :
       {std::pair{"mov [0xF0000000], eax\nret\n", judge::End::bad_address},
        std::pair{"div eax\nret\n", judge::End::divide_error}}) {
    const judge::Subject subject = subject_of(good + code);
    judge::Tracer tracer(subject);
    for (const std::uint32_t eax : {1U, 0U, 1U}) {
      const auto call = tracer.call(std::vector<std::uint32_t>{eax, 9});
      ASSERT_TRUE(call);
      EXPECT_EQ(call->answer.ending.end, eax == 0 ? end : judge::End::returned) << code;
    }
  }
}

std::vector<int> children() {
  std::ifstream list("/proc/thread-self/children");
  return {std::istream_iterator<int>(list), {}};
}

TEST(Tracer, CallsShareAProcessUntilOneCannotBeUndone) {
  const judge::Subject subject = subject_of(
      "push ebx\npop ebx\ntest eax, eax\njz code\ninc byte [code+1]\ncode: mov eax, 1\nret\n");
  judge::Tracer tracer(subject);
  ASSERT_TRUE(tracer.call(std::vector<std::uint32_t>{0, 9}));
  const std::vector<int> first = children();
  EXPECT_EQ(first.size(), 1U);
  ASSERT_TRUE(tracer.call(std::vector<std::uint32_t>{0, 9}));
  EXPECT_EQ(children(), first);
  ASSERT_TRUE(tracer.call(std::vector<std::uint32_t>{1, 9}));
  EXPECT_TRUE(children().empty());
}

}  // namespace

}  // namespace tracer_test
