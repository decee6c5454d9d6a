/// \file
/// What a batch is made of on one instruction set, which the macros of fixed/detail/batch_lanes.hpp
/// name; they are undefined at the end.
///
/// No #pragma once: fixed/detail/batch_targets.hpp includes this for one instruction set after
/// another.

#if defined(FIXED_LANES)
#include "fixed/detail/batch_lanes.hpp"
//
#include "fixed/detail/batch_arithmetic.hpp"
//
#include "fixed/detail/batch_vertices.hpp"
//
#include "fixed/detail/radian_lanes.hpp"
//
#include "fixed/detail/batch_loops.hpp"

#undef FIXED_LANES
#undef FIXED_LANE_BYTES
#undef FIXED_LANE_TARGET
#undef FIXED_LANE_FUNCTION
#endif
