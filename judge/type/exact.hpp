/// @file
/// The exact results of the type's operations on a, b and c in SMT-LIB, from docs/formats.md.
#pragma once

#include "judge/code/claim.hpp"

namespace fixproof::judge {

Exact exact_negative(const cases::Format& format);
Exact exact_magnitude(const cases::Format& format);
/// a * 2^b, or a * 2^-b if `is_right`, toward -infinity. b has 32 bits and a sign.
Exact exact_shift(const cases::Format& format, bool is_right);
/// a in another format.
Exact exact_conversion(const cases::Format& from, const cases::Format& to);
/// a * b + c. @pre as exact_product()
Exact exact_mul_add(const cases::Format& format, Shape shape);

/// How a processor takes a remainder of numbers that it extends.
enum class RemainderBy { idiv_64, div_64, idiv_32, div_32 };
/// The remainder of a / b, with the sign of a; 0 if b is 0.
Exact exact_remainder(const cases::Format& format, RemainderBy by);

}  // namespace fixproof::judge
