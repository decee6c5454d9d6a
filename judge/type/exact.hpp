/// @file
/// The exact results of the type's operations on a, b and c in SMT-LIB, from docs/formats.md.
#pragma once

#include <optional>

#include "judge/code/quotient_claim.hpp"

namespace fixproof::judge {

Exact exact_negative(const cases::Format& format);
Exact exact_magnitude(const cases::Format& format);
/// a * 2^b, or a * 2^-b if `is_right`, toward -infinity. b has 32 bits and a sign.
Exact exact_shift(const cases::Format& format, bool is_right);
/// a in another format.
Exact exact_conversion(const cases::Format& from, const cases::Format& to);
/// a * b + c. @pre as exact_product()
Exact exact_mul_add(const cases::Format& format, Shape shape);

/// a % b by a divide of the function, with the sign of a; 0 if b is 0. Also defines
/// `is-of-operands`, whether the divide is that of a and b. Without a divide, b can only be 0.
Exact exact_remainder(const cases::Format& format, const x86model::symbolic::Terms& terms,
                      const std::optional<MachineDivide>& divide);

}  // namespace fixproof::judge
