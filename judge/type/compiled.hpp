/// @file
/// The type as a compiler translates it.
#pragma once

#include <span>
#include <string>

#include "judge/type/goal.hpp"

namespace fixproof::judge {

/// A compiler and how it is called.
struct Compilation {
  std::string compiler;  ///< a path, or a name on the PATH
  std::string level;     ///< -O2
  std::string headers;   ///< the folder that holds fixed/fixed.hpp
};

/// Compiles a function for each goal for x86-64, without exceptions, and returns the object's
/// bytes.
/// @throws support::UsageError if the compiler is missing or refuses the source; support::Stopped
std::string compiled(const Compilation& how, std::span<const Goal> goals);

/// Returns the first line of a compiler's --version.
/// @throws support::UsageError if it is missing; support::Stopped
std::string version_of(const std::string& compiler);

}  // namespace fixproof::judge
