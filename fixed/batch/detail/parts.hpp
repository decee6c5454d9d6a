/// @file
/// All vector code for the instruction set that the macros of fixed/batch/detail/lanes.hpp name;
/// undefines them at the end.
///
/// No #pragma once: fixed/batch/detail/targets.hpp includes this once per instruction set.

#if defined(FIXED_LANES)
#include "fixed/batch/detail/lanes.hpp"
//
#include "fixed/batch/detail/memory.hpp"
//
#include "fixed/batch/detail/arithmetic.hpp"
//
#include "fixed/batch/detail/blocks.hpp"
//
#include "fixed/batch/detail/elements.hpp"
//
#include "fixed/batch/detail/dot_lanes.hpp"
//
#include "fixed/batch/detail/conversion_lanes.hpp"
//
#include "fixed/batch/detail/vertices.hpp"
//
#include "fixed/batch/detail/half_vertices.hpp"
//
#include "fixed/batch/detail/transform_lanes.hpp"
//
#include "fixed/batch/detail/radian_lanes.hpp"
//
#include "fixed/batch/detail/loops.hpp"

#undef FIXED_LANES
#undef FIXED_LANE_BYTES
#undef FIXED_LANE_TARGET
#undef FIXED_LANE_FUNCTION
#undef FIXED_LANE_LOOP
#endif
