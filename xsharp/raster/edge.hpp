/// @file
/// The exact crossings of a polygon edge with the rows of pixels.
#pragma once

#include <cstdint>

#include "xsharp/picture.hpp"

namespace xsharp {

/// Steps down an edge row by row. `x()` is ceil(X), where X is the exact rational at which the line
/// through the two ends crosses the row.
///
/// X is stored as x_ - short_ / rows_ with 0 <= short_ < rows_, so that x_ is its ceiling; one row
/// down adds whole_ + part_ / rows_ to X. Only the constructor divides.
class EdgeWalk {
 public:
  /// Starts on row `y`. @pre upper.y <= y < lower.y
  ///
  /// Every value fits: coordinates differ by less than 2^32, and y - upper.y < rows, so that |whole
  /// * down| <= |width| + rows < 2^33 and part * down < 2^64.
  EdgeWalk(const ScreenPoint& upper, const ScreenPoint& lower, std::int32_t y)
      : rows_(std::int64_t{lower.y} - upper.y) {
    const std::int64_t width = std::int64_t{lower.x} - upper.x;
    whole_ = width / rows_;
    part_ = width % rows_;
    if (part_ < 0) {
      part_ += rows_;
      --whole_;
    }
    x_ = upper.x;
    const std::int64_t down = std::int64_t{y} - upper.y;
    if (down == 0) return;
    const auto rows = static_cast<std::uint64_t>(rows_);
    const auto parts = static_cast<std::uint64_t>(part_) * static_cast<std::uint64_t>(down);
    const std::uint64_t over = parts % rows;
    x_ += whole_ * down + static_cast<std::int64_t>(parts / rows);
    if (over != 0) {
      ++x_;
      short_ = static_cast<std::int64_t>(rows - over);
    }
  }

  /// Between the ends of the edge, as long as the row is one of the edge's.
  [[nodiscard]] std::int64_t x() const { return x_; }

  /// The distance from X to x(), in 2^-16 pixels, rounded down: below 65536.
  [[nodiscard]] std::int64_t to_the_left() const { return short_ * 65536 / rows_; }

  void step_down() {
    x_ += whole_;
    short_ -= part_;
    if (short_ < 0) {
      short_ += rows_;
      ++x_;
    }
  }

 private:
  std::int64_t rows_;
  std::int64_t whole_ = 0;
  std::int64_t part_ = 0;
  std::int64_t x_ = 0;
  std::int64_t short_ = 0;
};

}  // namespace xsharp
