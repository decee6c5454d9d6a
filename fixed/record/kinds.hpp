/// @file
/// The kinds of records in a log, with their numbers and names.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fixproof::record {

// The numbers are part of the format of the log (docs/recorder.md): never change one. New
// operations get numbers from 117 to 122.
// NOLINTBEGIN(cppcoreguidelines-macro-usage,bugprone-macro-parentheses): makes an enumeration and
// its names
/// Calls X(number, name, text) for every kind of record.
#define FIXPROOF_RECORD_KINDS(X)                                        \
  X(1, add, "a + b")                                                    \
  X(2, subtract, "a - b")                                               \
  X(3, multiply, "a * b")                                               \
  X(4, divide, "a / b")                                                 \
  X(5, remainder, "a % b")                                              \
  X(6, shift_left, "a << n")                                            \
  X(7, shift_right, "a >> n")                                           \
  X(8, negate, "-a")                                                    \
  X(9, add_integer, "a + integer")                                      \
  X(10, subtract_integer, "a - integer")                                \
  X(11, integer_subtract, "integer - a")                                \
  X(12, multiply_integer, "a * integer")                                \
  X(13, divide_integer, "a / integer")                                  \
  X(14, remainder_integer, "a % integer")                               \
  X(15, from_raw, "from_raw")                                           \
  X(16, convert, "conversion")                                          \
  X(17, from_text, "from_chars")                                        \
  X(19, try_divide, "try_divide")                                       \
  X(20, checked_add, "checked_add")                                     \
  X(21, overflowing_add, "overflowing_add")                             \
  X(22, saturating_add, "saturating_add")                               \
  X(23, wrapping_add, "wrapping_add")                                   \
  X(24, checked_subtract, "checked_subtract")                           \
  X(25, overflowing_subtract, "overflowing_subtract")                   \
  X(26, saturating_subtract, "saturating_subtract")                     \
  X(27, wrapping_subtract, "wrapping_subtract")                         \
  X(28, checked_multiply, "checked_multiply")                           \
  X(29, overflowing_multiply, "overflowing_multiply")                   \
  X(30, saturating_multiply, "saturating_multiply")                     \
  X(31, wrapping_multiply, "wrapping_multiply")                         \
  X(32, checked_mul_add, "checked_mul_add")                             \
  X(33, overflowing_mul_add, "overflowing_mul_add")                     \
  X(34, saturating_mul_add, "saturating_mul_add")                       \
  X(35, wrapping_mul_add, "wrapping_mul_add")                           \
  X(36, checked_negate, "checked_negate")                               \
  X(37, overflowing_negate, "overflowing_negate")                       \
  X(38, saturating_negate, "saturating_negate")                         \
  X(39, wrapping_negate, "wrapping_negate")                             \
  X(40, checked_abs, "checked_abs")                                     \
  X(41, overflowing_abs, "overflowing_abs")                             \
  X(42, saturating_abs, "saturating_abs")                               \
  X(43, wrapping_abs, "wrapping_abs")                                   \
  X(44, checked_shift_left, "checked_shift_left")                       \
  X(45, overflowing_shift_left, "overflowing_shift_left")               \
  X(46, saturating_shift_left, "saturating_shift_left")                 \
  X(47, wrapping_shift_left, "wrapping_shift_left")                     \
  X(48, checked_divide, "checked_divide")                               \
  X(49, overflowing_divide, "overflowing_divide")                       \
  X(50, saturating_divide, "saturating_divide")                         \
  X(51, wrapping_divide, "wrapping_divide")                             \
  X(52, checked_remainder, "checked_remainder")                         \
  X(53, checked_sqrt, "checked_sqrt")                                   \
  X(54, floor, "floor")                                                 \
  X(55, ceil, "ceil")                                                   \
  X(56, round, "round")                                                 \
  X(57, trunc, "trunc")                                                 \
  X(58, abs, "abs")                                                     \
  X(59, min, "min")                                                     \
  X(60, max, "max")                                                     \
  X(61, sqrt, "sqrt")                                                   \
  X(62, mul_add, "mul_add")                                             \
  X(63, lerp, "lerp")                                                   \
  X(64, dot, "dot")                                                     \
  X(65, fmod, "fmod")                                                   \
  X(66, remquo, "remquo")                                               \
  X(67, nearest_remainder, "remainder")                                 \
  X(68, modf, "modf")                                                   \
  X(69, rint, "rint")                                                   \
  X(70, copysign, "copysign")                                           \
  X(71, nextafter, "nextafter")                                         \
  X(72, sin, "sin")                                                     \
  X(73, cos, "cos")                                                     \
  X(74, sin_cos, "sin_cos")                                             \
  X(75, tan, "tan")                                                     \
  X(76, sin_of_tenths, "sin_of_tenths")                                 \
  X(77, cos_of_tenths, "cos_of_tenths")                                 \
  X(78, sin_cos_of_tenths, "sin_cos_of_tenths")                         \
  X(79, sin_of_degrees, "sin_of_degrees")                               \
  X(80, cos_of_degrees, "cos_of_degrees")                               \
  X(81, tan_of_degrees, "tan_of_degrees")                               \
  X(82, sin_of_turns, "sin_of_turns")                                   \
  X(83, cos_of_turns, "cos_of_turns")                                   \
  X(84, tan_of_turns, "tan_of_turns")                                   \
  X(85, exp, "exp")                                                     \
  X(86, exp2, "exp2")                                                   \
  X(87, expm1, "expm1")                                                 \
  X(88, log, "log")                                                     \
  X(89, log1p, "log1p")                                                 \
  X(90, log2, "log2")                                                   \
  X(91, log10, "log10")                                                 \
  X(92, sinh, "sinh")                                                   \
  X(93, cosh, "cosh")                                                   \
  X(94, tanh, "tanh")                                                   \
  X(95, cbrt, "cbrt")                                                   \
  X(96, rsqrt, "rsqrt")                                                 \
  X(97, reciprocal, "reciprocal")                                       \
  X(98, hypot, "hypot")                                                 \
  X(99, pow, "pow")                                                     \
  X(100, atan, "atan")                                                  \
  X(101, atan2, "atan2")                                                \
  X(102, asin, "asin")                                                  \
  X(103, acos, "acos")                                                  \
  X(104, add_to, "add<To>")                                             \
  X(105, subtract_to, "subtract<To>")                                   \
  X(106, multiply_to, "multiply<To>")                                   \
  X(107, divide_to, "divide<To>")                                       \
  X(108, mul_div, "mul_div")                                            \
  X(109, ratio, "ratio")                                                \
  X(110, accumulator_add, "accumulator::add")                           \
  X(111, accumulator_subtract, "accumulator::subtract")                 \
  X(112, accumulator_add_product, "accumulator::add_product")           \
  X(113, accumulator_subtract_product, "accumulator::subtract_product") \
  X(114, accumulator_result, "accumulator::result")                     \
  X(115, sin_cos_of_degrees, "sin_cos_of_degrees")                      \
  X(116, sin_cos_of_turns, "sin_cos_of_turns")                          \
  X(123, input, "input")                                                \
  X(124, frame, "frame")                                                \
  X(125, mark, "mark")                                                  \
  X(126, place, "place")

/// The kind of a record: an operation of the type, or what the program reports about the run.
enum class kind : std::uint8_t {
#define FIXPROOF_RECORD_ONE(number, name, text) name = number,
  FIXPROOF_RECORD_KINDS(FIXPROOF_RECORD_ONE)
#undef FIXPROOF_RECORD_ONE
};

/// Returns the name of a kind, or null if there is no kind with its number.
constexpr const char* text_of(kind k) noexcept {
  switch (k) {
#define FIXPROOF_RECORD_ONE(number, name, text) \
  case kind::name:                              \
    return text;
    FIXPROOF_RECORD_KINDS(FIXPROOF_RECORD_ONE)
#undef FIXPROOF_RECORD_ONE
  }
  return nullptr;
}
// NOLINTEND(cppcoreguidelines-macro-usage,bugprone-macro-parentheses)

/// Tells whether a record of this kind counts as an operation. All do except inputs, frames, marks
/// and places.
constexpr bool is_operation(kind k) noexcept { return k < kind::input; }

/// Tells whether the second operand in a short record of this kind is an integer.
constexpr bool has_integer(kind k) noexcept {
  return k == kind::shift_left || k == kind::shift_right ||
         (k >= kind::add_integer && k <= kind::remainder_integer);
}

/// Returns the number of operands in a short record of this kind.
constexpr std::size_t short_operands(kind k) noexcept {
  switch (k) {
    case kind::from_text:
    case kind::convert:
    case kind::accumulator_result:
      return 0;
    case kind::add:
    case kind::subtract:
    case kind::multiply:
    case kind::divide:
    case kind::remainder:
    case kind::saturating_add:
    case kind::wrapping_add:
    case kind::saturating_subtract:
    case kind::wrapping_subtract:
    case kind::saturating_multiply:
    case kind::wrapping_multiply:
    case kind::saturating_divide:
    case kind::wrapping_divide:
    case kind::min:
    case kind::max:
    case kind::fmod:
    case kind::nearest_remainder:
    case kind::copysign:
    case kind::nextafter:
    case kind::hypot:
    case kind::pow:
    case kind::atan2:
    case kind::add_to:
    case kind::subtract_to:
    case kind::multiply_to:
    case kind::divide_to:
      return 2;
    default:
      return has_integer(k) ? 2 : 1;
  }
}

}  // namespace fixproof::record
