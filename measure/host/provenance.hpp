/// @file
/// What made a measurement.
#pragma once

#include <cstdint>
#include <string>

#include "support/json.hpp"

namespace fixproof::measure {

/// `g++ 12.2.0`: what this program was compiled with.
std::string compiler_name();

/// `-O3 -DNDEBUG`: the options it was given for speed; empty where they are not known.
std::string compiler_flags();

/// As the system calls this processor; `unknown` where it does not say.
std::string processor_name();

/// Now, in UTC, as ISO 8601 writes it.
std::string date_now();

/// {command, seed, compiler, date}
support::Json made_by_json(std::uint64_t seed, const std::string& command);

/// The same without a seed.
support::Json made_by_json(const std::string& command);

}  // namespace fixproof::measure
