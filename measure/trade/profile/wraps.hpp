/// @file
/// Detects results that overflow 32 bits.
#pragma once

#include <cstdint>
#include <span>

#include "verify/cases/variant.hpp"

namespace fixproof::trade {

/// Whether any exact result of the call is outside -32768 ... 32768 - 2^-16, so that the returned
/// words wrap. The call must not end in a divide error.
bool wraps(const cases::Variant& variant, std::span<const std::uint32_t> in);

}  // namespace fixproof::trade
