// The proofs: nothing in them is empty, the specification is the oracle's, and a wrong program
// comes back with operands on which it is wrong.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "verify/mutation/kill.hpp"
#include "verify/parties/interpreter.hpp"
#include "verify/parties/parties.hpp"
#include "verify/proof/lemmas.hpp"
#include "verify/proof/prove.hpp"
#include "verify/usage_error.hpp"

namespace {

using namespace fixproof;

const Solver& z3() {
  static const Solver one("z3");
  return one;
}

/// `script` without its last assertion: what it takes for granted.
std::string assumptions(std::string script) {
  const auto last = script.rfind("(assert ");
  const auto end = script.find("(check-sat)", last);
  return script.erase(last, end - last);
}

std::vector<Variant> routines() {
  std::vector<Variant> all;
  for (const Variant& v : all_variants()) {
    if (has_program(v)) all.push_back(v);
  }
  return all;
}

TEST(Proof, LemmasHoldAndTakeNothingImpossibleForGranted) {
  for (const Lemma& lemma : lemmas()) {
    EXPECT_EQ(z3().ask(lemma.smt, 60).verdict, Verdict::unsatisfiable) << lemma.name;
    EXPECT_EQ(z3().ask(assumptions(lemma.smt), 60).verdict, Verdict::satisfiable) << lemma.name;
  }
}

TEST(Proof, EveryRoutineHasAPathThatSomeOperandsTake) {
  for (const Variant& v : routines()) {
    bool taken = false;
    for (const std::string& script : questions(v, program_of(v).instructions())) {
      if (taken) break;
      taken = z3().ask(assumptions(script), 60).verdict == Verdict::satisfiable;
    }
    EXPECT_TRUE(taken) << static_cast<int>(v.operation);
  }
}

TEST(Proof, ProvesTheDivides) {
  for (const Variant& v : routines()) {
    if (v.operation != Operation::div) continue;
    EXPECT_EQ(prove(v, program_of(v), z3(), 120).standing, Standing::proven);
  }
}

// With products and quotients as they are, the specification of given operands is a constant.
TEST(Proof, TheSpecificationIsTheOracles) {
  std::mt19937 random(54);
  const Party& oracle = party_named("oracle");
  for (const Variant& v : routines()) {
    if (v.operation != Operation::mul && v.operation != Operation::div) continue;
    const Specification wanted = specification(v);
    std::string script = fmt::format(
        "(set-logic QF_UFBV)\n{}(declare-const a (_ BitVec 32))\n(declare-const b (_ BitVec "
        "32))\n{}",
        abstractions(Arithmetic::exact), wanted.definitions);
    constexpr int cases = 20;
    for (int i = 0; i < cases; ++i) {
      const std::uint32_t a = static_cast<std::uint32_t>(random()) >> (random() % 32);
      const std::uint32_t b =
          (static_cast<std::uint32_t>(random()) >> (random() % 32)) * (i % 10 == 0 ? 0U : 1U);
      const std::array operands{i % 2 == 0 ? a : 0U - a, i % 3 == 0 ? b : 0U - b};
      const Answer answer = ask(oracle, v, operands);
      const bool faults = answer.ending == Ending::divide_error;
      script += fmt::format(
          "(push 1)\n(assert (and (= a (_ bv{} 32)) (= b (_ bv{} 32))))\n"
          "(assert (not (and (= {} {}) (or {} (= {} (_ bv{} 32))))))\n(check-sat)\n(pop 1)\n",
          operands[0], operands[1], wanted.faults, faults, faults, wanted.words[0],
          faults ? 0 : answer.words[0]);
    }
    const std::string text = z3().ask(script, 120).text;
    std::size_t agreed = 0;
    for (std::size_t at = 0; (at = text.find("unsat\n", at)) != std::string::npos; ++at) ++agreed;
    EXPECT_EQ(agreed, cases) << text;
  }
}

TEST(Proof, AWrongProgramComesBackWithACase) {
  std::size_t disproven = 0;
  for (const Variant& v : routines()) {
    if (v.chapter_52 || v.operation == Operation::cossin || !rounds(v)) continue;
    const auto party = [&](const x86model::Program& p) { return make_interpreter_of("mutant", p); };
    const auto all = mutants_of(v);
    for (std::size_t i = 0; i < all.size(); i += all.size() / 3 + 1) {
      if (!cases_to_kill(v, *party(all[i].program), 1)) continue;
      const Proof proof = prove(v, all[i].program, z3(), 10);
      ASSERT_NE(proof.standing, Standing::proven) << all[i].change;
      if (proof.standing == Standing::open) continue;
      EXPECT_NE(ask(*party(all[i].program), v, proof.counterexample),
                ask(party_named("oracle"), v, proof.counterexample))
          << all[i].change;
      ++disproven;
    }
  }
  EXPECT_GE(disproven, 15U);
}

TEST(Proof, AnAbsentSolverIsNamed) {
  EXPECT_THROW(Solver("yices"), UsageError);
  EXPECT_THROW(static_cast<void>(z3().ask("(assert", 5)), std::runtime_error);
}

}  // namespace
