// The compiled run against the plain interpreter: same outcome, same results, at both widths.
#include "x86model/compiled.hpp"

#include <gtest/gtest.h>

#include "tests/x86model/cases.hpp"
#include "x86model/text.hpp"

namespace {

using namespace x86model;

template <Routine routine, Target target, Build build, int word_bits>
void expect_agreement() {
  const auto words = test::cases(routine);
  const auto in = static_cast<std::size_t>(arity(routine).in);
  const auto out = static_cast<std::size_t>(arity(routine).out);
  const std::size_t cases = words.size() / in;
  std::vector<std::uint32_t> compiled(cases * out);
  std::vector<Outcome> outcomes(cases);
  call_compiled<routine, target, build, word_bits>(words, compiled, outcomes);
  const Program program = assemble(listing(routine, target), build);
  std::array<std::uint32_t, 12> results{};
  const auto stepwise = std::span(results).first(out);
  for (std::size_t i = 0; i < cases; ++i) {
    const Ending ending = call<routine, word_bits>(program.instructions(),
                                                   std::span(words).subspan(i * in, in), stepwise);
    ASSERT_EQ(outcomes[i], ending.outcome) << name_of(routine) << " case " << i;
    if (ending.outcome != Outcome::returned) continue;
    for (std::size_t k = 0; k < out; ++k) {
      ASSERT_EQ(compiled[i * out + k], stepwise[k]) << name_of(routine) << " case " << i;
    }
  }
}

TEST(Compiled, AgreesWithTheInterpreter) {
  test::each_routine([]<Routine routine, Target target>() {
    expect_agreement<routine, target, Build{}, 16>();
    expect_agreement<routine, target, Build{.mul_rounding = false, .div_rounding = false}, 16>();
    if constexpr (routine == Routine::mul || routine == Routine::div) {
      expect_agreement<routine, target, Build{}, 8>();
      expect_agreement<routine, target, Build{.mul_rounding = false, .div_rounding = false}, 8>();
    }
  });
  expect_agreement<Routine::concat, Target::i386, Build{.chapter_52 = true}, 16>();
  expect_agreement<Routine::div, Target::i386, Build{.chapter_52 = true}, 16>();
}

TEST(Compiled, StopsAtAnUndefinedFlagToo) {
  constexpr Build scanned{.div_rounding = false, .endif_as_scanned = true};
  expect_agreement<Routine::div, Target::i8088, scanned, 16>();
  const std::array<std::uint32_t, 2> in{0x18000, 0x28000};
  std::array<std::uint32_t, 1> out{};
  std::array<Outcome, 1> outcome{};
  call_compiled<Routine::div, Target::i8088, scanned, 16>(in, out, outcome);
  EXPECT_EQ(outcome[0], Outcome::undefined_flag);
}

}  // namespace
