/// \file
/// The exceptions of policies that throw. The text names the operation and its operands.
#pragma once

#include <stdexcept>

namespace fixed {

/// The result is outside the range of the type.
class overflow_error : public std::overflow_error {
  using std::overflow_error::overflow_error;
};

/// Division by zero, or a divide that the processor of a FIXED.ASM preset answers with #DE.
class divide_error : public std::domain_error {
  using std::domain_error::domain_error;
};

/// The operation has no result for this operand: sqrt of a negative number, a number made of NaN.
class domain_error : public std::domain_error {
  using std::domain_error::domain_error;
};

}  // namespace fixed
