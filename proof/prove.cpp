#include "proof/prove.hpp"

#include <array>

#include "parties/answer.hpp"
#include "parties/interpreter.hpp"
#include "proof/lost_carry.hpp"
#include "proof/step_proof.hpp"

namespace fixproof::proof {

namespace {

SolverAnswer ask_all(const std::vector<std::string>& scripts, const Solver& solver, int max_seconds,
                     double& seconds) {
  SolverAnswer answer{.verdict = Satisfiability::unsatisfiable};
  for (const std::string& script : scripts) {
    answer = solver.ask(script, max_seconds);
    seconds += answer.seconds;
    if (answer.verdict != Satisfiability::unsatisfiable) break;
  }
  return answer;
}

/// Proves questions without abstract arithmetic, where every counterexample is real.
Proof prove_all(const std::vector<std::string>& scripts, const Solver& solver, int max_seconds) {
  Proof proof;
  proof.questions = scripts.size();
  const SolverAnswer answer = ask_all(scripts, solver, max_seconds, proof.seconds);
  if (answer.verdict == Satisfiability::unsatisfiable) proof.standing = Standing::proven;
  if (answer.verdict == Satisfiability::satisfiable) proof.standing = Standing::disproven;
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
    const SolverAnswer answer = ask_all(scripts, solver, max_seconds, proof.seconds);
    if (answer.verdict == Satisfiability::unsatisfiable) proof.standing = Standing::proven;
    if (answer.verdict != Satisfiability::satisfiable) return proof;
    const auto operands = operands_in(v, answer.text);
    proof.given = parties::ask(*party, v, operands);
    proof.wanted = parties::ask(parties::party_named("oracle"), v, operands);
    if (!parties::agree(std::array{proof.given, proof.wanted})) {
      proof.standing = Standing::disproven;
      proof.counterexample = operands;
      return proof;
    }
  }
  return proof;
}

}  // namespace fixproof::proof
