/// @file
/// Proves a routine or finds a counterexample.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "verify/cases/variant.hpp"
#include "verify/engine.hpp"
#include "verify/parties/answer.hpp"
#include "verify/proof/query.hpp"
#include "verify/proof/solver.hpp"
#include "x86model/loop.hpp"

namespace fixproof::proof {

enum class Standing {
  proven,     ///< for all operands
  disproven,  ///< the program fails when run on the counterexample
  open,       ///< no solver decides, or the counterexample does not fail when run
  one_sided,  ///< one of two solvers proves it, the other does not decide
  disputed,   ///< two solvers contradict each other
};

/// For a question whose every counterexample is real.
Standing standing_of(Satisfiability verdict);

struct Proof {
  Standing standing = Standing::open;
  std::size_t questions = 0;  ///< the number of questions for the solver
  double seconds = 0;
  std::vector<std::string> remarks{};  ///< one for each question that is not decided, and why
  std::vector<std::uint32_t> counterexample{};  ///< operands; empty unless disproven
  parties::Answer given{};                      ///< the program's answer to the counterexample
  parties::Answer wanted{};                     ///< the oracle's answer to it
};

/// Proves that `program` does one turn of an inner loop: see step_questions(). Only memory is
/// abstract, so a disproven turn fails for some registers, which are not recorded. `max_seconds`
/// limits each question. @throws as Solver::ask()
Proof prove(const x86model::LoopForm& form, const x86model::Program& program, const Solver& solver,
            int max_seconds);

/// See lost_carry_questions(). `max_seconds` limits each question. @throws as Solver::ask()
Proof prove_lost_carry(bool mul_round, const Solver& solver, int max_seconds);

/// Proves that `program` does what the routine of `variant` should. Products and quotients are
/// abstract at first, and exact in a second attempt after a spurious counterexample. `max_seconds`
/// limits each question. @throws as Solver::ask()
Proof prove(const cases::Variant& variant, const x86model::Program& program, const Solver& solver,
            int max_seconds);

}  // namespace fixproof::proof
