/// @file
/// The number type with all its operations and functions. Numbers as bytes, durations,
/// Eigen, batches and the recorder have headers of their own: fixed/bytes.hpp, fixed/chrono.hpp,
/// fixed/eigen.hpp, fixed/batch/batch.hpp and fixed/record/recorded.hpp.
///
///     #include "fixed/fixed.hpp"
///
///     using fixproof::q16_16;                             // 16.16 in four bytes, nearest, wraps
///     constexpr q16_16 half(0.5);                         // conversions are explicit
///     constexpr q16_16 x = q16_16(7) / q16_16(2) + half;
///     static_assert(x == q16_16(4) && x.raw() == 0x40000);
///     const auto [sin, cos] = fixproof::sin_cos_of_tenths<q16_16>(450);  // 45.0 degrees
///     static_assert(fixproof::sin(half).raw() == 31420);       // of half a radian
///     static_assert(fixproof::exp(half).raw() == 108051);      // 108050.6
///     std::cout << x * cos << '\n';                       // exact decimal: 2.82843017578125
///     fixproof::q16_16_saturating last(1e9);              // 32767.9999847412109375
///     if (auto q = fixproof::try_divide(x, q16_16())) {}  // no quotient by zero
///
/// fixed/policy.hpp has the other policies; fixed/presets.hpp has their types.
/// fixed/formats.hpp names the other formats, from 8 to 64 bits.
///
/// Under -ffreestanding this header omits everything that needs a run-time library: text and
/// streams (fixed/text.hpp), std::format (fixed/std_format.hpp) and exceptions (fixed/error.hpp).
/// It then includes only `<array>`, `<bit>`, `<cfloat>`, `<compare>`, `<concepts>`, `<cstddef>`,
/// `<cstdint>`, `<limits>`, `<numbers>`, `<optional>`, `<type_traits>` and `<utility>`. An
/// operation that would throw executes a trap instruction. All arithmetic is integer; only
/// conversions from and to float or double use floating-point registers.
///
/// Translation units of one program may differ in optimisation, in floating-point flags and in
/// FIXED_SMALL and FIXED_COMPACT. The functions of real numbers then have different names. These
/// two macros and some flags also replace hardware doubles by integers in roots, divides and
/// conversions from double. These keep their names, so the linker keeps one of two definitions;
/// both give the same bits. The units must agree on exceptions, on FIXED_ON_ERROR, the program's
/// function for errors, and on FIXED_NO_INT128, where two definitions would not agree.
#pragma once

#include "fixed/angle.hpp"
#include "fixed/checked.hpp"
#include "fixed/cmath.hpp"
#include "fixed/constants.hpp"
#include "fixed/exactness.hpp"
#include "fixed/exponential.hpp"
#include "fixed/formats.hpp"
#include "fixed/limits.hpp"
#include "fixed/literals.hpp"
#include "fixed/math.hpp"
#include "fixed/mixed.hpp"
#include "fixed/number.hpp"
#include "fixed/policy.hpp"
#include "fixed/power.hpp"
#include "fixed/presets.hpp"
#include "fixed/results.hpp"
#include "fixed/sine.hpp"
#include "fixed/traits.hpp"
#include "fixed/trigonometry.hpp"
#include "fixed/version.hpp"
#include "fixed/wide.hpp"

#if __STDC_HOSTED__
#include "fixed/error.hpp"
#include "fixed/std_format.hpp"
#include "fixed/text.hpp"
#endif
