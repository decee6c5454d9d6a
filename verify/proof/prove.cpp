#include "verify/proof/prove.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "verify/parties/answer.hpp"
#include "verify/parties/interpreter.hpp"
#include "verify/proof/lost_carry.hpp"
#include "verify/proof/step_proof.hpp"

namespace fixproof::proof {

Standing standing_of(Satisfiability verdict) {
  switch (verdict) {
    case Satisfiability::unsatisfiable:
      return Standing::proven;
    case Satisfiability::satisfiable:
      return Standing::disproven;
    case Satisfiability::unknown:
      return Standing::open;
    case Satisfiability::one_sided:
      return Standing::one_sided;
    case Satisfiability::disputed:
      break;
  }
  return Standing::disputed;
}

namespace {

/// Asks all questions together. Unless each is unsatisfiable, asks one after the other until one
/// makes a proof impossible; after one that only one of two solvers decides it goes on.
/// @return the answer that decides about all
SolverAnswer ask_all(const std::vector<std::string>& scripts, const Solver& solver, int max_seconds,
                     Proof& proof) {
  if (scripts.size() > 1) {
    SolverAnswer together = solver.ask_together(scripts, max_seconds);
    proof.seconds += together.seconds;
    if (together.verdict == Satisfiability::unsatisfiable) return together;
  }
  SolverAnswer all{.verdict = Satisfiability::unsatisfiable};
  for (std::size_t i = 0; i < scripts.size(); ++i) {
    SolverAnswer answer = solver.ask(scripts[i], max_seconds);
    proof.seconds += answer.seconds;
    if (!answer.remark.empty()) {
      proof.remarks.push_back(
          fmt::format("question {} of {}: {}", i + 1, scripts.size(), answer.remark));
    }
    if (answer.verdict == Satisfiability::unsatisfiable) continue;
    all = std::move(answer);
    if (all.verdict != Satisfiability::one_sided) break;
  }
  return all;
}

/// Proves questions without abstract arithmetic, where every counterexample is real.
Proof prove_all(const std::vector<std::string>& scripts, const Solver& solver, int max_seconds) {
  Proof proof;
  proof.questions = scripts.size();
  proof.standing = standing_of(ask_all(scripts, solver, max_seconds, proof).verdict);
  return proof;
}

}  // namespace

Proof prove(const x86model::LoopForm& form, const x86model::Program& program, const Solver& solver,
            int max_seconds) {
  return prove_all(step_questions(form, program), solver, max_seconds);
}

Proof prove_lost_carry(bool mul_round, const Solver& solver, int max_seconds) {
  return prove_all(lost_carry_questions(mul_round), solver, max_seconds);
}

Proof prove(const cases::Variant& v, const x86model::Program& program, const Solver& solver,
            int max_seconds) {
  const auto party = parties::make_interpreter_of("program", program);
  Proof proof;
  for (const Arithmetic arithmetic : {Arithmetic::abstract, Arithmetic::exact}) {
    const auto scripts = questions(v, program.instructions(), arithmetic);
    proof.questions += scripts.size();
    const SolverAnswer answer = ask_all(scripts, solver, max_seconds, proof);
    if (answer.verdict != Satisfiability::satisfiable) {
      proof.standing = standing_of(answer.verdict);
      return proof;
    }
    const auto operands = operands_in(v, answer.model);
    proof.given = parties::ask(*party, v, operands);
    proof.wanted = parties::ask(parties::party_named("oracle"), v, operands);
    if (!parties::agree(std::array{proof.given, proof.wanted})) {
      proof.standing = Standing::disproven;
      proof.counterexample = operands;
      return proof;
    }
  }
  proof.remarks.emplace_back("the solver's counterexample does not fail when run");
  return proof;
}

}  // namespace fixproof::proof
