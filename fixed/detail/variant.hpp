/// @file
/// Whether functions compute in words, in compact words or in digits.
///
/// Define FIXED_SMALL for programs that must be small. The functions of real numbers then compute
/// in digits of 16 bits, with 88 bits after the point and, near a tie, with 184. They have a few
/// constants of 184 bits, but no tables of results and no first try in 64 bits.
///
/// Define FIXED_COMPACT for programs that must be small and fast enough. The functions then compute
/// in 64 bits with tables and bounds like those in words, by loops that all of them share. Where 64
/// bits do not decide, digits do, or whole powers for pow().
///
/// The results have the same bits. The namespace differs, so translation units of one program may
/// differ in these macros, and each calls its own functions.
///
/// Both macros also make hardware_double false (hardware.hpp). What depends on that keeps its
/// name, and has the same bits either way: roots, divides in double, and batches. So a program
/// whose translation units differ may have either code of these.
///
/// Constant expressions always compute in words, because compilers limit the number of their steps.
/// The other functions ask __builtin_is_constant_evaluated(): for std::is_constant_evaluated(),
/// g++ without optimisation links the functions in words, too.
#pragma once

#if defined(FIXED_SMALL)
#define FIXED_FUNCTIONS in_digits
#elif defined(FIXED_COMPACT)
#define FIXED_FUNCTIONS in_compact_words
#else
#define FIXED_FUNCTIONS in_words
#endif

namespace fixproof::detail {

// In a namespace of its own, so that a call with it finds no function of `detail` by its operand.
namespace of_result {

/// The bits after the point of a function's result, as a type that also knows the operand's format.
template <class To, class Number>
struct result_bits {
  // NOLINTNEXTLINE(google-explicit-constructor): the functions take an int
  constexpr operator int() const noexcept { return To::fraction_bits; }
};

}  // namespace of_result
using of_result::result_bits;

/// Whether 64 bits decide every operand of the functions of one number: in 16.16, and in all
/// formats of at most 16 bits with a fraction. `ManyCompactWords.*` try all operands.
template <class Bits>
inline constexpr bool is_tried = false;
template <class Number>
inline constexpr bool is_tried<result_bits<Number, Number>> =
    Number::fraction_bits > 0 &&
    (sizeof(Number) < 4 || (sizeof(Number) == 4 && Number::fraction_bits == 16));

/// Whether a result is known to have at most, or at least, so many bits after the point.
template <class Bits, int Most>
inline constexpr bool has_at_most = false;
template <class To, class Number, int Most>
inline constexpr bool has_at_most<result_bits<To, Number>, Most> = To::fraction_bits <= Most;
template <class Bits, int Least>
inline constexpr bool has_at_least = false;
template <class To, class Number, int Least>
inline constexpr bool has_at_least<result_bits<To, Number>, Least> = To::fraction_bits >= Least;

}  // namespace fixproof::detail
