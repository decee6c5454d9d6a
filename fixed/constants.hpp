/// @file
/// Mathematical constants, each rounded to the nearest number of any format.
///
/// The names are those of `<numbers>`, and `tau_v`. The policy of the type does not matter: no
/// constant lies on a tie. A constant outside the range of the type does not compile. The templates
/// of std::numbers take number types too.
///
///     static_assert(pi_v<q16_16>.raw() == 205887);  // 205887.4
///     static_assert(std::numbers::pi_v<q16_16> == pi_v<q16_16>);
///     static_assert(e_v<u8_8> == u8_8(2.71875));
#pragma once

#include <cstdint>
#include <limits>
#include <numbers>

#include "fixed/detail/gpu.hpp"
#include "fixed/detail/integer.hpp"
#include "fixed/detail/overflow.hpp"
#include "fixed/number.hpp"
#include "fixed/policy.hpp"
#include "fixed/traits.hpp"

namespace fixproof {

namespace detail {

/// A positive constant, truncated: whole + high * 2^-64 + low * 2^-128.
struct constant {
  std::uint64_t whole;
  std::uint64_t high;
  std::uint64_t low;
};

/// c in units of 2^-FractionBits: truncated, and 1 if the next bit is set, which means that the
/// number above is nearer. @pre whole * 2^FractionBits is less than 2^64
struct truncated {
  std::uint64_t units;
  std::uint64_t up;
};
template <int FractionBits>
constexpr truncated in_units(const constant& c) noexcept {
  if constexpr (FractionBits == 0) {
    return {c.whole, c.high >> 63};
  } else if constexpr (FractionBits == 64) {
    return {c.high, c.low >> 63};
  } else {
    return {c.whole << FractionBits | c.high >> (64 - FractionBits),
            c.high >> (63 - FractionBits) & 1};
  }
}

/// Whether a Number holds the value nearest to c.
template <any_number Number>
constexpr bool holds(const constant& c) noexcept {
  constexpr int bits = Number::fraction_bits;
  constexpr auto highest =
      static_cast<std::uint64_t>((std::numeric_limits<typename Number::raw_type>::max)());
  constexpr std::uint64_t highest_whole = bits == 64 ? 0 : highest >> (bits % 64);
  if (c.whole > highest_whole) return false;
  // Now whole * 2^bits is in range; a fraction may not be if a half is out of range.
  const auto [units, up] = in_units<bits>(c);
  return units < highest || (units == highest && up == 0);
}

/// Whether an integer is a value of Number.
template <any_number Number, integer Int>
constexpr bool represents(Int value) noexcept {
  using raw = typename Number::raw_type;
  return fits<raw>(units<raw, Number::fraction_bits, overflow::saturate>(value));
}

/// The Number nearest to Constant.
template <any_number Number, constant Constant>
constexpr Number nearest() noexcept {
  static_assert(holds<Number>(Constant), "this constant is outside the range of this number type");
  const auto [units, up] = in_units<Number::fraction_bits>(Constant);
  return Number::from_raw(static_cast<typename Number::raw_type>(units + up));
}

namespace constants {

inline constexpr constant pi{3, 0x243f6a8885a308d3, 0x13198a2e03707344};
inline constexpr constant half_pi{1, 0x921fb54442d18469, 0x898cc51701b839a2};
inline constexpr constant tau{6, 0x487ed5110b4611a6, 0x2633145c06e0e689};
inline constexpr constant e{2, 0xb7e151628aed2a6a, 0xbf7158809cf4f3c7};
inline constexpr constant ln2{0, 0xb17217f7d1cf79ab, 0xc9e3b39803f2f6af};
inline constexpr constant ln10{2, 0x4d763776aaa2b05b, 0xa95b58ae0b4c28a3};
inline constexpr constant log2e{1, 0x71547652b82fe177, 0x7d0ffda0d23a7d11};
inline constexpr constant log10e{0, 0x6f2dec549b9438ca, 0x9aadd557d699ee19};
inline constexpr constant sqrt2{1, 0x6a09e667f3bcc908, 0xb2fb1366ea957d3e};
inline constexpr constant sqrt3{1, 0xbb67ae8584caa73b, 0x25742d7078b83b89};
inline constexpr constant inv_pi{0, 0x517cc1b727220a94, 0xfe13abe8fa9a6ee0};
inline constexpr constant inv_sqrtpi{0, 0x906eba8214db688d, 0x71d48a7f6bfec344};
inline constexpr constant inv_sqrt3{0, 0x93cd3a2c8198e269, 0x0c7c0f257d92be83};
inline constexpr constant phi{1, 0x9e3779b97f4a7c15, 0xf39cc0605cedc834};
inline constexpr constant egamma{0, 0x93c467e37db0c7a4, 0xd1be3f810152cb56};

}  // namespace constants
}  // namespace detail

/// An integer constant as a Number. One that is out of range does not compile, whereas the
/// conversion Number(Value) follows the policy.
///
///     constexpr int width = 100;
///     static_assert(constant_v<q8_8, width> == 100 && constant_v<q8_8, -128> == -128);
template <any_number Number, auto Value>
requires detail::integer<decltype(Value)> FIXED_CONSTANT Number constant_v = [] {
  static_assert(detail::represents<Number>(Value),
                "this integer is outside the range of its type; use a format with more bits before "
                "the point");
  return Number(Value);
}();

/// The ratio of a circle's circumference to its diameter: 3.14159265358979323846...
template <any_number Number>
FIXED_CONSTANT Number pi_v = detail::nearest<Number, detail::constants::pi>();

/// 2 pi, a whole turn in radians: 6.28318530717958647692...
template <any_number Number>
FIXED_CONSTANT Number tau_v = detail::nearest<Number, detail::constants::tau>();

/// pi / 2, a right angle in radians: 1.57079632679489661923... pi_v<Number> / 2 would round twice.
template <any_number Number>
FIXED_CONSTANT Number half_pi_v = detail::nearest<Number, detail::constants::half_pi>();

/// The base of the natural logarithm: 2.71828182845904523536...
template <any_number Number>
FIXED_CONSTANT Number e_v = detail::nearest<Number, detail::constants::e>();

/// The natural logarithm of 2: 0.69314718055994530941...
template <any_number Number>
FIXED_CONSTANT Number ln2_v = detail::nearest<Number, detail::constants::ln2>();

/// The natural logarithm of 10: 2.30258509299404568401...
template <any_number Number>
FIXED_CONSTANT Number ln10_v = detail::nearest<Number, detail::constants::ln10>();

/// The binary logarithm of e: 1.44269504088896340735...
template <any_number Number>
FIXED_CONSTANT Number log2e_v = detail::nearest<Number, detail::constants::log2e>();

/// The decimal logarithm of e: 0.43429448190325182765...
template <any_number Number>
FIXED_CONSTANT Number log10e_v = detail::nearest<Number, detail::constants::log10e>();

/// The square root of 2: 1.41421356237309504880...
template <any_number Number>
FIXED_CONSTANT Number sqrt2_v = detail::nearest<Number, detail::constants::sqrt2>();

/// The square root of 3: 1.73205080756887729352...
template <any_number Number>
FIXED_CONSTANT Number sqrt3_v = detail::nearest<Number, detail::constants::sqrt3>();

/// 1 / pi: 0.31830988618379067153...
template <any_number Number>
FIXED_CONSTANT Number inv_pi_v = detail::nearest<Number, detail::constants::inv_pi>();

/// 1 / sqrt(pi): 0.56418958354775628694...
template <any_number Number>
FIXED_CONSTANT Number inv_sqrtpi_v = detail::nearest<Number, detail::constants::inv_sqrtpi>();

/// 1 / sqrt(3): 0.57735026918962576450...
template <any_number Number>
FIXED_CONSTANT Number inv_sqrt3_v = detail::nearest<Number, detail::constants::inv_sqrt3>();

/// The golden ratio, (1 + sqrt(5)) / 2: 1.61803398874989484820...
template <any_number Number>
FIXED_CONSTANT Number phi_v = detail::nearest<Number, detail::constants::phi>();

/// The Euler-Mascheroni constant: 0.57721566490153286060...
template <any_number Number>
FIXED_CONSTANT Number egamma_v = detail::nearest<Number, detail::constants::egamma>();

}  // namespace fixproof

/// @name Constants of `<numbers>`
/// Equal to the constants of namespace fixproof.
/// \{
template <class Raw, int Point, fixproof::policy Rules>
FIXED_CONSTANT fixproof::number<Raw, Point, Rules>
    std::numbers::pi_v<fixproof::number<Raw, Point, Rules>> =
        fixproof::pi_v<fixproof::number<Raw, Point, Rules>>;
template <class Raw, int Point, fixproof::policy Rules>
FIXED_CONSTANT fixproof::number<Raw, Point, Rules>
    std::numbers::e_v<fixproof::number<Raw, Point, Rules>> =
        fixproof::e_v<fixproof::number<Raw, Point, Rules>>;
template <class Raw, int Point, fixproof::policy Rules>
FIXED_CONSTANT fixproof::number<Raw, Point, Rules>
    std::numbers::ln2_v<fixproof::number<Raw, Point, Rules>> =
        fixproof::ln2_v<fixproof::number<Raw, Point, Rules>>;
template <class Raw, int Point, fixproof::policy Rules>
FIXED_CONSTANT fixproof::number<Raw, Point, Rules>
    std::numbers::ln10_v<fixproof::number<Raw, Point, Rules>> =
        fixproof::ln10_v<fixproof::number<Raw, Point, Rules>>;
template <class Raw, int Point, fixproof::policy Rules>
FIXED_CONSTANT fixproof::number<Raw, Point, Rules>
    std::numbers::log2e_v<fixproof::number<Raw, Point, Rules>> =
        fixproof::log2e_v<fixproof::number<Raw, Point, Rules>>;
template <class Raw, int Point, fixproof::policy Rules>
FIXED_CONSTANT fixproof::number<Raw, Point, Rules>
    std::numbers::log10e_v<fixproof::number<Raw, Point, Rules>> =
        fixproof::log10e_v<fixproof::number<Raw, Point, Rules>>;
template <class Raw, int Point, fixproof::policy Rules>
FIXED_CONSTANT fixproof::number<Raw, Point, Rules>
    std::numbers::sqrt2_v<fixproof::number<Raw, Point, Rules>> =
        fixproof::sqrt2_v<fixproof::number<Raw, Point, Rules>>;
template <class Raw, int Point, fixproof::policy Rules>
FIXED_CONSTANT fixproof::number<Raw, Point, Rules>
    std::numbers::sqrt3_v<fixproof::number<Raw, Point, Rules>> =
        fixproof::sqrt3_v<fixproof::number<Raw, Point, Rules>>;
template <class Raw, int Point, fixproof::policy Rules>
FIXED_CONSTANT fixproof::number<Raw, Point, Rules>
    std::numbers::inv_pi_v<fixproof::number<Raw, Point, Rules>> =
        fixproof::inv_pi_v<fixproof::number<Raw, Point, Rules>>;
template <class Raw, int Point, fixproof::policy Rules>
FIXED_CONSTANT fixproof::number<Raw, Point, Rules>
    std::numbers::inv_sqrtpi_v<fixproof::number<Raw, Point, Rules>> =
        fixproof::inv_sqrtpi_v<fixproof::number<Raw, Point, Rules>>;
template <class Raw, int Point, fixproof::policy Rules>
FIXED_CONSTANT fixproof::number<Raw, Point, Rules>
    std::numbers::inv_sqrt3_v<fixproof::number<Raw, Point, Rules>> =
        fixproof::inv_sqrt3_v<fixproof::number<Raw, Point, Rules>>;
template <class Raw, int Point, fixproof::policy Rules>
FIXED_CONSTANT fixproof::number<Raw, Point, Rules>
    std::numbers::phi_v<fixproof::number<Raw, Point, Rules>> =
        fixproof::phi_v<fixproof::number<Raw, Point, Rules>>;
template <class Raw, int Point, fixproof::policy Rules>
FIXED_CONSTANT fixproof::number<Raw, Point, Rules>
    std::numbers::egamma_v<fixproof::number<Raw, Point, Rules>> =
        fixproof::egamma_v<fixproof::number<Raw, Point, Rules>>;
/// \}
