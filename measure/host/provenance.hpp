/// @file
/// Describes the program and the machine that made a measurement.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "support/json.hpp"

namespace fixproof::measure {

/// The compiler of this program, for example `g++ 12.2.0`.
std::string compiler_name();

/// The optimization options, for example `-O3 -DNDEBUG`; empty if unknown.
std::string compiler_flags();

/// The processor name from the operating system; `unknown` if it has none.
std::string processor_name();

/// The current time in UTC, as ISO 8601.
std::string date_now();

/// {command, seed, compiler, date}, or without a seed.
support::Json made_by_json(const std::string& command, std::optional<std::uint64_t> seed = {});

}  // namespace fixproof::measure
