/// @file
/// Whether functions compute in words or in digits.
///
/// Define FIXED_SMALL for programs that must be small. The functions of real numbers then compute
/// in digits of 16 bits, with 88 bits after the point and, near a tie, with 184. They have a few
/// constants of 184 bits, but no tables of results and no first try in 64 bits. The results have
/// the same bits. The namespace differs, so translation units of one program may differ in
/// FIXED_SMALL, and each calls its own functions.
///
/// FIXED_SMALL also makes hardware_double false (hardware.hpp). What depends on that keeps its
/// name, and has the same bits either way: roots, divides in double, and batches. So a program
/// whose translation units differ may have either code of these.
///
/// Constant expressions always compute in words, because compilers limit the number of their steps.
/// The functions in digits ask __builtin_is_constant_evaluated(): for std::is_constant_evaluated(),
/// g++ without optimisation links the functions in words, too.
#pragma once

#if defined(FIXED_SMALL)
#define FIXED_FUNCTIONS in_digits
#else
#define FIXED_FUNCTIONS in_words
#endif
