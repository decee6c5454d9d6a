/// @file
/// Narrows an exact result to the range of the type; the only place that does.
#pragma once

#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "fixed/detail/inlining.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// Whether a Raw can hold the value. @pre Wide is signed and holds every Raw
template <class Raw, class Wide>
constexpr bool fits(Wide value) noexcept {
  return !(value < Wide{(std::numeric_limits<Raw>::min)()}) &&
         !(Wide{(std::numeric_limits<Raw>::max)()} < value);
}

/// The value as a Raw by rule Overflow. Under overflow::trap, calls `raise` for a value that does
/// not fit; `raise` must throw.
template <overflow Overflow, class Raw, class Wide, class Raise>
FIXED_ALWAYS_INLINE constexpr Raw narrow(Wide value,
                                         const Raise& raise) noexcept(Overflow != overflow::trap) {
  if constexpr (Overflow == overflow::saturate) {
    using limits = std::numeric_limits<Raw>;
#if defined(__AVX2__)
    // In two steps, of values and not of constants with names, g++ finds a minimum and a maximum,
    // which it vectorises. Without instructions for them this takes longer.
    const Wide above = value < Wide{(limits::min)()} ? Wide{(limits::min)()} : Wide{value};
    return static_cast<Raw>(Wide{(limits::max)()} < above ? Wide{(limits::max)()} : Wide{above});
#else
    constexpr Wide lowest{(limits::min)()};
    constexpr Wide highest{(limits::max)()};
    return static_cast<Raw>(value < lowest ? lowest : highest < value ? highest : value);
#endif
  } else {
    static_assert(Overflow != overflow::as_range);
    if constexpr (Overflow == overflow::trap) {
      if (!fits<Raw>(value)) raise();
    }
    return static_cast<Raw>(value);
  }
}

/// The rule of functions, which never wrap: a root or an exponential modulo 2^32 means nothing.
template <overflow Overflow>
inline constexpr overflow function_range =
    Overflow == overflow::trap ? overflow::trap : overflow::saturate;

/// Limits an integer to +-(2^Bits - 1). Limits of 32 bits or more are out of every range, but leave
/// room for shifts and for products with a stored integer.
template <int Bits = 32, std::integral Int>
constexpr std::int64_t clamp_far(Int value) noexcept {
  constexpr std::int64_t limit = (std::int64_t{1} << Bits) - 1;
  if constexpr (sizeof(Int) <= sizeof(std::uint32_t)) {
    return std::int64_t{value};
  } else if constexpr (std::is_signed_v<Int>) {
    return value < -limit ? -limit : value > limit ? limit : std::int64_t{value};
  } else {
    return value > std::uint64_t{limit} ? limit : static_cast<std::int64_t>(value);
  }
}

}  // namespace fixproof::detail
