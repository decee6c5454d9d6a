/// Tests that the precise functions are off by less than 2^-110, with 168 bits of Boost.
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "fixed/detail/arctangent.hpp"
#include "fixed/detail/exponential.hpp"
#include "tests/support/test.hpp"

namespace {

using fixproof::detail::real;
using fixproof::detail::real_bits;
using Decimal50 = boost::multiprecision::cpp_bin_float_50;

Decimal50 value_of(const real& x) {
  return ldexp(Decimal50(x.word(1)), 64 - real_bits) + ldexp(Decimal50(x.word(0)), -real_bits);
}

void expect_near(const real& x, const Decimal50& exact) {
  EXPECT_LT(abs(value_of(x) - exact), ldexp(Decimal50(1), -110));
}

TEST(Precise, Powers) {
  std::mt19937_64 random(1994);
  const Decimal50 log_2 = log(Decimal50(2));
  for (int i = 0; i < 200; ++i) {
    const std::uint64_t x = i == 0 ? ~std::uint64_t{0} : random() >> i % 60;
    expect_near(fixproof::detail::precise_power(real{x} << (real_bits - 64)),
                exp(ldexp(Decimal50(x), -64) * log_2));
  }
}

TEST(Precise, Logarithms) {
  std::mt19937_64 random(1994);
  const Decimal50 log_2 = log(Decimal50(2));
  for (int i = 0; i < 200; ++i) {
    const std::uint32_t m = i == 0 ? 0xffffffff : static_cast<std::uint32_t>(random()) | 0x80000000;
    expect_near(fixproof::detail::precise_logarithm(m), log(ldexp(Decimal50(m), -31)) / log_2);
  }
}

TEST(Precise, Arctangents) {
  std::mt19937_64 random(1994);
  for (int i = 0; i < 200; ++i) {
    const std::uint64_t d = (random() >> (32 + i % 30)) + 1;
    const std::uint64_t n = i % 10 == 0 ? d : random() % (d + 1);
    expect_near(fixproof::detail::precise_arctangent(n, d), atan(Decimal50(n) / d));
  }
}

}  // namespace
