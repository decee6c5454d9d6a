/// @file
/// What distinguishes functions that share their code.
#pragma once

#include "fixed/detail/standard.hpp"

namespace fixproof::detail {

enum class exponential_base { two, e, ten };
enum class logarithm_base { two, e, ten };
enum class hyperbola { sine, cosine };
enum class angle_unit { radian, degree, turn };
enum class triangle_side { sine, cosine };

}  // namespace fixproof::detail
