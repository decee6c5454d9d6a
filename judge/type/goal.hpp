/// @file
/// The statements about the type that `prove type` asks about: a function, and what it must return
/// for all operands.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "judge/code/symbolic.hpp"
#include "judge/type/statements.hpp"

namespace fixproof::judge {

struct Goal {
  std::string operation;  ///< such as `*`, or `checked_...` for all such forms
  std::string type;       ///< NumberType::name, and a second type of a conversion
  std::string format;     ///< of the operands
  std::string body;       ///< the function in C++, of operands a, b, c
  std::string symbol{};   ///< its name in an object
  Signature signature{};
  Statements says{};
};

/// All goals, format by format. Each has its own symbol.
std::vector<Goal> goals();

/// Returns a translation unit with a function for each goal.
std::string source_of(std::span<const Goal> goals);

}  // namespace fixproof::judge
