// Tests what a caller of a whole routine relies on besides the result.
#include "x86model/routine.hpp"

#include "oracle/exact.hpp"
#include "tests/support/test.hpp"
#include "tests/x86model/cases.hpp"
#include "x86model/text.hpp"

namespace {

using namespace x86model;

TEST(Routine, NeverReadsAnUndefinedFlagAndAlwaysEnds) {
  test::each_routine([]<Routine routine, Target target>() {
    for (const Build& build : test::builds) {
      const Program program = assemble(listing(routine, target), build);
      const auto words = test::cases(routine);
      const auto in = static_cast<std::size_t>(arity(routine).in);
      std::array<std::uint32_t, 12> out{};
      for (std::size_t i = 0; i + in <= words.size(); i += in) {
        const Ending ending =
            call<routine, 16>(program.instructions(), std::span(words).subspan(i, in),
                              std::span(out).first(static_cast<std::size_t>(arity(routine).out)));
        ASSERT_TRUE(ending.outcome == Outcome::returned ||
                    (routine == Routine::div && ending.outcome == Outcome::divide_error))
            << name_of(routine) << " case " << i / in << " at " << ending.position;
      }
    }
  });
}

/// Runs every case with registers full of `garbage`. Returns all results and the final machine.
template <Routine routine, Target target>
std::vector<std::uint32_t> results_from(std::uint32_t garbage) {
  const Program program = assemble(listing(routine, target), {});
  const auto words = test::cases(routine);
  const auto in = static_cast<std::size_t>(arity(routine).in);
  const auto out = static_cast<std::size_t>(arity(routine).out);
  std::vector<std::uint32_t> results;
  for (std::size_t i = 0; i + in <= words.size(); i += in) {
    CallMachine<routine, 16> m;
    for (std::size_t r = 0; r < register_count; ++r) {
      m.registers.write(static_cast<Register>(r), Size::dword,
                        garbage * static_cast<std::uint32_t>(r + 1));
    }
    enter<routine>(m, std::span(words).subspan(i, in));
    const auto before = m.registers;
    const Ending ending = run(program.instructions(), m);
    if (ending.outcome != Outcome::returned) continue;
    // A C caller relies on BP, SI and DI across a call, and RET pops only the return address.
    for (const Register kept : {Register::bp, Register::si, Register::di}) {
      EXPECT_EQ(m.registers.read(kept, Size::word), before.read(kept, Size::word))
          << name_of(routine);
    }
    EXPECT_EQ(m.registers.read(Register::sp, Size::word),
              before.read(Register::sp, Size::word) + 2);
    results.resize(results.size() + out);
    leave<routine>(m, std::span(results).last(out));
  }
  return results;
}

TEST(Routine, KeepsTheCallersRegistersAndIgnoresTheirContents) {
  test::each_routine([]<Routine routine, Target target>() {
    const auto clean = results_from<routine, target>(0);
    EXPECT_EQ(clean, (results_from<routine, target>(0xFFFFFFFF))) << name_of(routine);
    EXPECT_EQ(clean, (results_from<routine, target>(0xDEADBEEF))) << name_of(routine);
  });
}

TEST(Routine, TheCosineTableIsTheNearestOneAtEveryStepSize) {
  const auto expect_nearest = []<std::size_t steps>() {
    const auto table = make_cosine_table<steps>();
    const auto exact = oracle::cosine_table(static_cast<int>(steps));
    ASSERT_EQ(table.size(), exact.size());
    for (std::size_t i = 0; i < table.size(); ++i)
      EXPECT_EQ(table[i], exact[i]) << steps << ' ' << i;
  };
  expect_nearest.operator()<1>();
  expect_nearest.operator()<4>();
  expect_nearest.operator()<10>();
  expect_nearest.operator()<16>();
}

TEST(Routine, NoAngleReadsOutsideTheTable) {
  // Memory ends with the table, so any address behind it ends the run with bad_address. A read
  // before the table changes the result, which is compared for every angle.
  for (const Target target : {Target::i386, Target::i8088}) {
    const Program program = assemble(listing(Routine::cossin, target), {});
    CallMachine<Routine::cossin, 16> m;
    for (std::uint32_t angle = 0; angle < 0x10000; ++angle) {
      enter<Routine::cossin>(m, std::span(&angle, 1));
      ASSERT_EQ(run(program.instructions(), m).outcome, Outcome::returned) << angle;
      std::array<std::uint32_t, 2> out{};
      leave<Routine::cossin>(m, out);
      const auto expected =
          oracle::cos_sin(static_cast<std::int16_t>(static_cast<std::uint16_t>(angle)));
      ASSERT_EQ(out[0], expected.cos) << angle;
      ASSERT_EQ(out[1], expected.sin) << angle;
    }
  }
}

}  // namespace
