/// Tests fixed/cmath.hpp against the functions of <cmath> on doubles, which hold every number of at
/// most 32 bits and compute these functions exactly.
#include "fixed/cmath.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"

namespace cmath_test {

using fixproof::number;

template <class N>
double value(N x) {
  return static_cast<double>(x);
}

template <class N>
void check_pair(N x, N y) {
  if (value(y) != 0) {
    ASSERT_EQ(value(fmod(x, y)), std::fmod(value(x), value(y))) << x << ' ' << y;
    if constexpr (std::is_signed_v<typename N::raw_type>) {
      ASSERT_EQ(value(remainder(x, y)), std::remainder(value(x), value(y))) << x << ' ' << y;
      int quotient = -1;
      ASSERT_EQ(remquo(x, y, &quotient), remainder(x, y));
      const double exact = (value(x) - value(remainder(x, y))) / value(y);
      ASSERT_EQ(quotient, std::fmod(exact, 2147483648.0)) << x << ' ' << y;
    }
  }
  ASSERT_EQ(value(nextafter(x, y)),
            value(x) + (value(y) > value(x)   ? std::ldexp(1, -N::fraction_bits)
                        : value(y) < value(x) ? -std::ldexp(1, -N::fraction_bits)
                                              : 0));
  ASSERT_EQ(nexttoward(x, y), nextafter(x, y));
  // -lowest is out of range, and there is no -0.
  if (x != std::numeric_limits<N>::lowest() || value(y) < 0) {
    ASSERT_EQ(value(copysign(x, y)), std::copysign(value(x), value(y)) + 0.0);
  }
  N whole;
  ASSERT_EQ(value(modf(x, &whole)), std::fmod(value(x), 1) + 0.0);
  ASSERT_EQ(value(whole), std::trunc(value(x)));
  const double even = std::nearbyint(value(x));
  if (even <= value(std::numeric_limits<N>::max()) &&
      even >= value(std::numeric_limits<N>::lowest())) {
    ASSERT_EQ(value(rint(x)), even) << x;
    ASSERT_EQ(value(nearbyint(x)), even) << x;
  }
  ASSERT_EQ(signbit(x), value(x) < 0);
  ASSERT_EQ(isnormal(x), value(x) != 0);
  ASSERT_TRUE(isfinite(x) && !isnan(x) && !isinf(x));
}

template <class N>
void check_every_pair() {
  using limits = std::numeric_limits<typename N::raw_type>;
  for (int a = limits::min(); a <= limits::max(); ++a) {
    for (int b = limits::min(); b <= limits::max(); ++b) {
      check_pair(N::from_raw(static_cast<typename N::raw_type>(a)),
                 N::from_raw(static_cast<typename N::raw_type>(b)));
    }
  }
}

TEST(Cmath, EveryPairOfBytes) {
  check_every_pair<number<std::int8_t, 0>>();
  check_every_pair<number<std::int8_t, 4>>();
  check_every_pair<number<std::int8_t, 8>>();
  check_every_pair<number<std::uint8_t, 0>>();
  check_every_pair<number<std::uint8_t, 5>>();
}

template <class N>
void check_random_pairs() {
  std::mt19937_64 random(3);
  for (int i = 0; i < 100'000; ++i) {
    const auto draw = [&] {
      return N::from_raw(static_cast<typename N::raw_type>(
          static_cast<typename N::raw_type>(random()) >> random() % (8 * sizeof(N))));
    };
    const N x = draw();
    const N y = draw();
    check_pair(x, y);
    // Quotients beside a half: x = n * y + y / 2.
    using raw = typename N::raw_type;
    check_pair(N::from_raw(static_cast<raw>(std::int64_t{y.raw()} / 2 * (i % 7))), y);
  }
}

TEST(Cmath, PairsOf16And32Bits) {
  check_random_pairs<number<std::int16_t, 12>>();
  check_random_pairs<fixproof::q16_16>();
  check_random_pairs<fixproof::q2_30>();
  check_random_pairs<fixproof::u16_16>();
}

// Neither int64_t nor double has the products of these.
TEST(Cmath, RemaindersOf64Bits) {
  using limits = std::numeric_limits<std::int64_t>;
  const auto rest = [](std::int64_t x, std::int64_t y, int& quotient) {
    return remquo(number<std::int64_t, 32>::from_raw(x), number<std::int64_t, 32>::from_raw(y),
                  &quotient)
        .raw();
  };
  int quotient = 0;
  EXPECT_EQ(rest(limits::min(), -1, quotient), 0);
  EXPECT_EQ(quotient, 0) << "2^63 modulo 2^31";
  EXPECT_EQ(rest(limits::min(), limits::max(), quotient), -1);
  EXPECT_EQ(quotient, -1);
  EXPECT_EQ(rest(limits::max(), limits::min(), quotient), -1);
  EXPECT_EQ(quotient, -1);
  // 2^62 / 2^63 is a half: the even quotient is 0.
  EXPECT_EQ(rest(std::int64_t{1} << 62, limits::min(), quotient), std::int64_t{1} << 62);
  EXPECT_EQ(quotient, 0);
  EXPECT_EQ(rest(limits::max(), 3, quotient), 1);  // 2^63 - 1 = 3 * 3074457345618258602 + 1
  EXPECT_EQ(quotient, static_cast<int>(3074457345618258602 & 0x7FFFFFFF));
}

TEST(Cmath, DivisionByZeroIsThatOfThePolicy) {
  using trapping = fixproof::q16_16_i386;
  int quotient = 7;
  EXPECT_THROW(static_cast<void>(remainder(trapping(1), trapping(0))), fixproof::divide_error);
  EXPECT_EQ(remquo(fixproof::q16_16(5), fixproof::q16_16(0), &quotient), 0);
  EXPECT_EQ(quotient, 0);
}

static_assert(remainder(fixproof::q16_16(9.5), fixproof::q16_16(2)) == fixproof::q16_16(-0.5));

}  // namespace cmath_test
