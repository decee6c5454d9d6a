/// @file
/// The operations: names, kinds, and numbers of operands and results.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fixproof::cases {

/// The operations; `operations` says what each is.
enum class Operation : std::uint8_t {
  mul,
  div,
  cossin,
  xformvec,
  concat,
  sqrt,      ///< square root; 0 for a negative operand
  sin,       ///< sine of an angle in radians
  cos,       ///< cosine of an angle in radians
  decimal,   ///< conversion to decimal text and back: the identity
  binary64,  ///< conversion to double and back: the identity
  add,       ///< a + b, for `gen`, `eval` and `check`
  sub,       ///< a - b, likewise
  // Functions of real numbers, to nearest; out of range they saturate.
  exp2,   ///< 2 to the power of the operand
  exp,    ///< e to the power of the operand
  log2,   ///< binary logarithm; the lowest word unless the operand is positive
  log,    ///< natural logarithm, likewise
  log10,  ///< decimal logarithm, likewise
  // Conversions, for `gen` and `check`.
  from_binary64,  ///< a double to a word
  convert,        ///< a word of another format to a word
  from_decimal,   ///< decimal text to a word
  to_decimal,     ///< a word to decimal text
  // More functions. Outside its domain a logarithm is the lowest word; a root, a reciprocal, a
  // tangent or a power of 0 is the highest; and any other function is 0.
  expm1,  ///< exp(x) - 1
  log1p,  ///< log(1 + x)
  sinh,
  cosh,
  tanh,
  tan,
  sin_of_degrees,
  cos_of_degrees,
  tan_of_degrees,
  sin_of_turns,
  cos_of_turns,
  tan_of_turns,
  asin,
  acos,
  atan,
  cbrt,
  rsqrt,       ///< 1 / sqrt(x)
  reciprocal,  ///< 1 / x
  atan2,       ///< the angle of the vector (second operand, first operand)
  hypot,       ///< the length of a vector
  pow,         ///< the first operand to the power of the second
  // Functions of a quotient; a zero divisor is a divide error.
  fmod,       ///< the remainder of the quotient truncated toward zero, exact
  remainder,  ///< the remainder of the nearest whole quotient, ties to even; exact, signed formats
  mul_div,    ///< a * b / c, rounded once
  // One more function of real numbers.
  hypot3,  ///< the length of a vector of three numbers
  // Sums that are rounded once, for `gen`, `eval` and `check`.
  mul_add,  ///< a * b + c
  lerp,     ///< a + (b - a) * t
  dot,      ///< a sum of products, whose operands are all the first factors, then all the second
  // More functions of real numbers; outside their domain they are 0.
  exp10,  ///< 10 to the power of the operand
  asinh,
  acosh,
  atanh,
  asin_in_degrees,
  acos_in_degrees,
  atan_in_degrees,
  asin_in_turns,
  acos_in_turns,
  atan_in_turns,
  atan2_in_degrees,
  atan2_in_turns,
};

enum class Kind : std::uint8_t {
  routine,     ///< of FIXED.ASM
  number,      ///< of the type, in every format
  function,    ///< of real numbers; sin and cos of FIXED.ASM's formats have oracles of their own
  conversion,  ///< between words, doubles and text
  quotient,    ///< a remainder, or the quotient of a product; a zero divisor has no result
  sum,         ///< of products, rounded once
};

struct OperationRow {
  Operation operation;
  std::string_view name;  ///< on the command line
  Kind kind;
  std::size_t words_in;  ///< of dot for two products
  std::size_t words_out;
  /// Seeds the random cases, so it never changes.
  std::uint64_t seed;
};

/// In the order of the enumeration.
inline constexpr std::array<OperationRow, 61> operations{{
    // operation, name, kind, operands, results, seed
    {Operation::mul, "mul", Kind::routine, 2, 1, 0},
    {Operation::div, "div", Kind::routine, 2, 1, 1},
    {Operation::cossin, "cossin", Kind::routine, 1, 2, 2},
    {Operation::xformvec, "xformvec", Kind::routine, 15, 3, 3},
    {Operation::concat, "concat", Kind::routine, 24, 12, 4},
    {Operation::sqrt, "sqrt", Kind::number, 1, 1, 5},
    {Operation::sin, "sin", Kind::function, 1, 1, 6},
    {Operation::cos, "cos", Kind::function, 1, 1, 7},
    {Operation::decimal, "decimal", Kind::number, 1, 1, 8},
    {Operation::binary64, "binary64", Kind::number, 1, 1, 9},
    {Operation::add, "add", Kind::number, 2, 1, 10},
    {Operation::sub, "sub", Kind::number, 2, 1, 11},
    {Operation::exp2, "exp2", Kind::function, 1, 1, 12},
    {Operation::exp, "exp", Kind::function, 1, 1, 13},
    {Operation::log2, "log2", Kind::function, 1, 1, 14},
    {Operation::log, "log", Kind::function, 1, 1, 15},
    {Operation::log10, "log10", Kind::function, 1, 1, 16},
    {Operation::from_binary64, "from_binary64", Kind::conversion, 1, 1, 17},
    {Operation::convert, "convert", Kind::conversion, 1, 1, 18},
    {Operation::from_decimal, "from_decimal", Kind::conversion, 1, 1, 19},
    {Operation::to_decimal, "to_decimal", Kind::conversion, 1, 1, 20},
    {Operation::expm1, "expm1", Kind::function, 1, 1, 21},
    {Operation::log1p, "log1p", Kind::function, 1, 1, 22},
    {Operation::sinh, "sinh", Kind::function, 1, 1, 23},
    {Operation::cosh, "cosh", Kind::function, 1, 1, 24},
    {Operation::tanh, "tanh", Kind::function, 1, 1, 25},
    {Operation::tan, "tan", Kind::function, 1, 1, 26},
    {Operation::sin_of_degrees, "sin_of_degrees", Kind::function, 1, 1, 27},
    {Operation::cos_of_degrees, "cos_of_degrees", Kind::function, 1, 1, 28},
    {Operation::tan_of_degrees, "tan_of_degrees", Kind::function, 1, 1, 29},
    {Operation::sin_of_turns, "sin_of_turns", Kind::function, 1, 1, 30},
    {Operation::cos_of_turns, "cos_of_turns", Kind::function, 1, 1, 31},
    {Operation::tan_of_turns, "tan_of_turns", Kind::function, 1, 1, 32},
    {Operation::asin, "asin", Kind::function, 1, 1, 33},
    {Operation::acos, "acos", Kind::function, 1, 1, 34},
    {Operation::atan, "atan", Kind::function, 1, 1, 35},
    {Operation::cbrt, "cbrt", Kind::function, 1, 1, 36},
    {Operation::rsqrt, "rsqrt", Kind::function, 1, 1, 37},
    {Operation::reciprocal, "reciprocal", Kind::function, 1, 1, 38},
    {Operation::atan2, "atan2", Kind::function, 2, 1, 39},
    {Operation::hypot, "hypot", Kind::function, 2, 1, 40},
    {Operation::pow, "pow", Kind::function, 2, 1, 41},
    {Operation::fmod, "fmod", Kind::quotient, 2, 1, 42},
    {Operation::remainder, "remainder", Kind::quotient, 2, 1, 43},
    {Operation::mul_div, "mul_div", Kind::quotient, 3, 1, 44},
    {Operation::hypot3, "hypot3", Kind::function, 3, 1, 45},
    {Operation::mul_add, "mul_add", Kind::sum, 3, 1, 46},
    {Operation::lerp, "lerp", Kind::sum, 3, 1, 47},
    {Operation::dot, "dot", Kind::sum, 4, 1, 48},
    {Operation::exp10, "exp10", Kind::function, 1, 1, 49},
    {Operation::asinh, "asinh", Kind::function, 1, 1, 50},
    {Operation::acosh, "acosh", Kind::function, 1, 1, 51},
    {Operation::atanh, "atanh", Kind::function, 1, 1, 52},
    {Operation::asin_in_degrees, "asin_in_degrees", Kind::function, 1, 1, 53},
    {Operation::acos_in_degrees, "acos_in_degrees", Kind::function, 1, 1, 54},
    {Operation::atan_in_degrees, "atan_in_degrees", Kind::function, 1, 1, 55},
    {Operation::asin_in_turns, "asin_in_turns", Kind::function, 1, 1, 56},
    {Operation::acos_in_turns, "acos_in_turns", Kind::function, 1, 1, 57},
    {Operation::atan_in_turns, "atan_in_turns", Kind::function, 1, 1, 58},
    {Operation::atan2_in_degrees, "atan2_in_degrees", Kind::function, 2, 1, 59},
    {Operation::atan2_in_turns, "atan2_in_turns", Kind::function, 2, 1, 60},
}};

constexpr const OperationRow& row_of(Operation o) {
  return operations.at(static_cast<std::size_t>(o));
}

static_assert([] {
  for (std::size_t i = 0; i < operations.size(); ++i) {
    if (operations.at(i).operation != static_cast<Operation>(i)) return false;
  }
  return true;
}());

constexpr std::string_view name_of(Operation o) { return row_of(o).name; }
constexpr std::size_t words_in(Operation o) { return row_of(o).words_in; }
constexpr std::size_t words_out(Operation o) { return row_of(o).words_out; }
/// The most products of `dot`.
inline constexpr std::size_t max_terms = 64;
/// The most words of an operation that verify compares; sums are not compared.
inline constexpr std::size_t max_words_in = 24;
inline constexpr std::size_t max_words_out = 12;

constexpr bool is_routine(Operation o) { return row_of(o).kind == Kind::routine; }
constexpr bool is_conversion(Operation o) { return row_of(o).kind == Kind::conversion; }
constexpr bool is_function(Operation o) { return row_of(o).kind == Kind::function; }
constexpr bool is_quotient_function(Operation o) { return row_of(o).kind == Kind::quotient; }
constexpr bool is_sum(Operation o) { return row_of(o).kind == Kind::sum; }

/// Tells whether a zero divisor leaves the operation without a result.
constexpr bool divides(Operation o) { return o == Operation::div || is_quotient_function(o); }

}  // namespace fixproof::cases
