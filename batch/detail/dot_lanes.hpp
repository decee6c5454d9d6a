/// \file
/// Sums of products in 64-bit lanes; see batch/detail/lanes.hpp.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

/// Sums products. The member add() takes one block of factors, and add_to() returns the sums.
template <class Sum>
struct dot_sums;

/// Sums modulo 2^64, of the even and of the odd lanes.
template <>
struct dot_sums<std::uint64_t> {
  u64 even{};
  u64 odd{};

  FIXED_LANE_FUNCTION void add(i32 x, i32 y) {
    even += u64(mul_even(i64(x), i64(y)));
    odd += u64(mul_even(odd_lanes(x), odd_lanes(y)));
  }
  FIXED_LANE_FUNCTION void add(const dot_sums& other) {
    even += other.even;
    odd += other.odd;
  }
  FIXED_LANE_FUNCTION void add_to(std::uint64_t& sum) const { sum += sum_of(even + odd); }
};

/// Exact sums of up to 2^30 products. Adds 2^63 to each product, so that it is not negative, and
/// sums its two halves separately.
template <>
struct dot_sums<wide_sum> {
  u64 low{};
  u64 high{};
  std::uint64_t blocks = 0;

  FIXED_LANE_FUNCTION void add(i32 x, i32 y) {
    constexpr std::uint64_t sign = std::uint64_t{1} << 63;
    const u64 even = u64(mul_even(i64(x), i64(y))) ^ sign;
    const u64 odd = u64(mul_even(odd_lanes(x), odd_lanes(y))) ^ sign;
    low += (even & 0xffffffff) + (odd & 0xffffffff);
    high += (even >> 32) + (odd >> 32);
    ++blocks;
  }
  FIXED_LANE_FUNCTION void add(const dot_sums& other) {
    low += other.low;
    high += other.high;
    blocks += other.blocks;
  }
  FIXED_LANE_FUNCTION void add_to(wide_sum& sum) const {
    const std::uint64_t added_to_each = blocks * 2 << 31;
    for (std::size_t lane = 0; lane < width / 2; ++lane) {
      sum.add(static_cast<std::int64_t>(low[lane]));
      sum.add_shifted_32(static_cast<std::int64_t>(high[lane] - added_to_each));
    }
  }
};

}  // namespace fixproof::detail::FIXED_LANES
#endif
