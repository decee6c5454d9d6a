/// @file
/// std::bit_cast, which some standard libraries of C++20 lack (libc++ before 14, so also the one of
/// Debian's Emscripten). Every supported compiler has the builtin.
#pragma once

#include "fixed/detail/standard.hpp"

namespace fixproof::detail {

/// The value of type To with the bits of `from`, which is as large.
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}

}  // namespace fixproof::detail
