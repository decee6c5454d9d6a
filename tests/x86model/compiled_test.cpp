// Tests that the compiled run and the plain interpreter give the same outcome and results at both
// widths.
#include "x86model/compiled.hpp"

#include "tests/support/test.hpp"
#include "tests/x86model/cases.hpp"
#include "verify/parties/parties.hpp"

namespace {

using namespace x86model;

/// Uses the programs that the party `model` compiles, because compiling takes a minute.
void expect_agreement(const fixproof::cases::Variant& variant) {
  const auto words = test::cases(static_cast<Routine>(variant.operation));
  const std::size_t in = fixproof::cases::words_in(variant.operation);
  const std::size_t out = fixproof::cases::words_out(variant.operation);
  const std::size_t cases = words.size() / in;
  std::vector<std::uint32_t> operands = words;
  if (variant.format == fixproof::cases::q8_8) {
    for (std::uint32_t& word : operands) word = (word ^ word >> 16U) & 0xFFFFU;
  }
  const auto answers = [&](const char* party) {
    std::vector<std::uint32_t> results(cases * out);
    std::vector<fixproof::parties::Ending> endings(cases);
    fixproof::parties::party_named(party).answer(variant, {operands, results, endings});
    return std::pair(results, endings);
  };
  const auto [compiled, compiled_ends] = answers("model");
  const auto [stepwise, stepwise_ends] = answers("interpreter");
  for (std::size_t i = 0; i < cases; ++i) {
    ASSERT_EQ(compiled_ends[i], stepwise_ends[i])
        << fixproof::cases::name_of(variant.operation) << " case " << i;
    if (compiled_ends[i] != fixproof::parties::Ending::value) continue;
    for (std::size_t k = 0; k < out; ++k) {
      ASSERT_EQ(compiled[i * out + k], stepwise[i * out + k])
          << fixproof::cases::name_of(variant.operation) << " case " << i;
    }
  }
}

static_assert(static_cast<int>(Routine::concat) ==
                      static_cast<int>(fixproof::cases::Operation::concat) &&
                  static_cast<int>(Routine::mul) ==
                      static_cast<int>(fixproof::cases::Operation::mul),
              "routines are the first operations, in the same order");

TEST(Compiled, AgreesWithTheInterpreter) {
  int programs = 0;
  for (fixproof::cases::Variant variant : fixproof::cases::all_variants()) {
    for (const auto& format : {fixproof::cases::q16_16, fixproof::cases::q8_8}) {
      variant.format = format;
      if (!fixproof::parties::has_program(variant)) continue;
      expect_agreement(variant);
      ++programs;
    }
  }
  EXPECT_GE(programs, 33);
}

TEST(Compiled, StopsAtAnUndefinedFlagToo) {
  constexpr Build scanned{.div_rounding = false, .endif_as_scanned = true};
  const std::array<std::uint32_t, 2> in{0x18000, 0x28000};
  std::array<std::uint32_t, 1> out{};
  std::array<Outcome, 1> outcome{};
  call_compiled<Routine::div, Target::i8088, scanned, 16>(in, out, outcome);
  EXPECT_EQ(outcome[0], Outcome::undefined_flag);
  const Program program = assemble(listing(Routine::div, Target::i8088), scanned);
  EXPECT_EQ((call<Routine::div, 16>(program.instructions(), in, out).outcome), outcome[0]);
}

}  // namespace
