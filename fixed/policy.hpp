/// @file
/// The rules for rounding, overflow and division, and the named policies.
#pragma once

#include "fixed/detail/standard.hpp"

namespace fixproof {

/// The rule that chooses between the two neighbours of an inexact result.
enum class rounding {
  half_up,    ///< to nearest; ties toward +infinity
  half_away,  ///< to nearest; ties away from zero
  floor,      ///< toward -infinity
  truncate,   ///< toward zero
  half_even,  ///< to nearest; ties to even
  ceiling,    ///< toward +infinity
  nearest,    ///< to nearest; only for policy::functions, whose ties follow policy::multiply
};

/// What happens to a result outside the range of the type.
enum class overflow {
  wrap,      ///< reduces it modulo 2^32 in 16.16, and modulo the range of any other type
  saturate,  ///< replaces it by the nearest value in range
  trap,      ///< throws fixproof::overflow_error
  as_range,  ///< as policy::range says; only for policy::products and policy::quotients
};

/// The part of the divisor that a divide uses.
enum class divisor_width {
  full,        ///< all of it
  whole_part,  ///< the truncated divisor: 2.75 counts as 2, -0.5 as 0
};

/// When a divide throws fixproof::divide_error (#DE), whatever `overflow` says. The check precedes
/// wrapping and saturation.
enum class divide_fault {
  none,               ///< only for a zero divisor under overflow::trap
  zero_divisor,       ///< if the divisor, reduced by divisor_width, is zero
  unsigned_quotient,  ///< if the truncated magnitude of the quotient is at least 2^bits units, for
                      ///< the bits of the type: 32 in 16.16
  signed_quotient,    ///< if the rounded quotient is outside the range of the type
};

/// The rules of a number type, passed as a template argument.
///
/// `multiply` also rounds mul_add, dot, lerp and conversions from binary floating point, text and
/// numbers with more fraction bits. Conversions to float and to integers document their own
/// rounding.
///
///     constexpr policy to_floor{.multiply = rounding::floor, .divide = rounding::floor};
///     using floored = number<std::int32_t, 16, to_floor>;
///     static_assert((floored(-1) / floored(3)).raw() == -21846);  // -21845.33
///
/// Products wrap and quotients saturate under this one:
///
///     constexpr policy quotients_saturate{.quotients = overflow::saturate};
///     using mixed = number<std::int32_t, 16, quotients_saturate>;
///     static_assert(mixed(30000) / mixed(0.5) == std::numeric_limits<mixed>::max());
///     static_assert(mixed(30000) * mixed(2) == mixed(60000 - 65536));
struct policy {
  rounding multiply = rounding::half_up;        ///< Rounding of products and conversions.
  rounding divide = rounding::half_up;          ///< Rounding of quotients.
  overflow range = overflow::wrap;              ///< Handling of results out of range.
  divisor_width divisor = divisor_width::full;  ///< The part of a divisor that is used.
  divide_fault fault = divide_fault::none;      ///< Which divides are errors.
  overflow products = overflow::as_range;       ///< Of operator*, mul_add and dot.
  overflow quotients = overflow::as_range;      ///< Of operator/.
  /// Rounding of roots, exponentials, sines and other functions: nearest, floor, ceiling or
  /// truncate. The last three give bounds of the exact result; see docs/functions.md.
  rounding functions = rounding::nearest;
  /// For code that is moved from plain integers. A reader of `x * n` or `(int)x` there cannot tell
  /// stored integers from values. So integers and floating-point numbers are no operands.
  /// Conversions have names: from_raw(n) and x.raw() for stored integers, and q16_16(x), the type
  /// without this rule, for values.
  bool moving = false;

  /// The overflow rule of products.
  [[nodiscard]] constexpr overflow product_range() const noexcept {
    return products == overflow::as_range ? range : products;
  }
  /// The overflow rule of quotients.
  [[nodiscard]] constexpr overflow quotient_range() const noexcept {
    return quotients == overflow::as_range ? range : quotients;
  }

  /// Whether all rules are equal.
  friend constexpr bool operator==(const policy&, const policy&) = default;
};

/// Named policies.
///
/// `wrapping`, `saturating` and `trapping` round every operation to nearest, ties up.
///
/// The others are the eight builds of FIXED.ASM (Abrash, Graphics Programming Black Book, chapter
/// 54). The name states the processor and which of multiply and divide the code rounds, not the
/// settings of the printed switches. None is called `i386` alone, because compilers for that
/// processor define it as a macro.
namespace policies {

inline constexpr policy wrapping{};                               ///< Of q16_16 and q8_8.
inline constexpr policy saturating{.range = overflow::saturate};  ///< Saturates on overflow.
inline constexpr policy trapping{.range = overflow::trap};        ///< Throws on overflow.

/// IMUL, and DIV on magnitudes: raises #DE only if the quotient exceeds 32 unsigned bits.
inline constexpr policy i386_rounded{.multiply = rounding::half_up,
                                     .divide = rounding::half_away,
                                     .fault = divide_fault::unsigned_quotient};
/// As i386_rounded, but rounds only the divide.
inline constexpr policy i386_div_rounded{.multiply = rounding::floor,
                                         .divide = rounding::half_away,
                                         .fault = divide_fault::unsigned_quotient};
/// IMUL and IDIV: raises #DE if the quotient exceeds 32 signed bits. Rounds only the multiply.
inline constexpr policy i386_mul_rounded{.multiply = rounding::half_up,
                                         .divide = rounding::truncate,
                                         .fault = divide_fault::signed_quotient};
/// As i386_mul_rounded, without rounding.
inline constexpr policy i386_unrounded{.multiply = rounding::floor,
                                       .divide = rounding::truncate,
                                       .fault = divide_fault::signed_quotient};

/// MUL and DIV on magnitudes, 16 bits at a time. The divide drops the divisor's fraction and raises
/// #DE only if nothing is left.
inline constexpr policy i8088_rounded{.multiply = rounding::half_away,
                                      .divide = rounding::half_away,
                                      .divisor = divisor_width::whole_part,
                                      .fault = divide_fault::zero_divisor};
/// As i8088_rounded, but rounds only the multiply.
inline constexpr policy i8088_mul_rounded{.multiply = rounding::half_away,
                                          .divide = rounding::truncate,
                                          .divisor = divisor_width::whole_part,
                                          .fault = divide_fault::zero_divisor};
/// As i8088_rounded, but rounds only the divide.
inline constexpr policy i8088_div_rounded{.multiply = rounding::truncate,
                                          .divide = rounding::half_away,
                                          .divisor = divisor_width::whole_part,
                                          .fault = divide_fault::zero_divisor};
/// As i8088_rounded, without rounding.
inline constexpr policy i8088_unrounded{.multiply = rounding::truncate,
                                        .divide = rounding::truncate,
                                        .divisor = divisor_width::whole_part,
                                        .fault = divide_fault::zero_divisor};

}  // namespace policies
}  // namespace fixproof
