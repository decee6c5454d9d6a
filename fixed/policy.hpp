/// \file
/// What a number does when a result is not exact, not in range, or not a number at all.
#pragma once

namespace fixed {

/// Which neighbour stands for a result that falls between two representable values.
enum class rounding {
  half_up,    ///< the nearest; an exact half goes toward +infinity
  half_away,  ///< the nearest; an exact half goes away from zero
  floor,      ///< toward -infinity
  truncate,   ///< toward zero
};

/// What becomes of a result outside the range of the type.
enum class overflow {
  wrap,      ///< taken modulo 2^32 (2^16 for 8.8)
  saturate,  ///< replaced by the nearest value of the type
  trap,      ///< throws fixed::overflow_error
};

/// How much of the divisor a divide looks at.
enum class divisor_width {
  full,        ///< all of it
  whole_part,  ///< the whole part of its magnitude, with its sign: 2.75 counts as 2, -0.5 as 0
};

/// When a divide is a divide error (#DE) that throws fixed::divide_error, whatever `overflow` says.
/// The error is found before the result is wrapped or saturated.
enum class divide_fault {
  none,               ///< only under overflow::trap, for a zero divisor
  zero_divisor,       ///< the divisor, as far as divisor_width looks at it, is zero
  unsigned_quotient,  ///< the magnitude of the quotient, truncated, is 2^32 (2^16) units or more
  signed_quotient,    ///< the rounded quotient is outside the range of the type
};

/// The rules of one number type; a template argument.
///
/// `multiply` also rounds mul_add, dot, lerp, and what becomes a number: from binary floating
/// point, from text, from a number with more fraction bits. Quotients follow `divide`; sqrt, sin
/// and cos are always nearest; conversions to float and to integers say their own rounding.
///
///     constexpr policy to_floor{.multiply = rounding::floor, .divide = rounding::floor};
///     using floored = number<16, to_floor>;
///     static_assert((floored(-1) / floored(3)).raw() == -21846);  // -21845.33
struct policy {
  rounding multiply = rounding::half_up;        ///< Of products, and see above.
  rounding divide = rounding::half_up;          ///< Of quotients.
  overflow range = overflow::wrap;              ///< What becomes of results out of range.
  divisor_width divisor = divisor_width::full;  ///< How much of a divisor counts.
  divide_fault fault = divide_fault::none;      ///< Which divides are errors.

  /// Whether all rules are the same.
  friend constexpr bool operator==(const policy&, const policy&) = default;
};

/// Policies by name.
///
/// `wrapping`, `saturating` and `trapping` round every operation to nearest, halves up.
///
/// The others are the eight builds of FIXED.ASM (Abrash, Graphics Programming Black Book, chapter
/// 54): the processor, then what is rounded: multiply and divide, one of them, or neither; the
/// names say what the code does, not what the printed switches are set to. None is `i386` alone,
/// which compilers for that processor define as a macro.
namespace policies {

inline constexpr policy wrapping{};                               ///< That of q16_16 and q8_8.
inline constexpr policy saturating{.range = overflow::saturate};  ///< To the end of the range.
inline constexpr policy trapping{.range = overflow::trap};        ///< Throws.

/// IMUL, and DIV on magnitudes: only a quotient beyond 32 unsigned bits faults.
inline constexpr policy i386_rounded{.multiply = rounding::half_up,
                                     .divide = rounding::half_away,
                                     .fault = divide_fault::unsigned_quotient};
/// The same, with only the divide rounded.
inline constexpr policy i386_div_rounded{.multiply = rounding::floor,
                                         .divide = rounding::half_away,
                                         .fault = divide_fault::unsigned_quotient};
/// IMUL, and IDIV: a quotient beyond 32 signed bits faults. Only the multiply is rounded.
inline constexpr policy i386_mul_rounded{.multiply = rounding::half_up,
                                         .divide = rounding::truncate,
                                         .fault = divide_fault::signed_quotient};
/// The same, without rounding.
inline constexpr policy i386_unrounded{.multiply = rounding::floor,
                                       .divide = rounding::truncate,
                                       .fault = divide_fault::signed_quotient};

/// MUL and DIV on magnitudes, 16 bits at a time; the divide drops the divisor's fraction, and only
/// a divisor of which nothing is left faults.
inline constexpr policy i8088_rounded{.multiply = rounding::half_away,
                                      .divide = rounding::half_away,
                                      .divisor = divisor_width::whole_part,
                                      .fault = divide_fault::zero_divisor};
/// The same, with only the multiply rounded.
inline constexpr policy i8088_mul_rounded{.multiply = rounding::half_away,
                                          .divide = rounding::truncate,
                                          .divisor = divisor_width::whole_part,
                                          .fault = divide_fault::zero_divisor};
/// The same, with only the divide rounded.
inline constexpr policy i8088_div_rounded{.multiply = rounding::truncate,
                                          .divide = rounding::half_away,
                                          .divisor = divisor_width::whole_part,
                                          .fault = divide_fault::zero_divisor};
/// The same, without rounding.
inline constexpr policy i8088_unrounded{.multiply = rounding::truncate,
                                        .divide = rounding::truncate,
                                        .divisor = divisor_width::whole_part,
                                        .fault = divide_fault::zero_divisor};

}  // namespace policies
}  // namespace fixed
