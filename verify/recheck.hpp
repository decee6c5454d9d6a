/// @file
/// Runs some finished chunks of a report again.
#pragma once

#include <cstddef>
#include <span>

#include "verify/parties/party.hpp"
#include "verify/report.hpp"

namespace fixproof::verify {

/// Runs `count` finished chunks again (all if there are fewer), which it chooses at random, and
/// compares their results with those of the report.
/// @throws std::runtime_error naming the first chunk whose results differ, and both results
/// @throws std::invalid_argument if a party of the plan is missing
void recheck(const Report& report, std::span<const parties::Party* const> parties,
             std::size_t count);

}  // namespace fixproof::verify
