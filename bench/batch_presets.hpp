/// \file
/// Batches under presets whose rules are not those of the standard type.
#pragma once

namespace batch_bench {

/// The best path and the same loop over the type, on 1024 elements: named
/// preset/PRESET/OPERATION/batch and .../loop. Each is held against the other.
void add_presets();

}  // namespace batch_bench
