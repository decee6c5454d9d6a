/// @file
/// Claims as tables print them, and as JSON.
#pragma once

#include "support/json.hpp"
#include "trade/clocks/claims.hpp"

namespace fixproof::trade {

/// To standard output, every figure a line.
void print_claim(const Claim& claim);

/// {claim, place, means, unit, verdict, allowed: {min, max}, figures: a list of {where, measured:
/// {min, max}, verdict}}. Infinite bounds become null: JSON has no number for them.
support::Json json_of_claim(const Claim& claim);

/// What is not judged, to standard output, and as a list of {claim, place, reason}.
void print_not_judged();
support::Json not_judged_json();

}  // namespace fixproof::trade
