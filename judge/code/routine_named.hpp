/// @file
/// Finds the routine that a user names.
#pragma once

#include <string>

#include "judge/code/image.hpp"

namespace fixproof::judge {

/// Makes the function of a name the routine of the image. A name of C++ may be as the file has it,
/// `_ZN1n1fEii`, or as the source has it, `n::f(int, int)` or `n::f`.
/// @throws support::UsageError if there is no such function, or more than one; an empty name throws
///         with the names that there are
void enter_symbol(Image& image, const std::string& name);

}  // namespace fixproof::judge
