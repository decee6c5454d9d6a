// Tests that the proofs are not vacuous, that the specification agrees with the oracle, and that a
// wrong program gets a counterexample.
#include <fmt/format.h>

#include <chrono>
#include <iostream>

#include "support/usage_error.hpp"
#include "tests/support/test.hpp"
#include "verify/parties/answer.hpp"
#include "verify/parties/interpreter.hpp"
#include "verify/parties/parties.hpp"
#include "verify/proof/kill.hpp"
#include "verify/proof/lemmas.hpp"
#include "verify/proof/process.hpp"
#include "verify/proof/prove.hpp"

namespace {

using namespace fixproof;

const proof::Solver& z3() {
  static const proof::Solver one("z3");
  return one;
}

/// What z3 says to a script with several questions.
std::string said_by_z3(const std::string& script) {
  constexpr std::chrono::seconds limit{120};
  return proof::run_program({"z3", "-smt2", "-in"}, script, limit).out;
}

/// `script` without its last assertion, which is its claim.
std::string assumptions(std::string script) {
  const auto last = script.rfind("(assert ");
  const auto end = script.find("(check-sat)", last);
  return script.erase(last, end - last);
}

std::vector<cases::Variant> routines() {
  std::vector<cases::Variant> all;
  for (const cases::Variant& v : cases::all_variants()) {
    if (parties::has_program(v)) all.push_back(v);
  }
  return all;
}

TEST(Proof, LemmasHoldAndTakeNothingImpossibleForGranted) {
  for (const proof::Lemma& lemma : proof::lemmas()) {
    EXPECT_EQ(z3().ask(lemma.smt, 60).verdict, proof::Satisfiability::unsatisfiable) << lemma.name;
    EXPECT_EQ(z3().ask(assumptions(lemma.smt), 60).verdict, proof::Satisfiability::satisfiable)
        << lemma.name;
  }
}

TEST(Proof, QuestionsAskedTogetherAreUnsatisfiableOnlyIfEachIs) {
  const std::string& never = proof::lemmas().front().smt;
  const std::string sometimes = assumptions(never);
  using Scripts = std::vector<std::string>;
  EXPECT_EQ(z3().ask_together(Scripts{never, never, never}, 60).verdict,
            proof::Satisfiability::unsatisfiable);
  for (const Scripts& scripts : {Scripts{never, sometimes, never}, Scripts{never, never, sometimes},
                                 Scripts{never, "(assert", never}}) {
    EXPECT_EQ(z3().ask_together(scripts, 60).verdict, proof::Satisfiability::unknown);
  }
}

TEST(Proof, QuestionsInOneRunHaveTheirOwnAnswers) {
  const std::string& never = proof::lemmas().front().smt;
  const std::string sometimes = assumptions(never);
  const proof::SolverProgram solver("z3");
  const auto answers = solver.ask_in_one_run(std::vector{never, sometimes, never}, 60);
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers[0].verdict, proof::Satisfiability::unsatisfiable);
  EXPECT_EQ(answers[1].verdict, proof::Satisfiability::satisfiable);
  EXPECT_FALSE(answers[1].model.empty());
  EXPECT_EQ(answers[2].verdict, proof::Satisfiability::unsatisfiable);
  EXPECT_TRUE(solver.ask_in_one_run(std::vector<std::string>{never, "(assert", never}, 60).empty());
}

TEST(Proof, AReplyInOneRunThatIsCutHasNoAnswers) {
  const std::vector<std::string> scripts(3, proof::lemmas().front().smt);
  const auto count = [&](const std::string& said) {
    return proof::answers_in({.out = said}, "cvc5", scripts).size();
  };
  const std::string one = "unsat\n\"end of an answer\"\n";
  EXPECT_EQ(count(one + one + one), 3U);
  EXPECT_EQ(count(one + one + "unsat\nend of an answer"), 3U);
  EXPECT_EQ(count(one + one), 0U);
  EXPECT_EQ(count(one + "unsat\n\"end of an answer"), 0U);
  EXPECT_EQ(count(one + one + "unsat\n\"end of an ans"), 0U);
  EXPECT_EQ(count(""), 0U);
  // The next answer is not taken for a missing one.
  EXPECT_THROW(count(one + "end of an answer\n" + one), proof::SolverError);
  EXPECT_THROW(count(one + "unsat end of an answer\n" + one), proof::SolverError);
  const std::string all = one + one + one;
  EXPECT_TRUE(proof::answers_in({.out = all, .status = 1}, "cvc5", scripts).empty());
  EXPECT_TRUE(proof::answers_in({.out = all, .in_time = false}, "cvc5", scripts).empty());
}

std::vector<std::string> answers(const std::vector<std::string>& scripts) {
  std::string all;
  for (const std::string& script : scripts) all += script + "(reset)\n";
  std::istringstream said(said_by_z3(all));
  std::vector<std::string> verdicts;
  for (std::string line; std::getline(said, line);) {
    if (line == "sat" || line == "unsat" || line == "unknown") verdicts.push_back(line);
  }
  return verdicts;
}

// Skips the last question, which consists only of its claim. A path that no operand takes would
// prove anything. The 8088 divides have one such path per sign combination: their second DIV never
// faults, because the upper half of its dividend is the remainder of the first DIV.
TEST(Proof, SomeOperandsTakeEveryPath) {
  for (const cases::Variant& v : routines()) {
    auto scripts = proof::questions(v, parties::program_of(v).instructions());
    scripts.pop_back();
    ASSERT_FALSE(scripts.empty());
    for (std::string& script : scripts) script = assumptions(script);
    const auto said = answers(scripts);
    EXPECT_EQ(said.size(), scripts.size()) << cases::name_of(v);
    const bool divides_twice =
        v.operation == cases::Operation::div && v.build.target == cases::Target::i8088;
    const auto taken = static_cast<std::size_t>(std::count(said.begin(), said.end(), "sat"));
    const auto never = static_cast<std::size_t>(std::count(said.begin(), said.end(), "unsat"));
    EXPECT_EQ(never, divides_twice ? 4U : 0U) << cases::name_of(v);
    EXPECT_EQ(taken + never, scripts.size()) << cases::name_of(v);
  }
}

TEST(Proof, ATransformMustCallTheFixedMulThatIsProven) {
  for (const cases::Operation o : {cases::Operation::xformvec, cases::Operation::concat}) {
    const cases::Variant v{.operation = o, .build = {.target = cases::Target::i8088}};
    cases::Variant unrounded = v;
    unrounded.build.mul_round = false;
    EXPECT_NO_THROW(proof::questions(v, parties::program_of(v).instructions()));
    EXPECT_THROW(proof::questions(v, parties::program_of(unrounded).instructions()),
                 std::logic_error);
    const auto broken = x86model::mutants(parties::program_of(v));
    const std::size_t own = proof::mutants_of(v).size();
    EXPECT_NO_THROW(proof::questions(v, broken.at(own - 1).program.instructions()));
    ASSERT_GT(broken.size(), own + 100);
    for (std::size_t i = own; i < broken.size(); ++i) {
      EXPECT_THROW(proof::questions(v, broken[i].program.instructions()), std::logic_error)
          << broken[i].change;
    }
  }
}

TEST(Proof, ProvesTheDivides) {
  for (const cases::Variant& v : routines()) {
    if (v.operation != cases::Operation::div) continue;
    EXPECT_EQ(proof::prove(v, parties::program_of(v), z3(), 120).standing, proof::Standing::proven);
  }
}

// With exact arithmetic, the specification of constant operands is a constant.
TEST(Proof, TheSpecificationIsTheOracles) {
  std::mt19937 random(54);
  const parties::Party& oracle = parties::party_named("oracle");
  for (const cases::Variant& v : routines()) {
    if (v.operation != cases::Operation::mul && v.operation != cases::Operation::div) continue;
    const proof::Specification wanted = proof::specification(v);
    std::string script = fmt::format(
        "(set-logic QF_UFBV)\n{}(declare-const a (_ BitVec 32))\n(declare-const b (_ BitVec "
        "32))\n{}",
        proof::abstractions(proof::Arithmetic::exact), wanted.definitions);
    constexpr int cases = 20;
    for (int i = 0; i < cases; ++i) {
      const std::uint32_t a = static_cast<std::uint32_t>(random()) >> (random() % 32);
      const std::uint32_t b =
          (static_cast<std::uint32_t>(random()) >> (random() % 32)) * (i % 10 == 0 ? 0U : 1U);
      const std::array operands{i % 2 == 0 ? a : 0U - a, i % 3 == 0 ? b : 0U - b};
      const parties::Answer answer = parties::ask(oracle, v, operands);
      const bool faults = answer.ending == parties::Ending::divide_error;
      script += fmt::format(
          "(push 1)\n(assert (and (= a (_ bv{} 32)) (= b (_ bv{} 32))))\n"
          "(assert (not (and (= {} {}) (or {} (= {} (_ bv{} 32))))))\n(check-sat)\n(pop 1)\n",
          operands[0], operands[1], wanted.faults, faults, faults, wanted.words[0],
          faults ? 0 : answer.words[0]);
    }
    const std::string text = said_by_z3(script);
    std::size_t agreed = 0;
    for (std::size_t at = 0; (at = text.find("unsat\n", at)) != std::string::npos; ++at) ++agreed;
    EXPECT_EQ(agreed, cases) << text;
  }
}

TEST(Proof, AWrongProgramComesBackWithACase) {
  std::size_t disproven = 0;
  for (const cases::Variant& v : routines()) {
    if (v.build.chapter_52 || v.operation == cases::Operation::cossin || !cases::rounds(v))
      continue;
    const auto party = [&](const x86model::Program& p) {
      return parties::make_interpreter_of("mutant", p);
    };
    const auto all = proof::mutants_of(v);
    for (std::size_t i = 0; i < all.size(); i += all.size() / 3 + 1) {
      if (!proof::cases_to_kill(v, *party(all[i].program), 1)) continue;
      const proof::Proof proof = proof::prove(v, all[i].program, z3(), 10);
      ASSERT_NE(proof.standing, proof::Standing::proven) << all[i].change;
      if (proof.standing == proof::Standing::open) continue;
      const std::array answers{
          parties::ask(*party(all[i].program), v, proof.counterexample),
          parties::ask(parties::party_named("oracle"), v, proof.counterexample)};
      EXPECT_FALSE(parties::agree(answers)) << all[i].change;
      ++disproven;
    }
  }
  std::cout << disproven << " disproven\n";
  EXPECT_GE(disproven, 15U);
}

TEST(Proof, AnAbsentSolverIsNamed) {
  EXPECT_THROW(proof::Solver("yices"), support::UsageError);
  EXPECT_THROW(static_cast<void>(z3().ask("(assert", 5)), std::runtime_error);
  EXPECT_THROW(static_cast<void>(z3().ask("(check-sat)(get-model)(pop 1)", 5)), std::runtime_error);
}

}  // namespace
