/// @file
/// A routine proven, or a case on which it fails.
#pragma once

#include <cstdint>
#include <vector>

#include "cases/variant.hpp"
#include "parties/answer.hpp"
#include "proof/query.hpp"
#include "proof/solver.hpp"
#include "verify/engine.hpp"
#include "x86model/loop.hpp"

namespace fixproof::proof {

enum class Standing {
  proven,     ///< for all operands
  disproven,  ///< by a counterexample that has been run
  open,       ///< the solver came to no end in its time, or to a case that shows nothing when run
};

struct Proof {
  Standing standing = Standing::open;
  std::size_t questions = 0;  ///< that there are for the solver
  double seconds = 0;
  std::vector<std::uint32_t> counterexample;  ///< operands; only where disproven
  parties::Answer given;                      ///< what the program answers to them
  parties::Answer wanted;                     ///< what the oracle does
};

/// Proves one turn of an inner loop, `program` in its place: see step_questions(). Nothing in it is
/// abstract but memory: a turn that is disproven goes wrong with some registers, which are not
/// kept. Each question may take `most_seconds`. @throws what Solver::ask does
Proof prove(const x86model::LoopForm& form, const x86model::Program& program, const Solver& solver,
            int most_seconds);

/// Proves where the printed 8088 ConcatXforms, with rounding or without, differs from the repaired
/// one: see lost_carry_questions(). Each question may take `most_seconds`. @throws what Solver::ask
/// does
Proof prove_lost_carry(bool mul_round, const Solver& solver, int most_seconds);

/// The questions of that proof.
std::vector<std::string> lost_carry_questions(bool mul_round);

/// Proves `program` in the place of the routine of `variant`: with products and quotients abstract,
/// and, where that gives a counterexample that is none, with products and quotients as they are.
/// Each question may take `most_seconds`. @throws what Solver::ask does
Proof prove(const cases::Variant& variant, const x86model::Program& program, const Solver& solver,
            int most_seconds);

}  // namespace fixproof::proof
