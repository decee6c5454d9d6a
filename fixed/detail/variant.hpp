/// \file
/// Whether functions compute in words or in digits.
///
/// Define FIXED_SMALL for programs that must be small. The functions of real numbers then compute
/// in digits of 16 bits, with 88 bits after the point and, near a tie, with 184. There are no
/// tables and no first try in 64 bits. The results have the same bits. The namespace differs, so
/// translation units of one program may differ in FIXED_SMALL, and each calls its own functions.
#pragma once

#if defined(FIXED_SMALL)
#define FIXED_FUNCTIONS in_digits
#else
#define FIXED_FUNCTIONS in_words
#endif
