// Tests the parties that run machine code: they agree with the model, they detect one wrong byte,
// and faults in several threads do not interfere.
#include <cstdlib>
#include <new>
#include <optional>
#include <thread>

#include "tests/support/test.hpp"
#include "verify/cases/streams.hpp"
#include "verify/engine.hpp"
#include "verify/machine_code/machine_code.hpp"
#include "verify/parties/answer.hpp"
#include "verify/parties/machines.hpp"

namespace {

/// The number of allocations of this thread that still succeed; none: all do.
thread_local std::optional<int> allocations;

}  // namespace

// NOLINTBEGIN(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory): this is the allocator
// Not inlined, because g++ would see free() called for a result of new, and warn.
[[gnu::noinline]] void* operator new(std::size_t size) {
  const bool fails = allocations && --*allocations < 0;
  void* const memory = fails ? nullptr : std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t /*size*/) noexcept {
  std::free(memory);
}
// NOLINTEND(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory)

namespace {

using namespace fixproof;

const parties::Party& find(std::string_view name) {
  for (const auto& party : parties::parties()) {
    if (party->name() == name) return *party;
  }
  throw std::invalid_argument(std::string(name));
}

struct Cases {
  explicit Cases(const cases::Variant& v) : variant(v) {}

  void add(cases::Stream stream, std::uint64_t first, std::size_t cases) {
    const std::size_t in = cases::words_in(variant.operation);
    words.resize(words.size() + cases * in);
    cases::make_cases(stream, variant, 54, first, std::span(words).last(cases * in));
  }
  [[nodiscard]] std::size_t size() const {
    return words.size() / cases::words_in(variant.operation);
  }

  cases::Variant variant;
  std::vector<std::uint32_t> words;
};

/// A party's answers to all cases. The result words of a case that faults are 0.
struct Answers {
  std::vector<std::uint32_t> out;
  std::vector<parties::Ending> endings;

  friend bool operator==(const Answers&, const Answers&) = default;
};

template <class Answer>
Answers answers_of(const Cases& cases, Answer answer) {
  const std::size_t each = cases::words_out(cases.variant.operation);
  Answers said{std::vector<std::uint32_t>(cases.size() * each),
               std::vector<parties::Ending>(cases.size(), parties::Ending::broken)};
  answer(parties::Cases{cases.words, said.out, said.endings});
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (said.endings[i] == parties::Ending::value) continue;
    std::fill_n(said.out.begin() + static_cast<std::ptrdiff_t>(i * each), each, 0);
  }
  return said;
}

Answers answers_of(const Cases& cases, const parties::Party& party) {
  return answers_of(cases,
                    [&](const parties::Cases& asked) { party.answer(cases.variant, asked); });
}

Cases cases_for(const cases::Variant& v) {
  Cases cases(v);
  switch (v.operation) {
    case cases::Operation::mul:
    case cases::Operation::div:
      for (std::uint64_t i = 0; i < *cases::size_of(cases::Stream::lattice, v); i += 5) {
        cases.add(cases::Stream::lattice, i, 1);
      }
      cases.add(cases::Stream::uniform, 0, 1000);
      cases.add(cases::Stream::scaled, 0, 1000);
      break;
    case cases::Operation::cossin:
      cases.add(cases::Stream::every, 0, 0x10000);
      break;
    default:
      cases.add(cases::Stream::lattice_words, 0, 500);
      cases.add(cases::Stream::scaled, 0, 500);
      break;
  }
  return cases;
}

using AnswerByCode = void (*)(std::span<const std::uint8_t>, x86model::Routine,
                              const parties::Cases&);

struct Machine {
  const char* name;
  AnswerByCode answer;
};

class MachineParty : public testing::TestWithParam<Machine> {
 protected:
  void SetUp() override {
    const std::string absence = find(GetParam().name).absence();
    if (!absence.empty()) GTEST_SKIP() << absence;
  }
};

TEST_P(MachineParty, AgreesWithTheModelOnEveryProgram) {
  const parties::Party& machine = find(GetParam().name);
  int variants = 0;
  for (const cases::Variant& v : cases::all_variants()) {
    if (!find("model").answers(v)) continue;
    ASSERT_TRUE(machine.answers(v)) << cases::name_of(v);
    const Cases cases = cases_for(v);
    EXPECT_EQ(answers_of(cases, machine), answers_of(cases, find("model"))) << cases::name_of(v);
    ++variants;
  }
  EXPECT_EQ(variants, 25);
}

TEST_P(MachineParty, SaysWhichMachineItIs) {
  const std::string identity = parties::party_named(GetParam().name).identity();
  if (identity != parties::processor_name()) {
    EXPECT_EQ(identity.find("Unicorn 2."), 0U) << identity;
  }
  EXPECT_EQ(identity == parties::processor_name(), std::string(GetParam().name) == "silicon");
}

TEST_P(MachineParty, HasNothingToSayOfTheRest) {
  const parties::Party& machine = find(GetParam().name);
  EXPECT_FALSE(machine.answers({.operation = cases::Operation::mul, .format = cases::q8_8}));
  EXPECT_FALSE(machine.answers(
      {.operation = cases::Operation::mul, .build = {.target = cases::Target::standard}}));
  EXPECT_FALSE(machine.answers({.operation = cases::Operation::sqrt}));
  EXPECT_FALSE(machine.answers(
      {.operation = cases::Operation::mul, .build = {.mul_round = false, .chapter_52 = true}}));
  EXPECT_FALSE(
      machine.answers({.operation = cases::Operation::xformvec, .build = {.chapter_52 = true}}));
  EXPECT_FALSE(
      machine.answers({.operation = cases::Operation::concat, .build = {.repaired = true}}));
  EXPECT_FALSE(machine.answers({.operation = cases::Operation::xformvec,
                                .build = {.target = cases::Target::i8088, .repaired = true}}));
}

TEST_P(MachineParty, IsWrongWhereOneByteIs) {
  const cases::Variant v{.operation = cases::Operation::mul};
  const Cases cases = cases_for(v);
  const auto right = machine_code::machine_code(machine_code::key_of(v));
  std::vector<std::uint8_t> code(right.begin(), right.end());
  const auto say = [&] {
    return answers_of(cases, [&](const parties::Cases& asked) {
      GetParam().answer(code, x86model::Routine::mul, asked);
    });
  };
  const Answers model = answers_of(cases, find("model"));
  EXPECT_EQ(say(), model);

  // Changes 80h in the constant of ADD EAX,8000h to 7Fh.
  const std::array<std::uint8_t, 6> add{0x66, 0x05, 0x00, 0x80, 0x00, 0x00};
  const auto found = std::search(code.begin(), code.end(), add.begin(), add.end());
  ASSERT_NE(found, code.end());
  found[3] = 0x7F;
  EXPECT_NE(say(), model);
  found[3] = 0x80;
  EXPECT_EQ(say(), model);
}

TEST_P(MachineParty, SeesThatARoutineDoesNotKeepRegisters) {
  const Cases cases = [] {
    Cases some({.operation = cases::Operation::mul});
    some.add(cases::Stream::uniform, 0, 10);
    return some;
  }();
  // XOR SI,SI and RET, then the same for BP and DI.
  for (const std::uint8_t registers : std::array<std::uint8_t, 3>{0xF6, 0xED, 0xFF}) {
    const std::array<std::uint8_t, 3> code{0x31, registers, 0xC3};
    const Answers said = answers_of(cases, [&](const parties::Cases& asked) {
      GetParam().answer(code, x86model::Routine::mul, asked);
    });
    EXPECT_EQ(std::count(said.endings.begin(), said.endings.end(), parties::Ending::broken), 10);
  }
  // XOR ESI,10000h and RET, then the same for EBP and EDI: only the upper half is lost.
  for (const std::uint8_t registers : std::array<std::uint8_t, 3>{0xF6, 0xF5, 0xF7}) {
    const std::array<std::uint8_t, 8> code{0x66, 0x81, registers, 0x00, 0x00, 0x01, 0x00, 0xC3};
    const Answers said = answers_of(cases, [&](const parties::Cases& asked) {
      GetParam().answer(code, x86model::Routine::mul, asked);
    });
    EXPECT_EQ(std::count(said.endings.begin(), said.endings.end(), parties::Ending::broken), 10);
  }
  // RET 2: dropping the arguments is the caller's task.
  const std::array<std::uint8_t, 3> ret_2{0xC2, 0x02, 0x00};
  const Answers said = answers_of(cases, [&](const parties::Cases& asked) {
    GetParam().answer(ret_2, x86model::Routine::mul, asked);
  });
  EXPECT_EQ(std::count(said.endings.begin(), said.endings.end(), parties::Ending::broken), 10);
}

TEST_P(MachineParty, SeesThatARoutineDoesNotWriteItsResults) {
  // RET alone. Leftover memory must not count as an answer, even if it is right by chance: the
  // answer to the previous case, or zeros.
  const std::array<std::uint8_t, 1> code{0xC3};
  for (const cases::Operation operation :
       {cases::Operation::cossin, cases::Operation::xformvec, cases::Operation::concat}) {
    const cases::Variant v{.operation = operation};
    Cases zeros(v);
    zeros.words.resize(10 * cases::words_in(operation));
    const Answers right = answers_of(zeros, find(GetParam().name));
    const Answers said = answers_of(zeros, [&](const parties::Cases& asked) {
      GetParam().answer(code, machine_code::key_of(v).routine, asked);
    });
    for (std::size_t i = 0; i < said.out.size(); ++i) {
      ASSERT_EQ(said.endings[i / cases::words_out(operation)], parties::Ending::value);
      ASSERT_NE(said.out[i], right.out[i]) << cases::name_of(v) << ", word " << i;
    }
  }
}

TEST_P(MachineParty, EndsInAFaultForCodeThatIsNone) {
  Cases cases({.operation = cases::Operation::mul});
  cases.add(cases::Stream::uniform, 0, 10);
  // UD2.
  const std::array<std::uint8_t, 2> undefined{0x0F, 0x0B};
  const Answers said = answers_of(cases, [&](const parties::Cases& asked) {
    GetParam().answer(undefined, x86model::Routine::mul, asked);
  });
  EXPECT_EQ(std::count(said.endings.begin(), said.endings.end(), parties::Ending::broken), 10);
  // The fault must not affect later calls.
  EXPECT_EQ(answers_of(cases, find(GetParam().name)), answers_of(cases, find("model")));
}

TEST_P(MachineParty, FaultsInManyThreadsAtOnce) {
  // More than half of these cases fault.
  Cases cases({.operation = cases::Operation::div, .build = {.target = cases::Target::i8088}});
  cases.add(cases::Stream::small_divisors, 0, 2000);
  cases.add(cases::Stream::fault_edge, 0, 2000);
  const Answers model = answers_of(cases, find("model"));
  ASSERT_GT(std::count(model.endings.begin(), model.endings.end(), parties::Ending::divide_error),
            2000);
  ASSERT_GT(std::count(model.endings.begin(), model.endings.end(), parties::Ending::value), 500);

  std::array<int, 8> right{};
  constexpr int rounds = 4;
  {
    std::vector<std::thread> threads;
    threads.reserve(right.size());
    for (int& count : right) {
      threads.emplace_back([&] {
        for (int i = 0; i < rounds; ++i) {
          count += answers_of(cases, find(GetParam().name)) == model ? 1 : 0;
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
  }
  for (const int count : right) EXPECT_EQ(count, rounds);
}

INSTANTIATE_TEST_SUITE_P(On, MachineParty,
                         testing::Values(Machine{"silicon", parties::answer_on_silicon},
                                         Machine{"unicorn", parties::answer_on_unicorn}),
                         [](const auto& test) { return test.param.name; });

/// Whichever allocation fails as other code is loaded, the code before it still answers as before.
TEST(Unicorn, RunsTheRightCodeAfterALackOfMemory) {
  const parties::Party& unicorn = find("unicorn");
  if (!unicorn.absence().empty()) GTEST_SKIP() << unicorn.absence();
  Cases small({.operation = cases::Operation::mul});
  Cases large({.operation = cases::Operation::cossin});
  for (Cases* both : {&small, &large}) both->add(cases::Stream::uniform, 0, 1);
  const auto other = machine_code::machine_code(machine_code::key_of(large.variant));
  ASSERT_GT(other.size(), machine_code::machine_code(machine_code::key_of(small.variant)).size());
  const Answers right = answers_of(small, unicorn);
  bool failed = true;
  for (int enough = 0; failed && enough < 100; ++enough) {
    // In a new thread nothing is loaded, and the list of loaded code has no memory yet.
    std::thread([&] {
      EXPECT_EQ(answers_of(small, unicorn), right);
      Answers said{std::vector<std::uint32_t>(2), std::vector<parties::Ending>(1)};
      failed = false;
      allocations = enough;
      try {
        parties::answer_on_unicorn(other, x86model::Routine::cossin,
                                   {large.words, said.out, said.endings});
      } catch (const std::bad_alloc&) {
        failed = true;
      }
      allocations.reset();
      EXPECT_EQ(answers_of(small, unicorn), right) << enough;
    }).join();
  }
  EXPECT_FALSE(failed);
}

}  // namespace
