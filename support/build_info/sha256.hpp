/// @file
/// SHA-256 of bytes in memory.
#pragma once

#include <string>
#include <string_view>

namespace fixproof::support {

/// Returns the SHA-256 of `bytes` as 64 lower-case hex digits.
/// @throws std::runtime_error if libcrypto cannot compute it
std::string sha256(std::string_view bytes);

}  // namespace fixproof::support
