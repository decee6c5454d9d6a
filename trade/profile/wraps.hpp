/// @file
/// Whether a result leaves 32 bits.
#pragma once

#include <cstdint>
#include <span>

#include "cases/variant.hpp"

namespace fixproof::trade {

/// Whether some result of the call is outside -32768 ... 32768 - 2^-16, so that the words returned
/// are not it. Of a call that does not fault.
bool wraps(const cases::Variant& variant, std::span<const std::uint32_t> in);

}  // namespace fixproof::trade
