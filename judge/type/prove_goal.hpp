/// @file
/// Proves that a compiled function of the type returns what its goal says.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "judge/code/image.hpp"
#include "judge/type/goal.hpp"

namespace fixproof::judge {

struct GoalProof {
  proof::Standing standing = proof::Standing::open;
  std::string why{};  ///< why it is not proven
  double seconds = 0;
  std::vector<std::uint64_t> counterexample{};  ///< operands for which it fails when run
  std::string given{};                          ///< what it does for them
};

/// Returns the operands of a case by its number: zeros, then random ones of every size and those at
/// the ends of the range.
std::vector<std::uint64_t> operands_of(const Signature& signature, std::uint64_t number);

/// Follows every path of the function in x86-64 code, and asks about each. First runs it on Unicorn
/// for two hundred cases, with which the terms of the paths must agree.
/// @param image has the function as its entry
/// @throws as proof::Solver::ask(); machine_code::EmulatorError
GoalProof prove(const Goal& goal, const Image& image, const Ask& ask);

}  // namespace fixproof::judge
