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

class SteppingStatistics {
 public:
  /// The sampled pixels of the longest spans: sixteenths of the way from first to last.
  static constexpr std::size_t places = 17;
  /// The lengths whose last pixel is recorded: 5, 10, 20 ... 320.
  static constexpr std::size_t lengths = 7;
  static constexpr std::size_t length(std::size_t i) { return std::size_t{5} << i; }

  static constexpr std::size_t pixel_at(std::size_t i) {
    return (i * (xsharp::longest_span - 1) + 8) / (places - 1);
  }

  void add_errors(const SpanPlace& place, const SteppedSpan& span);
  /// @param texels whether drawn values are row * 256 + column
  void add_picture(const SteppedSpan& span, bool texels);

  [[nodiscard]] std::uint64_t spans() const { return spans_; }
  [[nodiscard]] std::uint64_t pixels() const { return pixels_; }
  [[nodiscard]] const ErrorAndBound& all() const { return all_; }
  /// The largest ratio of an error to its bound.
  [[nodiscard]] double part_of_bound() const { return part_; }
  [[nodiscard]] const ErrorAndBound& last() const { return last_; }
  [[nodiscard]] const std::array<ErrorAndBound, places>& along() const { return along_; }
  [[nodiscard]] const std::array<ErrorAndBound, lengths>& last_of() const { return last_of_; }
  /// Describes the first value beyond its bound; empty if all are within.
  [[nodiscard]] const std::string& beyond() const { return beyond_; }

  /// Pixels drawn in all pictures.
  [[nodiscard]] std::uint64_t drawn() const { return drawn_; }
  /// Pixels that differ from the exact picture, and the largest difference, in drawn values; for
  /// texels, in columns or rows.
  [[nodiscard]] std::uint64_t wrong() const { return wrong_; }
  [[nodiscard]] std::int64_t max_error() const { return max_error_; }
  [[nodiscard]] const BandCount& bands() const { return bands_; }
  /// Distinct values (texels) of exact spans, and the number of them that are never drawn.
  [[nodiscard]] std::uint64_t wanted() const { return wanted_; }
  [[nodiscard]] std::uint64_t missed() const { return missed_; }

 private:
  void add_bands(const SteppedSpan& span);
  void add_missed(const SteppedSpan& span);

  std::uint64_t spans_ = 0;
  std::uint64_t pixels_ = 0;
  ErrorAndBound all_;
  double part_ = 0;
  ErrorAndBound last_;
  std::array<ErrorAndBound, places> along_{};
  std::array<ErrorAndBound, lengths> last_of_{};
  std::string beyond_;
  std::uint64_t drawn_ = 0;
  std::uint64_t wrong_ = 0;
  std::int64_t max_error_ = 0;
  BandCount bands_;
  std::uint64_t wanted_ = 0;
  std::uint64_t missed_ = 0;
};

}  // namespace fixproof::measure
