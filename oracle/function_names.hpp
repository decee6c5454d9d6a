/// @file
/// The names of the functions of real numbers of one and of two operands, which are those of fixed/
/// and of cases::Operation, too. Angles are in radians unless a name says otherwise.
#pragma once

// NOLINTBEGIN(cppcoreguidelines-macro-usage): lists for macros
// Functions that fixed/batch has, too.
#define ORACLE_SPAN_FUNCTIONS_OF_ONE(X) \
  X(exp2)                               \
  X(exp)                                \
  X(expm1)                              \
  X(log2)                               \
  X(log)                                \
  X(log10)                              \
  X(log1p)                              \
  X(sinh)                               \
  X(cosh)                               \
  X(tanh)                               \
  X(sin)                                \
  X(cos)                                \
  X(tan)                                \
  X(sin_of_degrees)                     \
  X(cos_of_degrees)                     \
  X(tan_of_degrees)                     \
  X(sin_of_turns)                       \
  X(cos_of_turns)                       \
  X(tan_of_turns)                       \
  X(asin)                               \
  X(acos)                               \
  X(atan)                               \
  X(cbrt)                               \
  X(rsqrt)                              \
  X(reciprocal)
#define ORACLE_SPAN_FUNCTIONS_OF_TWO(X) \
  X(atan2)                              \
  X(hypot)                              \
  X(pow)

#define ORACLE_FUNCTIONS_OF_ONE(X) \
  ORACLE_SPAN_FUNCTIONS_OF_ONE(X)  \
  X(exp10)                         \
  X(asinh)                         \
  X(acosh)                         \
  X(atanh)                         \
  X(asin_in_degrees)               \
  X(acos_in_degrees)               \
  X(atan_in_degrees)               \
  X(asin_in_turns)                 \
  X(acos_in_turns)                 \
  X(atan_in_turns)
#define ORACLE_FUNCTIONS_OF_TWO(X) \
  ORACLE_SPAN_FUNCTIONS_OF_TWO(X)  \
  X(atan2_in_degrees)              \
  X(atan2_in_turns)
#define ORACLE_FUNCTIONS(X)  \
  ORACLE_FUNCTIONS_OF_ONE(X) \
  ORACLE_FUNCTIONS_OF_TWO(X)
// NOLINTEND(cppcoreguidelines-macro-usage)
