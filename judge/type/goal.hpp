/// @file
/// The statements about the type that `prove type` asks about: a function, and what it must return
/// for all operands.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "judge/code/path_prover.hpp"
#include "judge/type/number_type.hpp"

namespace fixproof::judge {

/// States what a function must return on a path, in one of several ways of which each is right.
using Statement = std::function<Claim(x86model::symbolic::Terms& terms, const Path& path)>;

struct Goal {
  std::string operation;  ///< such as `*`, `checked_add has`
  std::string type;       ///< NumberType::name, and a second type of a conversion
  std::string format;     ///< of the operands
  std::string body;       ///< the function in C++, of operands a, b, c
  std::string symbol{};   ///< its name in an object
  Signature signature{};
  std::vector<Statement> statements{};
};

/// All goals, in the order of their operations. Each has its own symbol.
std::vector<Goal> goals();

/// Returns a translation unit with a function for each goal.
std::string source_of(std::span<const Goal> goals);

}  // namespace fixproof::judge
