/// \file
/// All vector code for the instruction set that the macros of fixed/detail/batch_lanes.hpp name;
/// undefines them at the end.
///
/// No #pragma once: fixed/detail/batch_targets.hpp includes this once per instruction set.

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
