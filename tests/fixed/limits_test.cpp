/// Tests numeric_limits and hash by counting wherever a claim can be counted.
#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
template <class Number>
using limits = std::numeric_limits<Number>;

static_assert(limits<q16_16>::is_specialized && limits<q16_16>::is_signed);
static_assert(!limits<q16_16>::is_integer && limits<q16_16>::is_exact);
static_assert(limits<q16_16>::is_bounded && !limits<q16_16>::is_iec559);
static_assert(limits<q16_16>::digits == 31 && limits<q8_8>::digits == 15);
static_assert(limits<q16_16>::radix == 2);

static_assert(limits<q16_16>::is_modulo && limits<q16_16_i386>::is_modulo);
static_assert(!limits<q16_16_saturating>::is_modulo && !limits<q16_16_trapping>::is_modulo);
static_assert(!limits<q16_16>::traps && !limits<q16_16_saturating>::traps);
static_assert(limits<q16_16_trapping>::traps && limits<q16_16_i8088>::traps);

static_assert(limits<q16_16>::round_style == std::round_to_nearest);
static_assert(limits<q16_16_i386>::round_style == std::round_to_nearest);
static_assert(limits<q16_16_i8088_unrounded>::round_style == std::round_toward_zero);
static_assert(limits<q16_16_i386_unrounded>::round_style == std::round_indeterminate);
static_assert(limits<q16_16_i386_mul_rounded>::round_style == std::round_indeterminate);
static_assert(
    limits<number<std::int32_t, 16,
                  policy{.multiply = rounding::floor, .divide = rounding::floor}>>::round_style ==
    std::round_toward_neg_infinity);
static_assert(limits<number<std::int32_t, 16,
                            policy{.multiply = rounding::ceiling, .divide = rounding::ceiling}>>::
                  round_style == std::round_toward_infinity);
static_assert(limits<q16_16>::round_error() == q16_16(0.5));
static_assert(limits<q16_16_i8088_unrounded>::round_error() == q16_16_i8088_unrounded(1));
static_assert(limits<q8_8>::round_error() == q8_8(0.5));

static_assert(limits<q16_16>::min().raw() == 1 && limits<q16_16>::denorm_min().raw() == 1);
static_assert(limits<q16_16>::max().raw() == 0x7fffffff);
static_assert(limits<q16_16>::lowest().raw() == -0x7fffffff - 1);
static_assert(limits<q8_8>::lowest().raw() == -0x8000 && limits<q8_8>::max().raw() == 0x7fff);
static_assert(q16_16(1) + limits<q16_16>::epsilon() == q16_16::from_raw(0x10001));
static_assert(!limits<q16_16>::has_infinity && !limits<q16_16>::has_quiet_NaN);
static_assert(limits<q16_16>::has_denorm == std::denorm_absent);

/// Expects the type to hold 2^(min_exponent - 1) and 2^(max_exponent - 1) but no power of two
/// beyond them, and the same for powers of ten.
template <class Number>
void expect_exponents() {
  using saturating = number<typename Number::raw_type, Number::fraction_bits, policies::saturating>;
  const auto power = [](double base, int exponent) {
    double result = 1;
    for (; exponent > 0; --exponent) result *= base;
    for (; exponent < 0; ++exponent) result /= base;
    return result;
  };
  const auto highest = static_cast<double>(limits<Number>::max());
  EXPECT_EQ(static_cast<double>(saturating(power(2, limits<Number>::min_exponent - 1))),
            static_cast<double>(limits<Number>::min()));
  EXPECT_LE(power(2, limits<Number>::max_exponent - 1), highest);
  EXPECT_GT(power(2, limits<Number>::max_exponent), highest);
  const auto lowest = static_cast<double>(limits<Number>::min());
  EXPECT_GE(power(10, limits<Number>::min_exponent10), lowest);
  EXPECT_LT(power(10, limits<Number>::min_exponent10 - 1), lowest);
  EXPECT_LE(power(10, limits<Number>::max_exponent10), highest);
  EXPECT_GT(power(10, limits<Number>::max_exponent10 + 1), highest);
}

TEST(Limits, Exponents) {
  expect_exponents<q16_16>();
  expect_exponents<q8_8>();
}

/// The value rounded to nearest with the given number of decimal places.
std::string decimals(std::int64_t raw, std::int64_t one, std::int64_t power_of_ten) {
  const std::int64_t scaled = 2 * raw * power_of_ten + one;
  std::int64_t nearest = scaled / (2 * one);
  if (nearest * 2 * one > scaled) --nearest;
  const std::string sign = nearest < 0 ? "-" : "";
  if (nearest < 0) nearest = -nearest;
  const std::string fraction = std::to_string(power_of_ten + nearest % power_of_ten).substr(1);
  return sign + std::to_string(nearest / power_of_ten) + "." + fraction;
}

template <class Number>
Number read(const std::string& text) {
  Number value;
  EXPECT_EQ(from_chars(text.data(), text.data() + text.size(), value).ec, std::errc()) << text;
  return value;
}

TEST(Limits, DigitsSurvive) {
  static_assert(limits<q8_8>::digits10 == 4 && limits<q8_8>::max_digits10 == 6);
  static_assert(limits<q16_16>::digits10 == 8 && limits<q16_16>::max_digits10 == 10);
  // All texts dd.dd through 8.8 and back.
  for (int hundredths = -9999; hundredths <= 9999; ++hundredths) {
    const std::string text = decimals(hundredths, 100, 100);
    ASSERT_EQ(decimals(read<q8_8>(text).raw(), 256, 100), text);
  }
  // A sample of the texts dddd.dddd through 16.16 and back.
  for (int parts = -99999999; parts <= 99999999; parts += 9973) {
    const std::string text = decimals(parts, 10000, 10000);
    ASSERT_EQ(decimals(read<q16_16>(text).raw(), 65536, 10000), text);
  }
}

TEST(Limits, DigitsTellApart) {
  std::set<std::string> texts;
  for (int raw = -0x8000; raw <= 0x7fff; ++raw) {
    const std::string text = decimals(raw, 256, 1000);
    texts.insert(text);
    ASSERT_EQ(read<q8_8>(text).raw(), raw);
  }
  EXPECT_EQ(texts.size(), 65536U);
  for (int raw = 0; raw < 0x10000; ++raw) {
    ASSERT_EQ(read<q16_16>(decimals(raw, 65536, 100000)).raw(), raw);
  }
}

TEST(Hash, TellsNumbersApart) {
  std::set<std::size_t> hashes;
  for (int raw = -0x8000; raw <= 0x7fff; ++raw) {
    const auto x = q8_8::from_raw(static_cast<std::int16_t>(raw));
    hashes.insert(std::hash<q8_8>{}(x));
  }
  EXPECT_EQ(hashes.size(), 65536U);
  EXPECT_EQ(std::hash<q16_16>{}(q16_16(1.5)), std::hash<q16_16>{}(q16_16(3) / q16_16(2)));
}

}  // namespace
