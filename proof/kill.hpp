/// @file
/// What verification finds of a program with a mistake in it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/variant.hpp"
#include "proof/prove.hpp"
#include "x86model/mutants.hpp"

namespace fixproof::proof {

enum class Fate {
  killed,      ///< level 1 has a case on which it differs from the oracle, or breaks down
  equivalent,  ///< proven to do what the routine does, for all operands
  gap,         ///< level 1 does not notice, and it is not proven harmless
};

struct Judgement {
  Fate fate = Fate::gap;
  std::uint64_t cases = 0;  ///< of level 1 that were run until it was killed
  double seconds = 0;
  Proof proof;          ///< of what level 1 did not kill
  std::string failure;  ///< why there is no proof, where the solver failed
};

/// The mutants of a variant's routine. Those of the FixedMul that an 8088 transform brings along
/// are left to FixedMul.
std::vector<x86model::Mutant> mutants_of(const cases::Variant& variant);

/// Mutant `number`, from 1. @throws UsageError where there are fewer
x86model::Mutant mutant_of(const cases::Variant& variant, std::size_t number);

/// Runs the cases of level 1 until one shows that `judged` is not what the oracle says:
/// `oracle` for CosSin, else its faster form `fast`. @return how
/// many were run, that one included; nothing where none does
std::optional<std::uint64_t> cases_to_kill(const cases::Variant& variant,
                                           const parties::Party& judged, std::uint64_t seed);

/// Runs the cases of level 1 until one kills the program; what survives is put to the solver. A
/// solver that fails leaves a gap, and says why.
/// @param most_seconds that one question to the solver may take
/// @throws Stopped
Judgement judge(const cases::Variant& variant, const x86model::Program& program, std::uint64_t seed,
                const Solver& solver, int most_seconds);

/// The same for an inner loop, by the spans of spans_to_kill().
Judgement judge(const x86model::LoopForm& form, const x86model::Program& program,
                std::uint64_t seed, const Solver& solver, int most_seconds);

}  // namespace fixproof::proof
