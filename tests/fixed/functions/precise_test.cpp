/// Tests that the precise parts of the functions are off by less than 2^-170, or by as much as each
/// test says, with 334 bits of Boost.
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "fixed/detail/arcsine.hpp"
#include "fixed/detail/hyperbolic.hpp"
#include "fixed/detail/phase.hpp"
#include "tests/support/test.hpp"

namespace {

using fixproof::detail::real;
using fixproof::detail::real_bits;
using Decimal100 = boost::multiprecision::cpp_bin_float_100;

Decimal100 value_of(const real& x) {
  if (x.negative()) return -value_of(-x);
  Decimal100 value = 0;
  for (std::size_t i = 6; i-- > 0;) value = ldexp(value, 64) + Decimal100(x.word(i));
  return ldexp(value, -real_bits);
}

void expect_near(const real& x, const Decimal100& exact, int bits = 170) {
  EXPECT_LT(abs(value_of(x) - exact), ldexp(Decimal100(1), -bits)) << exact;
}

/// Random number i, as a word of any length.
std::uint64_t word_of_any_length(std::mt19937_64& random, int i) { return random() >> i % 60; }

TEST(Precise, Powers) {
  std::mt19937_64 random(1994);
  const Decimal100 log_2 = log(Decimal100(2));
  for (int i = 0; i < 200; ++i) {
    const std::uint64_t x = i == 0 ? ~std::uint64_t{0} : word_of_any_length(random, i);
    expect_near(fixproof::detail::precise_power(real{x} << (real_bits - 64)),
                exp(ldexp(Decimal100(x), -64) * log_2));
  }
}

TEST(Precise, Exponentials) {
  std::mt19937_64 random(1994);
  for (int i = 0; i < 100; ++i) {
    const auto x = static_cast<std::int64_t>(random()) >> (24 + i % 30);
    const int whole = static_cast<int>(x >> 32);
    if (whole >= 24 || whole < -24) continue;
    // The error is relative: e^24 is below 2^35.
    expect_near(fixproof::detail::precise_exponential(real{x} << (real_bits - 32)),
                exp(ldexp(Decimal100(x), -32)), whole < 0 ? 165 : 130);
  }
}

TEST(Precise, Logarithms) {
  std::mt19937_64 random(1994);
  const Decimal100 log_2 = log(Decimal100(2));
  for (int i = 0; i < 200; ++i) {
    const std::uint64_t m =
        i == 0 ? 0x1ffffffff : std::uint64_t{1} << 32 | random() >> (32 + i % 32);
    expect_near(fixproof::detail::precise_logarithm(m), log(ldexp(Decimal100(m), -32)) / log_2);
  }
}

TEST(Precise, Arctangents) {
  std::mt19937_64 random(1994);
  for (int i = 0; i < 200; ++i) {
    const std::uint64_t x = i == 0 ? 0 : word_of_any_length(random, i);
    expect_near(fixproof::detail::precise_arctangent(real{x} << (real_bits - 64)),
                atan(ldexp(Decimal100(x), -64)));
  }
  expect_near(fixproof::detail::precise_arctangent(fixproof::detail::real_one),
              atan(Decimal100(1)));
}

TEST(Precise, Sides) {
  std::mt19937_64 random(1994);
  for (int i = 0; i < 50; ++i) {
    const std::uint64_t squares = word_of_any_length(random, i);
    expect_near(fixproof::detail::precise_side(squares, 32), sqrt(ldexp(Decimal100(squares), -64)));
  }
}

TEST(Precise, SinesAndCosines) {
  std::mt19937_64 random(1994);
  const Decimal100 pi = boost::math::constants::pi<Decimal100>();
  for (int i = 0; i < 200; ++i) {
    const std::uint64_t x = i == 0 ? ~std::uint64_t{0} : word_of_any_length(random, i);
    const real angle = product(real{x} << (real_bits - 64),
                               fixproof::detail::real_from(fixproof::detail::real_pi)) >>
                       1;
    const auto both = fixproof::detail::precise_sine_of(angle);
    expect_near(both.sine, sin(ldexp(Decimal100(x), -64) * pi / 2));
    expect_near(both.cosine, cos(ldexp(Decimal100(x), -64) * pi / 2));
  }
}

TEST(Precise, Phases) {
  using fixproof::detail::angle_unit;
  std::mt19937_64 random(1994);
  const Decimal100 pi = boost::math::constants::pi<Decimal100>();
  const auto expect_phase = [&](const auto& phase, const Decimal100& angle) {
    const Decimal100 quarters = angle * 2 / pi;
    const Decimal100 whole = floor(quarters);
    EXPECT_EQ(phase.quarters, static_cast<unsigned>(whole - 4 * floor(whole / 4)));
    expect_near(phase.rest, angle - whole * pi / 2, 150);
  };
  for (int i = 0; i < 200; ++i) {
    const auto raw = static_cast<std::int64_t>(random()) >> (32 + i % 30);
    const int bits = static_cast<int>(random() % 33);
    const Decimal100 x = ldexp(Decimal100(raw), -bits);
    expect_phase(fixproof::detail::precise_phase_of<angle_unit::radian>(raw, bits), x);
    // The floor of a whole number of quarters is safe only a little above it.
    const Decimal100 above = ldexp(Decimal100(1), -180);
    expect_phase(fixproof::detail::precise_phase_of<angle_unit::degree>(raw, bits),
                 x * pi / 180 + above);
    expect_phase(fixproof::detail::precise_phase_of<angle_unit::turn>(raw, bits),
                 x * 2 * pi + above);
  }
}

}  // namespace
