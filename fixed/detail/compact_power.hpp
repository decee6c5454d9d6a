#pragma once
#include "fixed/detail/digit_power.hpp"
namespace fixproof::detail::in_compact_words {
using in_digits::nearest_cube_root;
using in_digits::nearest_reciprocal_root;
using in_digits::nearest_real_power;
}
