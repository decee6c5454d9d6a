/// @file
/// Describes what made a measurement.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "support/json.hpp"

namespace fixproof::measure {

/// The optimization options, for example `-O3 -DNDEBUG`; empty if unknown.
std::string compiler_flags();

/// The current time in UTC, as ISO 8601.
std::string date_now();

/// {command, seed, compiler, date}, or without a seed.
support::Json made_by_json(const std::string& command, std::optional<std::uint64_t> seed = {});

}  // namespace fixproof::measure
