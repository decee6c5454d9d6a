/// \file
/// All vector code for the instruction set that the macros of batch/detail/lanes.hpp name;
/// undefines them at the end.
///
/// No #pragma once: batch/detail/targets.hpp includes this once per instruction set.

#if defined(FIXED_LANES)
#include "batch/detail/lanes.hpp"
//
#include "batch/detail/memory.hpp"
//
#include "batch/detail/arithmetic.hpp"
//
#include "batch/detail/blocks.hpp"
//
#include "batch/detail/elements.hpp"
//
#include "batch/detail/dot_lanes.hpp"
//
#include "batch/detail/conversion_lanes.hpp"
//
#include "batch/detail/vertices.hpp"
//
#include "batch/detail/radian_lanes.hpp"
//
#include "batch/detail/loops.hpp"

#undef FIXED_LANES
#undef FIXED_LANE_BYTES
#undef FIXED_LANE_TARGET
#undef FIXED_LANE_FUNCTION
#undef FIXED_LANE_LOOP
#endif
