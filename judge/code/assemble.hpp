/// @file
/// Calls NASM.
#pragma once

#include <string>

namespace fixproof::judge {

/// Returns the bytes that NASM assembles from a source, or nothing if NASM reports an error.
/// @throws support::UsageError if nasm cannot be run
std::string assembled(const std::string& source);

}  // namespace fixproof::judge
