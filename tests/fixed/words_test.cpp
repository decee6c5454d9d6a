/// Tests quotients and roots in words of 32 bits, which only processors without double use, against
/// exact integers.
#include <bit>
#include <cstdint>
#include <limits>
#include <random>

#include "fixed/detail/quotient.hpp"
#include "fixed/detail/square_root.hpp"
#include "tests/support/number_rules.hpp"
#include "tests/support/test.hpp"

namespace words_test {

using fixproof::rounding;
namespace detail = fixproof::detail;

/// Words of every length, and those near powers of two.
std::int32_t word(std::mt19937& random) {
  const auto bits = static_cast<std::uint32_t>(random());
  const int shift = static_cast<int>(random() % 32);
  if (random() % 2 == 0) return static_cast<std::int32_t>(bits) >> shift;
  const std::uint32_t near = (std::uint32_t{1} << shift) + bits % 5 - 2;
  return static_cast<std::int32_t>(random() % 2 == 0 ? near : 0 - near);
}

template <rounding R, int Shift>
void expect_quotients() {
  std::mt19937 random(Shift);
  for (int i = 0; i < 30'000; ++i) {
    const std::int32_t n = word(random);
    const std::int32_t d = word(random);
    if (d == 0) continue;
    const std::int64_t scaled = std::int64_t{n} * (std::int64_t{1} << Shift);
    const std::int64_t expected = d < 0 ? exact::round<std::int64_t>(-scaled, -std::int64_t{d}, R)
                                        : exact::round<std::int64_t>(scaled, d, R);
    ASSERT_EQ((detail::quotient_by_words<R, Shift>(n, d)), expected)
        << n << " * 2^" << Shift << " / " << d << ", rule " << static_cast<int>(R);
  }
}

template <rounding R, int... Shifts>
void expect_each(std::integer_sequence<int, Shifts...> /*shifts*/) {
  (expect_quotients<R, Shifts>(), ...);
}

TEST(Words, DivideExactly) {
  // One digit, two, and the least and the most bits of each.
  constexpr std::integer_sequence<int, 0, 1, 8, 15, 16, 17, 24, 30> shifts;
  expect_each<rounding::half_up>(shifts);
  expect_each<rounding::half_away>(shifts);
  expect_each<rounding::half_even>(shifts);
  expect_each<rounding::truncate>(shifts);
  expect_each<rounding::floor>(shifts);
  expect_each<rounding::ceiling>(shifts);
}

template <int Bits>
void expect_root(std::uint32_t x) {
  const std::uint64_t n = std::uint64_t{x} << (2 * Bits);
  const std::uint64_t root = detail::nearest_sqrt_in_words<Bits>(x);
  // (root - 1/2)^2 < n < (root + 1/2)^2, times 4; n is no tie.
  ASSERT_LT(root == 0 ? 0 : 4 * root * root - 4 * root, 4 * n + (root == 0 ? 1 : 0)) << x;
  ASSERT_LE(4 * n, 4 * root * root + 4 * root) << x << ", " << Bits;
}

TEST(Words, HaveTheNearestRoot) {
  std::mt19937 random(2);
  for (int i = 0; i < 100'000; ++i) {
    const auto x = static_cast<std::uint32_t>(word(random));
    const std::uint32_t half = x >> 16;
    for (const std::uint32_t near : {x, half * half, half * half + half, half * half + half + 1}) {
      expect_root<0>(near);
      expect_root<4>(near);
      expect_root<8>(near);
      expect_root<12>(near);
    }
  }
  expect_root<12>(0xffffffff);
  expect_root<8>(0);
}

}  // namespace words_test
