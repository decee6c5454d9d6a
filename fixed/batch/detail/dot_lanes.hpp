/// @file
/// Sums of products in 64-bit lanes; see fixed/batch/detail/lanes.hpp.

#if defined(FIXED_LANES)
namespace fixproof::detail::FIXED_LANES {

/// Sums products. The member add() takes one block of factors, and add_to() returns the sums.
template <class Sum>
struct dot_sums;

/// Sums modulo 2^64.
template <>
struct dot_sums<std::uint64_t> {
  u64 first{};
  u64 second{};

  FIXED_LANE_FUNCTION void add(i32 x, i32 y) {
    const wide_lanes product = products(x, y);
    first += u64(product.first);
    second += u64(product.second);
  }
  FIXED_LANE_FUNCTION void add(const dot_sums& other) {
    first += other.first;
    second += other.second;
  }
  FIXED_LANE_FUNCTION void add_to(std::uint64_t& sum) const { sum += sum_of(first + second); }
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
    const wide_lanes product = products(x, y);
    const u64 first = u64(product.first) ^ sign;
    const u64 second = u64(product.second) ^ sign;
    low += (first & 0xffffffff) + (second & 0xffffffff);
    high += (first >> 32) + (second >> 32);
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
