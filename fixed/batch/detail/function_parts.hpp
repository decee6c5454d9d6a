/// @file
/// The functions for the instruction set that the macros of fixed/batch/detail/lanes.hpp name;
/// undefines them at the end, as fixed/batch/detail/parts.hpp does.

#if defined(FIXED_LANES)
#define FIXED_LANE_FUNCTION FIXED_LANE_TARGET __attribute__((always_inline)) inline

#include "fixed/batch/detail/elementary_lanes.hpp"
#include "fixed/batch/detail/function_lanes.hpp"

#undef FIXED_LANES
#undef FIXED_LANE_BYTES
#undef FIXED_LANE_TARGET
#undef FIXED_LANE_FUNCTION
#endif
