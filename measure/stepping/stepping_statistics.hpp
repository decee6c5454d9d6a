/// @file
/// Error statistics of a stepping variant over many spans.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "measure/stepping/stepping_span.hpp"

namespace fixproof::measure {

/// The largest error magnitude and the largest bound at one place.
struct ErrorAndBound {
  double error = 0;
  double bound = 0;

  void add(const SteppedValue& value);
};

/// Returns 0 if `whole` is 0.
inline double share_of(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

/// Counts maximal runs of equal pixels.
struct BandCount {
  std::uint64_t exact = 0;  ///< in the exact picture
  std::uint64_t drawn = 0;
  std::uint64_t wrong = 0;   ///< drawn bands without an identical band in the exact picture
  std::uint64_t widest = 0;  ///< the longest run of wrong pixels
};

struct SteppingStatistics {
  /// The sampled pixels of the longest spans: sixteenths of the way from first to last.
  static constexpr std::size_t places = 17;
  /// The lengths whose last pixel is recorded: 5, 10, 20 ... 320.
  static constexpr std::size_t lengths = 7;
  static constexpr std::size_t length(std::size_t i) { return std::size_t{5} << i; }

  static constexpr std::size_t pixel_at(std::size_t i) {
    return (i * (xsharp::longest_span - 1) + 8) / (places - 1);
  }

  std::uint64_t spans = 0;
  std::uint64_t pixels = 0;
  ErrorAndBound all;
  double part_of_bound = 0;  ///< the largest ratio of an error to its bound
  ErrorAndBound last;
  std::array<ErrorAndBound, places> along{};
  std::array<ErrorAndBound, lengths> last_of{};
  std::string beyond;  ///< describes the first value beyond its bound; empty if all are within

  std::uint64_t drawn = 0;  ///< pixels in all pictures
  std::uint64_t wrong = 0;  ///< pixels that differ from the exact picture
  /// The largest difference, in drawn values; for texels, in columns or rows.
  std::int64_t max_error = 0;
  BandCount bands;
  std::uint64_t wanted = 0;  ///< distinct values (texels) of exact spans
  std::uint64_t missed = 0;  ///< those that are never drawn

  void add_errors(const SpanPlace& place, const SteppedSpan& span);
  /// @param texels whether drawn values are row * 256 + column
  void add_picture(const SteppedSpan& span, bool texels);

 private:
  void add_bands(const SteppedSpan& span);
  void add_missed(const SteppedSpan& span);
};

}  // namespace fixproof::measure
