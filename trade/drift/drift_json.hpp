/// @file
/// What drift found, as JSON.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/json.hpp"
#include "trade/drift/run.hpp"

namespace fixproof::trade {

/// @param rate of the frames, a second: what times are to be counted by
support::Json drift_json(const std::string& scene, std::uint64_t frames, std::uint64_t rate,
                         const std::vector<DriftCase>& cases,
                         const std::vector<DriftResult>& results);

}  // namespace fixproof::trade
