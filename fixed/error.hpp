/// @file
/// The exceptions that policies throw. The text names the operation and its operands.
#pragma once

#include <stdexcept>

namespace fixproof {

/// The result is outside the range of the type.
class overflow_error : public std::overflow_error {
  using std::overflow_error::overflow_error;
};

/// A division by zero, or a divide that raises #DE under a FIXED.ASM policy.
class divide_error : public std::domain_error {
  using std::domain_error::domain_error;
};

/// The operation is not defined for its operand: sqrt of a negative number, or conversion of NaN.
class domain_error : public std::domain_error {
  using std::domain_error::domain_error;
};

}  // namespace fixproof
