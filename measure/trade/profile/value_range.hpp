/// @file
/// The range of observed values.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace fixproof::trade {

/// Two's-complement bits that hold a value, including the sign bit: 1 for 0 and -1.
constexpr int signed_bits(std::int64_t value) {
  return 1 +
         static_cast<int>(std::bit_width(static_cast<std::uint64_t>(value < 0 ? ~value : value)));
}

class ValueRange {
 public:
  constexpr void add(std::int64_t value) {
    least_ = std::min(least_, value);
    greatest_ = std::max(greatest_, value);
  }

  [[nodiscard]] constexpr bool empty() const { return least_ > greatest_; }
  [[nodiscard]] constexpr std::int64_t least() const { return least_; }
  [[nodiscard]] constexpr std::int64_t greatest() const { return greatest_; }
  /// Two's-complement bits that hold every value; 0 if the range is empty.
  [[nodiscard]] constexpr int bits() const {
    return empty() ? 0 : std::max(signed_bits(least_), signed_bits(greatest_));
  }

 private:
  std::int64_t least_ = std::numeric_limits<std::int64_t>::max();
  std::int64_t greatest_ = std::numeric_limits<std::int64_t>::min();
};

}  // namespace fixproof::trade
