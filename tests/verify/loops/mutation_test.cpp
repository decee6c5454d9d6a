// Tests that the spans kill every one-instruction mutant of every loop, except for mutants that are
// harmless. proof_test.cpp and `fixproof mutate` prove those harmless.
#include "tests/support/test.hpp"
#include "tests/verify/loops/span.hpp"
#include "verify/proof/span_cases.hpp"
#include "x86model/mutants.hpp"

namespace {

using namespace loops_test;
using x86::Loop;
using x86::LoopForm;

constexpr std::uint64_t seed = 1994;

TEST(LoopMutation, TheListingsThemselvesSurvive) {
  for (const LoopForm& form : x86::all_loop_forms()) {
    EXPECT_EQ(fixproof::proof::spans_to_kill(form, x86::assemble(x86::listing(form), {}), seed),
              std::nullopt)
        << text(form);
  }
}

TEST(LoopMutation, AllAreKilledOrHarmless) {
  std::size_t killed = 0;
  for (const LoopForm& form : x86::all_loop_forms()) {
    for (const auto& mutant : x86::mutants(x86::assemble(x86::listing(form), {}))) {
      if (fixproof::proof::spans_to_kill(form, mutant.program, seed)) {
        ++killed;
      } else {
        // An arithmetic shift equals a logical shift for a count that is not negative.
        const bool idle =
            mutant.change.ends_with(" -> twice") || mutant.change.starts_with("0 shr ");
        EXPECT_TRUE(idle) << text(form) << ": " << mutant.change;
      }
    }
  }
  EXPECT_GT(killed, 900U);
}

}  // namespace
