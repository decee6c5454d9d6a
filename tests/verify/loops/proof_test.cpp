// Tests the proof of one turn of each loop for all register values, and that it rejects mutants.
#include <chrono>

#include "tests/support/test.hpp"
#include "tests/verify/loops/span.hpp"
#include "verify/proof/process.hpp"
#include "verify/proof/solver.hpp"
#include "verify/proof/span_cases.hpp"
#include "verify/proof/step_proof.hpp"
#include "x86model/mutants.hpp"

namespace {

using namespace loops_test;
using fixproof::proof::Satisfiability;
using x86::Counting;
using x86::Loop;
using x86::LoopForm;

const fixproof::proof::Solver& z3() {
  static const fixproof::proof::Solver one("z3");
  return one;
}

/// The answers to several scripts, from one run of the solver.
std::vector<std::string> answers(const std::vector<std::string>& scripts) {
  std::string all;
  for (const std::string& script : scripts) all += script + "(reset)\n";
  constexpr std::chrono::seconds limit{60};
  std::istringstream said(fixproof::proof::run_program({"z3", "-smt2", "-in"}, all, limit).out);
  std::vector<std::string> verdicts;
  for (std::string line; std::getline(said, line);) {
    if (line == "sat" || line == "unsat" || line == "unknown") verdicts.push_back(line);
  }
  EXPECT_EQ(verdicts.size(), scripts.size());
  return verdicts;
}

bool all_unsatisfiable(const std::vector<std::string>& verdicts) {
  return std::all_of(verdicts.begin(), verdicts.end(),
                     [](const std::string& v) { return v == "unsat"; });
}

TEST(LoopProof, EveryTurnIsProven) {
  std::vector<std::string> all;
  for (const LoopForm& form : x86::all_loop_forms()) {
    const auto program = x86::assemble(x86::listing(form), {});
    const auto scripts = fixproof::proof::step_questions(form, program);
    // One question per combination of a counted loop going on or ending, and a pixel being drawn or
    // hidden. One more that these are all cases, and for words one that the count is halved.
    const bool counted = form.counting != Counting::unrolled;
    const std::size_t ways = (counted ? 2U : 1U) * (form.loop == Loop::depth_test ? 2U : 1U);
    const bool halves = counted && form.loop == Loop::gouraud_word;
    EXPECT_EQ(scripts.size(), ways + 1 + (halves ? 1 : 0)) << text(form);
    all.insert(all.end(), scripts.begin(), scripts.end());
  }
  EXPECT_TRUE(all_unsatisfiable(answers(all)));
}

/// Tests that the proof and the spans agree: the proof accepts exactly the mutants that no span
/// kills. This test takes a sample of both; `fixproof mutate` proves all that survive.
TEST(LoopProof, IsOfOneMindWithTheSpans) {
  std::vector<std::string> harmless;
  std::vector<std::vector<std::string>> harmful;
  for (const LoopForm& form : x86::all_loop_forms()) {
    const auto mutants = x86::mutants(x86::assemble(x86::listing(form), {}));
    for (std::size_t i = 0; i < mutants.size(); ++i) {
      if (i % 13 != 3) continue;
      const bool killed =
          fixproof::proof::spans_to_kill(form, mutants[i].program, 1994).has_value();
      if (killed && i % 39 != 3) continue;
      const auto scripts = fixproof::proof::step_questions(form, mutants[i].program);
      if (killed) {
        // The turn does not include how an unrolled loop is entered and where it ends.
        const bool in_turn = form.counting != Counting::unrolled || i > 3;
        if (in_turn) harmful.push_back(scripts);
      } else {
        harmless.insert(harmless.end(), scripts.begin(), scripts.end());
      }
    }
  }
  EXPECT_GT(harmless.size(), 5U);
  EXPECT_TRUE(all_unsatisfiable(answers(harmless)));
  std::vector<std::string> asked;
  for (const auto& scripts : harmful) asked.insert(asked.end(), scripts.begin(), scripts.end());
  const auto verdicts = answers(asked);
  auto next = verdicts.begin();
  for (const auto& scripts : harmful) {
    const auto end = next + static_cast<std::ptrdiff_t>(scripts.size());
    EXPECT_FALSE(all_unsatisfiable({next, end}));
    next = end;
  }
  EXPECT_GT(harmful.size(), 10U);
}

TEST(LoopProof, TheDepthsCommentHoldsForShldAlone) {
  const LoopForm corrected{Loop::depth_test};
  LoopForm printed = corrected;
  printed.as_printed = true;
  EXPECT_EQ(z3().ask(fixproof::proof::depth_comment_question(corrected), 60).verdict,
            Satisfiability::unsatisfiable);
  EXPECT_EQ(z3().ask(fixproof::proof::depth_comment_question(printed), 60).verdict,
            Satisfiability::satisfiable);
}

}  // namespace
