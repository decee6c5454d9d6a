/// @file
/// A sum of products that cannot overflow.
#pragma once

#include <cstdint>
#include <limits>

namespace fixproof::detail {

/// A 128-bit two's complement sum in two words, with room for 2^64 terms of 63 bits.
class wide_sum {
 public:
  constexpr wide_sum() noexcept = default;
  constexpr wide_sum(std::uint64_t low, std::uint64_t high) noexcept
      : low_(low), high_(static_cast<std::int64_t>(high)) {}

  constexpr void add(std::int64_t term) noexcept {
    const auto low = static_cast<std::uint64_t>(term);
    low_ += low;
    high_ += (term < 0 ? -1 : 0) + (low_ < low ? 1 : 0);
  }

  /// Adds term * 2^32.
  constexpr void add_shifted_32(std::int64_t term) noexcept {
    const auto low = static_cast<std::uint64_t>(term) << 32;
    low_ += low;
    high_ += (term >> 32) + (low_ < low ? 1 : 0);
  }

  [[nodiscard]] constexpr bool negative() const noexcept { return high_ < 0; }

  /// floor(sum / 2^bits) modulo 2^64, for 0 < bits < 64.
  [[nodiscard]] constexpr std::int64_t low_shifted_right(int bits) const noexcept {
    return static_cast<std::int64_t>((low_ >> bits) |
                                     (static_cast<std::uint64_t>(high_) << (64 - bits)));
  }

  /// floor(sum / 2^bits), for 0 < bits < 64, saturated to std::int64_t.
  [[nodiscard]] constexpr std::int64_t clamped_shifted_right(int bits) const noexcept {
    const std::int64_t above = high_ >> (bits - 1);
    if (above == 0 || above == -1) return low_shifted_right(bits);
    return negative() ? (std::numeric_limits<std::int64_t>::min)()
                      : (std::numeric_limits<std::int64_t>::max)();
  }

 private:
  std::uint64_t low_ = 0;
  std::int64_t high_ = 0;
};

}  // namespace fixproof::detail
