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
/// Calls ROW(number, name, text) for every kind of record.
#define FIXPROOF_RECORD_KINDS(ROW)                                        \
  ROW(1, add, "a + b")                                                    \
  ROW(2, subtract, "a - b")                                               \
  ROW(3, multiply, "a * b")                                               \
  ROW(4, divide, "a / b")                                                 \
  ROW(5, remainder, "a % b")                                              \
  ROW(6, shift_left, "a << n")                                            \
  ROW(7, shift_right, "a >> n")                                           \
  ROW(8, negate, "-a")                                                    \
  ROW(9, add_integer, "a + integer")                                      \
  ROW(10, subtract_integer, "a - integer")                                \
  ROW(11, integer_subtract, "integer - a")                                \
  ROW(12, multiply_integer, "a * integer")                                \
  ROW(13, divide_integer, "a / integer")                                  \
  ROW(14, remainder_integer, "a % integer")                               \
  ROW(15, from_raw, "from_raw")                                           \
  ROW(16, convert, "conversion")                                          \
  ROW(17, from_text, "from_chars")                                        \
  ROW(19, try_divide, "try_divide")                                       \
  ROW(20, checked_add, "checked_add")                                     \
  ROW(21, overflowing_add, "overflowing_add")                             \
  ROW(22, saturating_add, "saturating_add")                               \
  ROW(23, wrapping_add, "wrapping_add")                                   \
  ROW(24, checked_subtract, "checked_subtract")                           \
  ROW(25, overflowing_subtract, "overflowing_subtract")                   \
  ROW(26, saturating_subtract, "saturating_subtract")                     \
  ROW(27, wrapping_subtract, "wrapping_subtract")                         \
  ROW(28, checked_multiply, "checked_multiply")                           \
  ROW(29, overflowing_multiply, "overflowing_multiply")                   \
  ROW(30, saturating_multiply, "saturating_multiply")                     \
  ROW(31, wrapping_multiply, "wrapping_multiply")                         \
  ROW(32, checked_mul_add, "checked_mul_add")                             \
  ROW(33, overflowing_mul_add, "overflowing_mul_add")                     \
  ROW(34, saturating_mul_add, "saturating_mul_add")                       \
  ROW(35, wrapping_mul_add, "wrapping_mul_add")                           \
  ROW(36, checked_negate, "checked_negate")                               \
  ROW(37, overflowing_negate, "overflowing_negate")                       \
  ROW(38, saturating_negate, "saturating_negate")                         \
  ROW(39, wrapping_negate, "wrapping_negate")                             \
  ROW(40, checked_abs, "checked_abs")                                     \
  ROW(41, overflowing_abs, "overflowing_abs")                             \
  ROW(42, saturating_abs, "saturating_abs")                               \
  ROW(43, wrapping_abs, "wrapping_abs")                                   \
  ROW(44, checked_shift_left, "checked_shift_left")                       \
  ROW(45, overflowing_shift_left, "overflowing_shift_left")               \
  ROW(46, saturating_shift_left, "saturating_shift_left")                 \
  ROW(47, wrapping_shift_left, "wrapping_shift_left")                     \
  ROW(48, checked_divide, "checked_divide")                               \
  ROW(49, overflowing_divide, "overflowing_divide")                       \
  ROW(50, saturating_divide, "saturating_divide")                         \
  ROW(51, wrapping_divide, "wrapping_divide")                             \
  ROW(52, checked_remainder, "checked_remainder")                         \
  ROW(53, checked_sqrt, "checked_sqrt")                                   \
  ROW(54, floor, "floor")                                                 \
  ROW(55, ceil, "ceil")                                                   \
  ROW(56, round, "round")                                                 \
  ROW(57, trunc, "trunc")                                                 \
  ROW(58, abs, "abs")                                                     \
  ROW(59, min, "min")                                                     \
  ROW(60, max, "max")                                                     \
  ROW(61, sqrt, "sqrt")                                                   \
  ROW(62, mul_add, "mul_add")                                             \
  ROW(63, lerp, "lerp")                                                   \
  ROW(64, dot, "dot")                                                     \
  ROW(65, fmod, "fmod")                                                   \
  ROW(66, remquo, "remquo")                                               \
  ROW(67, nearest_remainder, "remainder")                                 \
  ROW(68, modf, "modf")                                                   \
  ROW(69, rint, "rint")                                                   \
  ROW(70, copysign, "copysign")                                           \
  ROW(71, nextafter, "nextafter")                                         \
  ROW(72, sin, "sin")                                                     \
  ROW(73, cos, "cos")                                                     \
  ROW(74, sin_cos, "sin_cos")                                             \
  ROW(75, tan, "tan")                                                     \
  ROW(76, sin_of_tenths, "sin_of_tenths")                                 \
  ROW(77, cos_of_tenths, "cos_of_tenths")                                 \
  ROW(78, sin_cos_of_tenths, "sin_cos_of_tenths")                         \
  ROW(79, sin_of_degrees, "sin_of_degrees")                               \
  ROW(80, cos_of_degrees, "cos_of_degrees")                               \
  ROW(81, tan_of_degrees, "tan_of_degrees")                               \
  ROW(82, sin_of_turns, "sin_of_turns")                                   \
  ROW(83, cos_of_turns, "cos_of_turns")                                   \
  ROW(84, tan_of_turns, "tan_of_turns")                                   \
  ROW(85, exp, "exp")                                                     \
  ROW(86, exp2, "exp2")                                                   \
  ROW(87, expm1, "expm1")                                                 \
  ROW(88, log, "log")                                                     \
  ROW(89, log1p, "log1p")                                                 \
  ROW(90, log2, "log2")                                                   \
  ROW(91, log10, "log10")                                                 \
  ROW(92, sinh, "sinh")                                                   \
  ROW(93, cosh, "cosh")                                                   \
  ROW(94, tanh, "tanh")                                                   \
  ROW(95, cbrt, "cbrt")                                                   \
  ROW(96, rsqrt, "rsqrt")                                                 \
  ROW(97, reciprocal, "reciprocal")                                       \
  ROW(98, hypot, "hypot")                                                 \
  ROW(99, pow, "pow")                                                     \
  ROW(100, atan, "atan")                                                  \
  ROW(101, atan2, "atan2")                                                \
  ROW(102, asin, "asin")                                                  \
  ROW(103, acos, "acos")                                                  \
  ROW(104, add_to, "add<To>")                                             \
  ROW(105, subtract_to, "subtract<To>")                                   \
  ROW(106, multiply_to, "multiply<To>")                                   \
  ROW(107, divide_to, "divide<To>")                                       \
  ROW(108, mul_div, "mul_div")                                            \
  ROW(109, ratio, "ratio")                                                \
  ROW(110, accumulator_add, "accumulator::add")                           \
  ROW(111, accumulator_subtract, "accumulator::subtract")                 \
  ROW(112, accumulator_add_product, "accumulator::add_product")           \
  ROW(113, accumulator_subtract_product, "accumulator::subtract_product") \
  ROW(114, accumulator_result, "accumulator::result")                     \
  ROW(115, sin_cos_of_degrees, "sin_cos_of_degrees")                      \
  ROW(116, sin_cos_of_turns, "sin_cos_of_turns")                          \
  ROW(123, input, "input")                                                \
  ROW(124, frame, "frame")                                                \
  ROW(125, mark, "mark")                                                  \
  ROW(126, place, "place")

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
