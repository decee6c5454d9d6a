#pragma once

#include <cstdint>
#include <optional>

#include "oracle/integer.hpp"
#include "oracle/rule.hpp"

namespace oracle {

enum class Exponential { exp2, exp, log2, log, log10 };

/// The function of ulps / 2^fraction_bits, in ulps, rounded to nearest, ties by `ties`. Empty for
/// the logarithm of a number that is not positive. Results from 2^64 ulps on are 2^64.
/// @throws std::range_error if 168 bits cannot decide the rounding
[[nodiscard]] std::optional<Integer> nearest(Exponential function, const Integer& ulps,
                                             int fraction_bits, Rounding ties);

namespace fast {

/// The same for words of at most 32 bits, by the C library's function where its result is far
/// enough from a tie. Assumes that the library's relative error is below 2^-49, 16 units in the
/// last place of a double. Results from 2^40 ulps on are 2^40.
[[nodiscard]] std::optional<std::int64_t> nearest(Exponential function, std::int64_t ulps,
                                                  int fraction_bits, Rounding ties);

}  // namespace fast

}  // namespace oracle
