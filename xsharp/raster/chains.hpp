/// @file
/// The fill rule of X-Sharp: the rows of a polygon, and the edges at the ends of each row.
///
/// A polygon is two chains of edges, from its topmost row to the first of its points with the
/// greatest y. The topmost points form a run. If the ends of the run differ in x, the top is flat
/// and the chain that begins at the smaller x is the left one; otherwise the edges to the next and
/// to the previous point decide.
///
/// A chain yields one x per row, edge after edge. An edge that goes down from (x1, y1) to (x2, y2)
/// yields the ceiling of its crossing for the rows y1 to y2 - 1. A level or rising edge yields
/// nothing, so the edges after it move up. The left chain's x is the first pixel of a row, the
/// right chain's x is the pixel after the last; rows where they cross have no pixels. Unless the
/// top is flat, the topmost row is left out, because a single point lies on a right edge.
///
/// For a convex polygon this is the top-left rule: left and top edges belong to it, right and
/// bottom edges do not, so polygons that share an edge cover every pixel along it exactly once. A
/// polygon that rounding to pixels has made concave or self-crossing is drawn as the original draws
/// it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "xsharp/picture.hpp"

namespace xsharp {

/// The part of a chain that one edge yields on the page.
struct ChainEdge {
  std::size_t upper = 0;   ///< the edge starts at this point and goes down
  std::size_t lower = 0;   ///< to this point
  std::int32_t first = 0;  ///< the first row of the page that it yields
  std::int32_t end = 0;
  /// The edge's own y for row `first`. It differs from `first` after a rising edge.
  std::int32_t y = 0;
};

class Chains {
 public:
  /// Has no rows if the polygon has fewer than three points or lies in one row.
  /// @param points must outlive the chains
  explicit Chains(std::span<const ScreenPoint> points) : points_(points) {
    if (points.size() < 3) return;
    std::size_t top = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      if (points[i].y < points[top].y) top = i;
      if (points[i].y > points[bottom_].y) bottom_ = i;
    }
    if (points[top].y == points[bottom_].y) return;
    left_ = top;
    right_ = top;
    while (points[before(left_)].y == points[top].y) left_ = before(left_);
    while (points[after(right_)].y == points[top].y) right_ = after(right_);
    flat_ = points[left_].x != points[right_].x;
    left_goes_forward_ = flat_ ? points[left_].x > points[right_].x : next_is_left();
    if (left_goes_forward_) std::swap(left_, right_);
    first_ = std::int64_t{points[top].y} + (flat_ ? 0 : 1);
    end_ = points[bottom_].y;
  }

  /// The polygon's rows on a page: first() to end() - 1.
  [[nodiscard]] std::int32_t first() const {
    return static_cast<std::int32_t>(std::max<std::int64_t>(first_, 0));
  }
  [[nodiscard]] std::int32_t end(std::int32_t height) const { return std::min(end_, height); }

  /// Calls visit(ChainEdge) for the edges at the left end of rows, then for those at the right end.
  /// Visits every row of the page once per side: the falls of a chain add up to at least the
  /// polygon's height.
  template <class Left, class Right>
  void walk(std::int32_t height, const Left& left, const Right& right) const {
    walk_chain(left_, left_goes_forward_, height, left);
    walk_chain(right_, !left_goes_forward_, height, right);
  }

 private:
  [[nodiscard]] std::size_t after(std::size_t i) const {
    return i + 1 == points_.size() ? 0 : i + 1;
  }
  [[nodiscard]] std::size_t before(std::size_t i) const {
    return i == 0 ? points_.size() - 1 : i - 1;
  }

  /// Whether the edge to the next point starts to the left of the edge to the previous point:
  /// next.x * previous.y < next.y * previous.x. The products need 66 bits, so this compares x / y:
  /// whole parts first, then remainders over y, whose products fit into 64 bits.
  [[nodiscard]] bool next_is_left() const {
    const Slant next = slant(points_[left_], points_[after(right_)]);
    const Slant previous = slant(points_[left_], points_[before(left_)]);
    if (next.whole != previous.whole) return next.whole < previous.whole;
    return next.part * previous.rows < previous.part * next.rows;
  }

  /// x / y of an edge that goes down: whole + part / rows, with 0 <= part < rows < 2^32.
  struct Slant {
    std::int64_t whole = 0;
    std::uint64_t part = 0;
    std::uint64_t rows = 1;
  };
  static Slant slant(const ScreenPoint& upper, const ScreenPoint& lower) {
    const std::int64_t rows = std::int64_t{lower.y} - upper.y;
    const std::int64_t width = std::int64_t{lower.x} - upper.x;
    std::int64_t whole = width / rows;
    std::int64_t part = width % rows;
    if (part < 0) {
      part += rows;
      --whole;
    }
    return {whole, static_cast<std::uint64_t>(part), static_cast<std::uint64_t>(rows)};
  }

  template <class Visit>
  void walk_chain(std::size_t start, bool forward, std::int32_t height, const Visit& visit) const {
    const std::int64_t page_first = first();
    const std::int64_t page_end = end(height);
    // The row that is yielded next; with rising edges a chain may be longer than the polygon.
    std::int64_t row = first_;
    std::int64_t skipped = flat_ ? 0 : 1;
    for (std::size_t from = start; from != bottom_ && row < page_end;) {
      const std::size_t to = forward ? after(from) : before(from);
      const std::int64_t begin = points_[from].y + skipped;
      const std::int64_t rows = points_[to].y - begin;
      if (rows > 0) {
        const std::int64_t first_row = std::max(row, page_first);
        const std::int64_t end_row = std::min(row + rows, page_end);
        if (first_row < end_row) {
          visit(ChainEdge{from, to, static_cast<std::int32_t>(first_row),
                          static_cast<std::int32_t>(end_row),
                          static_cast<std::int32_t>(begin + (first_row - row))});
        }
        row += rows;
      }
      skipped = 0;
      from = to;
    }
  }

  std::span<const ScreenPoint> points_;
  std::size_t left_ = 0;
  std::size_t right_ = 0;
  std::size_t bottom_ = 0;
  bool flat_ = false;
  bool left_goes_forward_ = false;
  std::int64_t first_ = 0;
  std::int32_t end_ = 0;
};

}  // namespace xsharp
