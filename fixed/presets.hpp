/// @file
/// 16.16 and 8.8 under each of fixproof::policies.
#pragma once

#include <cstdint>

#include "fixed/number.hpp"
#include "fixed/policy.hpp"

namespace fixproof {

/// 16.16: every operation rounds to nearest, ties up; overflow wraps.
using q16_16 = number<std::int32_t, 16>;
/// @name 16.16 under the other policies of fixproof::policies
/// \{

/// 16.16 under the policy of the same name; i386 and i8088 mean i386_rounded and i8088_rounded.
using q16_16_saturating = number<std::int32_t, 16, policies::saturating>;
using q16_16_trapping = number<std::int32_t, 16, policies::trapping>;
using q16_16_i386 = number<std::int32_t, 16, policies::i386_rounded>;
using q16_16_i386_mul_rounded = number<std::int32_t, 16, policies::i386_mul_rounded>;
using q16_16_i386_div_rounded = number<std::int32_t, 16, policies::i386_div_rounded>;
using q16_16_i386_unrounded = number<std::int32_t, 16, policies::i386_unrounded>;
using q16_16_i8088 = number<std::int32_t, 16, policies::i8088_rounded>;
using q16_16_i8088_mul_rounded = number<std::int32_t, 16, policies::i8088_mul_rounded>;
using q16_16_i8088_div_rounded = number<std::int32_t, 16, policies::i8088_div_rounded>;
using q16_16_i8088_unrounded = number<std::int32_t, 16, policies::i8088_unrounded>;
/// \}

/// 8.8 under the policy of q16_16.
using q8_8 = number<std::int16_t, 8>;
/// @name 8.8 under the other policies of fixproof::policies
/// \{

/// 8.8 under the policy of the same name; i386 and i8088 mean i386_rounded and i8088_rounded.
using q8_8_saturating = number<std::int16_t, 8, policies::saturating>;
using q8_8_trapping = number<std::int16_t, 8, policies::trapping>;
using q8_8_i386 = number<std::int16_t, 8, policies::i386_rounded>;
using q8_8_i386_mul_rounded = number<std::int16_t, 8, policies::i386_mul_rounded>;
using q8_8_i386_div_rounded = number<std::int16_t, 8, policies::i386_div_rounded>;
using q8_8_i386_unrounded = number<std::int16_t, 8, policies::i386_unrounded>;
using q8_8_i8088 = number<std::int16_t, 8, policies::i8088_rounded>;
using q8_8_i8088_mul_rounded = number<std::int16_t, 8, policies::i8088_mul_rounded>;
using q8_8_i8088_div_rounded = number<std::int16_t, 8, policies::i8088_div_rounded>;
using q8_8_i8088_unrounded = number<std::int16_t, 8, policies::i8088_unrounded>;
/// \}

}  // namespace fixproof
