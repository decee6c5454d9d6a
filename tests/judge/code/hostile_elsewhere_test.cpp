// Hostile routines of processors other than x86 have a clear end each, and what a caller does not
// set is noise.
#include "tests/judge/code/hostile_elsewhere.hpp"

#include <map>
#include <set>

#include "judge/code/caller.hpp"
#include "judge/code/load.hpp"
#include "tests/judge/code/judged.hpp"
#include "tests/judge/code/other_processors.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using hostile_elsewhere::Routine;
using other_processors::Code;

/// DirectCalls a routine in this process, which is far cheaper than a verdict.
class DirectCalls {
 public:
  DirectCalls(const Code& code, const Routine& routine)
      : subject_{.image = judge::load_bytes("f.elf", other_processors::linked(code, routine.bytes),
                                            {.symbol = "f"}),
                 .frame = {},
                 .variant = variant()} {
    subject_.frame = judge::frame_for(subject_.image, "c", subject_.variant);
    caller_ = judge::make_caller(subject_, judge::On::unicorn, nullptr);
  }

  judge::Answer answer(std::uint64_t number) {
    const std::array<std::uint32_t, 2> words{2, 3};
    return caller_->answer(words, number);
  }
  [[nodiscard]] std::uint64_t bit_of(std::string_view name) const {
    const judge::RegisterFile file(*subject_.image.architecture);
    return judge::RegisterMask{1} << file.find(name).value();
  }

 private:
  static cases::Variant variant() {
    cases::Variant variant;
    variant.operation = cases::Operation::mul;
    return variant;
  }

  judge::Subject subject_;
  std::unique_ptr<judge::Caller> caller_;
};

void expect_said(const Code& code, const Routine& routine) {
  const ScratchFolder folder;
  const auto run =
      judged::judge(folder.write("f.elf", other_processors::linked(code, routine.bytes)),
                    "--as|mul|--cases|100|--rounding|half-up");
  EXPECT_EQ(run.err, "");
  judged::expect(run, 1, {std::string(routine.verdict)});
}

/// Its parameter is the number of a processor in other_processors::all.
class HostileElsewhere : public testing::TestWithParam<std::size_t> {};

TEST_P(HostileElsewhere, EveryRoutineIsNamed) {
  const Code& code = other_processors::all.at(GetParam());
  if (!other_processors::is_present(code)) GTEST_SKIP() << code.name << " has no emulator here";
  constexpr std::string_view breaks = "breaks ";
  std::size_t routines = 0;
  for (const Routine& routine : hostile_elsewhere::all) {
    if (&other_processors::processor(routine.processor) != &code) continue;
    ++routines;
    SCOPED_TRACE(std::string(routine.processor) + " " + std::string(routine.does));
    if (routine.verdict == "is noise") {
      std::set<std::uint32_t> results;
      DirectCalls calls(code, routine);
      for (std::uint64_t i = 0; i < 16; ++i) results.insert(calls.answer(i).words[0]);
      EXPECT_GT(results.size(), 2U);
    } else if (routine.verdict.starts_with(breaks)) {
      DirectCalls calls(code, routine);
      EXPECT_EQ(calls.answer(0).broken, calls.bit_of(routine.verdict.substr(breaks.size())));
    } else {
      expect_said(code, routine);
    }
  }
  EXPECT_GE(routines, 8U) << code.name;
}

TEST(HostileAvr, RandomCodeStaysInItsMemory) {
  const Code& code = other_processors::processor("AVR");
  if (!other_processors::is_present(code)) GTEST_SKIP() << "simavr is not installed";
  constexpr std::size_t words = 24;
  const judge::Image image = judge::load_bytes(
      "f.elf", other_processors::linked(code, std::string(4 * words, '0')), {.symbol = "f"});
  judge::Trace trace;  // with one, a call ends after fewer steps
  const auto machine = judge::make_simavr(image, &trace);
  const std::span<std::uint8_t> before(machine->memory(), image.first);
  const std::span<std::uint8_t> at(machine->memory() + image.first, 2 * words);
  std::map<judge::End, int> ends;
  for (std::uint64_t number = 0; number < 3000; ++number) {
    cases::Draw draw(1994, number);
    std::ranges::generate(at, [&] { return static_cast<std::uint8_t>(draw.bits()); });
    const std::vector<std::uint8_t> kept(at.begin(), at.end());
    judge::Registers registers;
    for (std::uint64_t& r : registers.general) r = draw.bits() & 0xFFU;
    registers.general[32] = draw.bits() & 0xFFFFU;  // SP
    registers.flags = static_cast<std::uint32_t>(draw.bits());
    trace = {};
    ++ends[machine->call(registers).end];
    ASSERT_TRUE(std::ranges::equal(at, kept)) << number;
    ASSERT_TRUE(std::ranges::all_of(before, [](std::uint8_t b) { return b == 0; })) << number;
  }
  // Most routines end in another way than by returning, and in each way that there is.
  for (const judge::End end : {judge::End::bad_instruction, judge::End::bad_address,
                               judge::End::port, judge::End::endless}) {
    EXPECT_GT(ends[end], 0) << static_cast<int>(end);
  }
}

INSTANTIATE_TEST_SUITE_P(Processors, HostileElsewhere,
                         testing::Range(std::size_t{0}, other_processors::all.size()));

}  // namespace
