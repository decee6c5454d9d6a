/// @file
/// Tests whether level 1 detects a mutant.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "verify/cases/variant.hpp"
#include "verify/proof/prove.hpp"
#include "x86model/mutants.hpp"

namespace fixproof::proof {

enum class Fate {
  killed,      ///< it differs from the oracle on a case of level 1, or breaks down
  equivalent,  ///< proven equivalent to the routine for all operands
  gap,         ///< level 1 does not detect it, and no proof shows that it is harmless
};

struct MutantResult {
  Fate fate = Fate::gap;
  std::uint64_t cases = 0;  ///< cases of level 1 up to the one that killed it; 0 if it survived
  Proof proof{};            ///< the solver's attempt; empty if the solver was not asked
  std::string failure{};    ///< why the solver failed; empty if it did not
};

/// Returns the mutants of a variant's routine. The FixedMul inside an 8088 transform is excluded
/// because it is mutated on its own.
std::vector<x86model::Mutant> mutants_of(const cases::Variant& variant);

/// Returns mutant `number`, from 1. @throws UsageError if there is no such mutant
x86model::Mutant mutant_of(const cases::Variant& variant, std::size_t number);

/// Runs the cases of level 1 until `judged` differs from the oracle: from `oracle` for CosSin,
/// otherwise from its faster form `fast`.
/// @return the number of cases run, including the one that differs; nothing if none does
std::optional<std::uint64_t> cases_to_kill(const cases::Variant& variant,
                                           const parties::Party& judged, std::uint64_t seed);

/// Runs a few cases of every stream of level 1 first. A program that survives them is equivalent if
/// it has the terms of the routine. Otherwise all other cases follow, and the solver judges a
/// program that survives those. If the solver fails, the result is a gap and `failure` holds the
/// reason.
/// @param max_seconds time limit per question to the solver
/// @throws support::Stopped
MutantResult judge(const cases::Variant& variant, const x86model::Program& program,
                   std::uint64_t seed, const Solver& solver, int max_seconds);

/// The same for an inner loop, with the spans of spans_to_kill().
MutantResult judge(const x86model::LoopForm& form, const x86model::Program& program,
                   std::uint64_t seed, const Solver& solver, int max_seconds);

}  // namespace fixproof::proof
