/// \file
/// Everything of namespace fixed, but for fixed/batch.hpp, fixed/batch_radian.hpp and
/// property/generator.hpp.
///
///     #include "fixed/fixed.hpp"
///
///     using fixed::q16_16;                             // 16.16 in four bytes, nearest, wraps
///     constexpr q16_16 half(0.5);                      // conversions are explicit
///     constexpr q16_16 x = q16_16(7) / q16_16(2) + half;
///     static_assert(x == q16_16(4) && x.raw() == 0x40000);
///     const auto [cos, sin] = fixed::sin_cos<q16_16>(450);  // 45.0 degrees
///     static_assert(fixed::sin(half).raw() == 31420);       // of half a radian
///     std::cout << x * cos << '\n';                    // exact decimal: 2.82843017578125
///     fixed::q16_16_saturating far(1e9);               // 32767.9999847412109375
///     if (auto q = fixed::try_divide(x, q16_16())) {}  // no quotient by zero
///
/// Policies other than the default are in fixed/policy.hpp, their types at the end of
/// fixed/number.hpp.
///
/// Under -ffreestanding this is the part that needs no library at run time: all but text and
/// streams (fixed/text.hpp), std::format (fixed/format.hpp) and exceptions (fixed/error.hpp). Of
/// the standard library it then includes `<array>`, `<bit>`, `<cfloat>`, `<compare>`, `<concepts>`,
/// `<cstddef>`, `<cstdint>`, `<limits>`, `<optional>`, `<type_traits>` and `<utility>`. What would
/// throw executes a trap instruction, and integers do all the work: no floating-point register is
/// touched, unless a number is made of float or double or becomes one.
///
/// Translation units of one program may differ in optimisation and in floating-point flags, but not
/// in whether there are exceptions: the inline functions that throw would then be two.
#pragma once

#include "fixed/limits.hpp"
#include "fixed/math.hpp"
#include "fixed/number.hpp"
#include "fixed/policy.hpp"
#include "fixed/trig.hpp"
#include "fixed/version.hpp"

#if __STDC_HOSTED__
#include "fixed/error.hpp"
#include "fixed/format.hpp"
#include "fixed/text.hpp"
#endif
