/// @file
/// The narrowest format in which a scene stays within a budget.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "measure/host/host_times.hpp"
#include "measure/trade/advice/choice.hpp"
#include "measure/trade/advice/screen_error.hpp"
#include "support/json.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::trade {

/// The scene with some number of fraction bits and a way of turning.
struct TriedFormat {
  int fraction_bits = 0;
  Turning turning;
  /// Once over the budget, the run ends, so larger errors are not seen.
  ScreenError error;
  /// The bits that every result of the run needs, with the sign.
  int word_bits = 0;
};

inline constexpr int max_tried_fraction_bits = 24;

/// Tries 0 to max_tried_fraction_bits, for the scene's way of turning and then for orientations
/// from scratch. The other parameters are those of screen_errors().
std::vector<TriedFormat> try_formats(const xsharp::Scene& scene, double budget,
                                     std::uint64_t& frames, const std::atomic<bool>& stop,
                                     const std::function<void(std::uint64_t)>& frame_done);

/// The format with the fewest fraction bits within the budget, as an index; of those, the one that
/// comes first. Empty if none is within the budget.
std::optional<std::size_t> narrowest(const std::vector<TriedFormat>& tried);

/// The width of the narrowest integer of C++ that has these bits: 8, 16, 32 or 64.
int integer_width(int word_bits);

/// What a scene's vertices and transforms cost in a format.
struct FormatCost {
  int width = 0;          ///< of a word: 8, 16, 32 or 64 bits
  std::size_t bytes = 0;  ///< vertices in object and view space, and two transforms per object
  /// Nanoseconds to transform and project all vertices once, in batches on this processor.
  measure::Times nanoseconds;
};

/// The costs of words of q16_16 and of a width, timed in turn. Half the bits of a word are fraction
/// bits; their number hardly changes the time.
/// @return nothing if `stop` ended the run
std::vector<FormatCost> format_costs(const xsharp::Scene& scene, int width,
                                     const std::atomic<bool>& stop);

struct FormatReport {
  std::string scene;
  std::uint64_t frames = 0;  ///< measured
  double budget = 0;         ///< in pixels
  std::vector<TriedFormat> tried;
  /// Of q16_16, then of the narrowest format; empty if there is none within the budget.
  std::vector<FormatCost> costs;
};

/// made: {command, compiler, date, processor}. worst_pixels is null after a divide error.
void to_json(support::Json& json, const FormatReport& report);

}  // namespace fixproof::trade
