/// @file
/// The results of `drift` as JSON.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/json.hpp"
#include "trade/drift/run.hpp"

namespace fixproof::trade {

/// @param rate frames per second, to convert frames to times
support::Json drift_json(const std::string& scene, std::uint64_t frames, std::uint64_t rate,
                         const std::vector<DriftCase>& cases,
                         const std::vector<DriftResult>& results);

}  // namespace fixproof::trade
