/// @file
/// Describes what made a measurement.
#pragma once

#include <cstdint>
#include <string>

#include "support/json.hpp"

namespace fixproof::measure {

/// The optimization options, for example `-O3 -DNDEBUG`; empty if unknown.
std::string compiler_flags();

/// The current time in UTC, as ISO 8601.
std::string date_now();

/// {command, seed, compiler, date}
support::Json made_by_json(std::uint64_t seed, const std::string& command);

/// The same without a seed.
support::Json made_by_json(const std::string& command);

}  // namespace fixproof::measure
