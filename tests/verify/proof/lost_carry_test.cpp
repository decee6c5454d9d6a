// Tests the proof of the lost carry, and that it fails for wrong statements and programs.
#include "verify/proof/lost_carry.hpp"

#include "tests/support/test.hpp"
#include "verify/parties/interpreter.hpp"
#include "verify/proof/prove.hpp"

namespace {

using namespace fixproof;

const proof::Solver& solver() {
  static const proof::Solver one("z3");
  return one;
}

x86model::Program concat(bool repaired) {
  return parties::program_of({.operation = cases::Operation::concat,
                              .build = {.target = cases::Target::i8088, .repaired = repaired}});
}

/// The number of unsatisfiable scripts after replacing every `from` by `to`.
std::size_t proven(std::vector<std::string> scripts, std::string_view from = "",
                   std::string_view to = "") {
  std::size_t count = 0;
  for (std::string& script : scripts) {
    for (std::size_t at = 0; !from.empty() && (at = script.find(from, at)) != std::string::npos;
         at += to.size()) {
      script.replace(at, from.size(), to);
    }
    const proof::Satisfiability verdict = solver().ask(script, 60).verdict;
    EXPECT_NE(verdict, proof::Satisfiability::unknown);
    if (verdict == proof::Satisfiability::unsatisfiable) ++count;
  }
  return count;
}

TEST(LostCarry, IsProvenWithRoundingAndWithout) {
  for (const bool mul_round : {true, false}) {
    EXPECT_EQ(proof::lost_carry_questions(mul_round).size(), 5U);
    EXPECT_EQ(proof::prove_lost_carry(mul_round, solver(), 60).standing, proof::Standing::proven);
  }
}

// Three scripts are about the rows, one about other columns, one about the difference.
TEST(LostCarry, AnotherStatementIsRefuted) {
  const auto scripts = proof::lost_carry_questions(true);
  EXPECT_EQ(proven(scripts), 5U);
  // A wrong difference.
  EXPECT_EQ(proven(scripts, "(_ bv65536 32)", "(_ bv65535 32)"), 4U);
  EXPECT_EQ(proven(scripts, "(_ bv65536 32)", "(_ bv4294901760 32)"), 4U);
  // A wrong carry condition, and a wrong bit of the sum.
  EXPECT_EQ(proven(scripts, "low-words) #b1)", "low-words) #b0)"), 4U);
  EXPECT_EQ(proven(scripts, "((_ extract 16 16) low-words)", "((_ extract 15 15) low-words)"), 4U);
}

TEST(LostCarry, AnotherProgramIsRefuted) {
  EXPECT_EQ(proven(proof::lost_carry_between(concat(false), concat(true))), 5U);
  EXPECT_EQ(proven(proof::lost_carry_between(concat(true), concat(true))), 2U);
  EXPECT_EQ(proven(proof::lost_carry_between(concat(false), concat(false))), 2U);
  EXPECT_EQ(proven(proof::lost_carry_between(concat(true), concat(false))), 2U);
}

// Contradictory definitions would prove anything.
TEST(LostCarry, TakesNothingImpossibleForGranted) {
  for (std::string script : proof::lost_carry_questions(true)) {
    const auto last = script.rfind("(assert ");
    script.erase(last, script.find("(check-sat)", last) - last);
    EXPECT_EQ(solver().ask(script, 60).verdict, proof::Satisfiability::satisfiable);
  }
}

}  // namespace
