#pragma once

#include "fixed/record/recorded.hpp"

using Recorded = fixproof::recorded_number<fixproof::q16_16>;

/// Returns x * x + x, computed in a shared library.
[[gnu::visibility("default")]] Recorded square_and_sum_in_library(Recorded x);
