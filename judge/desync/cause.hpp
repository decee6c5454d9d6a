/// @file
/// Says why two runs differ, as far as their records tell.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "judge/desync/log_file.hpp"
#include "judge/desync/values.hpp"

namespace fixproof::desync {

/// What differs first.
enum class Verdict {
  equal,        ///< Nothing, as far as both logs reach.
  block,        ///< A block whose records are not in both logs.
  input,        ///< A number that enters: from raw bits, text, an integer or floating point.
  evaluation,   ///< The order in which the operands were computed.
  swapped,      ///< The places of the operands: both sides have the same ones.
  moved,        ///< The order of values that both sides computed in the same order.
  integer,      ///< An operand that is an integer and not a number.
  operands,     ///< The operands of the same operation: the states differ.
  accumulator,  ///< The sum in an accumulator, which no record has.
  arithmetic,   ///< The results of the same operation with the same operands.
  order,        ///< The order of two operations on one value.
  type,         ///< The type of the numbers: its format or its rules.
  path,         ///< The operations themselves.
  ended,        ///< Nothing before the block in which one run ended, and nothing in that block if
                ///< both logs have its records.
};

/// Where both sides computed two values: numbers of operations.
struct Origin {
  Value of_a;  ///< An operand of A.
  Value of_b;  ///< The operand of B in its place.
  word of_a_in_a = 0;
  word of_a_in_b = 0;
  word of_b_in_a = 0;
  word of_b_in_b = 0;
};

/// Why two records differ.
struct Cause {
  Verdict verdict = Verdict::path;
  std::optional<Origin> origin;  ///< With `evaluation`, `swapped` and `moved`, if it is known.
};

/// Says why the records `i` of A and `j` of B differ, which are the first without a counterpart.
/// The verdict does not depend on which side is A.
Cause cause_of(const std::vector<Record>& a, std::size_t i, const std::vector<Record>& b,
               std::size_t j);

}  // namespace fixproof::desync
