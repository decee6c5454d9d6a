/// @file
/// The functions of real numbers of one and of two operands, by the names that fixed/, the oracle
/// and cases::Operation give them, in no order that these share.
#pragma once

// NOLINTBEGIN(cppcoreguidelines-macro-usage): lists for macros
#define FIXPROOF_FUNCTIONS_OF_ONE(X) \
  X(exp2)                            \
  X(exp)                             \
  X(expm1)                           \
  X(log2)                            \
  X(log)                             \
  X(log10)                           \
  X(log1p)                           \
  X(sinh)                            \
  X(cosh)                            \
  X(tanh)                            \
  X(sin)                             \
  X(cos)                             \
  X(tan)                             \
  X(sin_of_degrees)                  \
  X(cos_of_degrees)                  \
  X(tan_of_degrees)                  \
  X(sin_of_turns)                    \
  X(cos_of_turns)                    \
  X(tan_of_turns)                    \
  X(asin)                            \
  X(acos)                            \
  X(atan)                            \
  X(cbrt)                            \
  X(rsqrt)                           \
  X(reciprocal)
#define FIXPROOF_FUNCTIONS_OF_TWO(X) \
  X(atan2)                           \
  X(hypot)                           \
  X(pow)
// NOLINTEND(cppcoreguidelines-macro-usage)
