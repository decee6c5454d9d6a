/// @file
/// What stepping takes: clocks of the listings, nanoseconds of the C++, and the document's claims.
#pragma once

#include <cstdint>
#include <vector>

#include "support/json.hpp"
#include "trade/clocks/claims.hpp"
#include "trade/stepping/stepping_clocks.hpp"
#include "trade/stepping/stepping_times.hpp"

namespace fixproof::trade {

struct SteppingCost {
  std::vector<SetupClocks> setups;
  std::vector<PixelCost> pixels;
  std::vector<SteppingTimes> times;
  std::uint64_t rounds = 0;  ///< of the times
  std::vector<Claim> claims;
};

/// To standard output.
void print_cost(const SteppingCost& cost);

/// Adds to the file of `measure --stepping`:
///
///     setups  a list of {cpu; divide, multiply: {min, max} clocks, a value of a span}
///     pixels  a list of {loop, cpu; values: that it steps; pixel: {min, max} clocks; of_span: a
///             list of {pixels, min, max}, a pixel of a span so long with its share of the setups}
///     times   {rounds, processor, flags; loops: a list of {what, of: pixel or value; ns: {min,
///             median, spread}}}
///     claims  as of --clocks
void add_cost(support::Json& json, const SteppingCost& cost);

}  // namespace fixproof::trade
