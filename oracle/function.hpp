#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "oracle/decimal.hpp"
#include "oracle/function_names.hpp"
#include "oracle/integer.hpp"
#include "oracle/rule.hpp"

namespace oracle {

/// The functions of real numbers; the last five are of two operands.
#define ORACLE_ENUMERATOR(name) name,
enum class Function { ORACLE_FUNCTIONS(ORACLE_ENUMERATOR) };
#undef ORACLE_ENUMERATOR

/// The function with this name; empty for any other name.
[[nodiscard]] std::optional<Function> function_named(std::string_view name);

/// The function of x / 2^fraction_bits, or of that and y / 2^fraction_bits. Exact if it is whole or
/// halfway between two multiples of 2^-fraction_bits; otherwise within 2^-200 of these. Results
/// whose magnitude is at least 2^64 ulps are that. Empty outside the domain.
[[nodiscard]] std::optional<Ratio> function_value(Function function, const Integer& x,
                                                  const Integer& y, int fraction_bits);

/// The function of x / 2^fraction_bits, or of that and y / 2^fraction_bits, in ulps, rounded to
/// nearest, ties by `ties`. Empty outside the domain; a pole counts as outside. Results whose
/// magnitude is at least 2^64 ulps are that.
///
/// Computes with 334 bits if the operands and the fraction have at most 33, and otherwise with 667.
/// Integers decide whether a result within 2^-200 ulps of a tie is one.
/// @throws std::range_error if it is not
[[nodiscard]] std::optional<Integer> nearest(Function function, const Integer& x, const Integer& y,
                                             int fraction_bits, Rounding ties);

namespace fast {

/// The same for words of at most 32 bits, by the C library's function where its result is far
/// enough from a tie. Assumes that the library's relative error is below 2^-49, 16 units in the
/// last place of a double. Results whose magnitude is at least 2^40 ulps are that.
[[nodiscard]] std::optional<std::int64_t> nearest(Function function, std::int64_t x, std::int64_t y,
                                                  int fraction_bits, Rounding ties);

}  // namespace fast

}  // namespace oracle
