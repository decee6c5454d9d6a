/// Compares the functions in formats of 64 bits with MPFR: a few random operands, and hard ones.
#include "tests/fixed/functions/long_words.hpp"

namespace long_words_test {
namespace {

using fixproof::number;
using fixproof::q16_48;
using fixproof::q32_32;
using long_words::Format;
using long_words::Word;
using oracle::Function;

const std::array formats{long_words::format_of<q32_32>("q32_32"),
                         long_words::format_of<fixproof::q48_16>("q48_16"),
                         long_words::format_of<q16_48>("q16_48"),
                         long_words::format_of<fixproof::u32_32>("u32_32"),
                         long_words::format_of<fixproof::u0_64>("u0_64"),
                         long_words::format_of<number<std::int64_t, 64>>("q0_64"),
                         long_words::format_of<number<std::int64_t, 0>>("q64_0"),
                         long_words::format_of<number<std::uint64_t, 1>>("u63_1")};

class LongWords : public testing::TestWithParam<Format> {};

TEST_P(LongWords, AreThoseOfMpfr) {
  long_words::Comparison comparison(GetParam());
  long_words::Random word(GetParam().format, 1994);
  for (int i = 0; i < 100; ++i) {
    const Word x = word();
    const Word y = word();
    for (const auto& name : long_words::names) {
      ASSERT_NO_FATAL_FAILURE(comparison.compare(name, x, y));
    }
  }
  EXPECT_GT(comparison.count(), 1000U);
}

TEST_P(LongWords, AreRightNearTiesAndPoles) {
  long_words::Comparison comparison(GetParam());
  const std::vector<Word> words = long_words::hard_words(GetParam().format);
  for (std::size_t i = 0; i < words.size(); ++i) {
    // Each word is an operand of some of the functions, which take turns.
    for (std::size_t k = i % 32; k < long_words::names.size(); k += 32) {
      const Word other = words[(i * 31 + 7) % words.size()];
      ASSERT_NO_FATAL_FAILURE(comparison.compare(long_words::names[k], words[i], other));
    }
  }
}

TEST_P(LongWords, AreRightWherePowersAreRational) {
  long_words::Comparison comparison(GetParam());
  const auto pairs = long_words::hard_powers(GetParam().format);
  for (std::size_t i = 0; i < pairs.size(); i += 5) {
    ASSERT_NO_FATAL_FAILURE(
        comparison.compare({Function::pow, "pow", true}, pairs[i].first, pairs[i].second));
  }
}

INSTANTIATE_TEST_SUITE_P(All, LongWords, testing::ValuesIn(formats),
                         [](const auto& one) { return std::string(one.param.name); });

/// Whether the constant is the 576 bits of `want`, rounded toward zero.
void expect_constant(const fixproof::detail::real_constant& constant, mpfr_result::Real& want) {
  mpfr_result::Real cut(576);
  mpfr_set(cut, want, MPFR_RNDZ);
  mpfr_result::Real found(576);
  mpfr_set_ui(found, 0, MPFR_RNDN);
  for (std::size_t i = constant.limbs.size(); i-- > 0;) {
    mpfr_mul_2si(found, found, 32, MPFR_RNDN);
    mpfr_add_ui(found, found, constant.limbs[i], MPFR_RNDN);
  }
  mpfr_mul_2si(found, found, constant.exponent - 576, MPFR_RNDN);
  if (constant.is_negative) mpfr_neg(found, found, MPFR_RNDN);
  EXPECT_EQ(mpfr_cmp(mpfr_ptr(found), mpfr_ptr(cut)), 0) << constant.limbs[17];
}

TEST(IntervalConstants, AreThoseOfMpfr) {
  namespace detail = fixproof::detail;
  mpfr_result::Real value(700);
  mpfr_const_log2(value, MPFR_RNDN);
  expect_constant(detail::log_of_2, value);
  mpfr_ui_div(value, 1, value, MPFR_RNDN);
  expect_constant(detail::log2_of_e, value);
  mpfr_set_ui(value, 10, MPFR_RNDN);
  mpfr_log2(value, value, MPFR_RNDN);
  expect_constant(detail::log2_of_10, value);
  mpfr_ui_div(value, 1, value, MPFR_RNDN);
  expect_constant(detail::log10_of_2, value);
  mpfr_const_pi(value, MPFR_RNDN);
  mpfr_div_ui(value, value, 2, MPFR_RNDN);
  expect_constant(detail::real_half_pi, value);
  mpfr_ui_div(value, 1, value, MPFR_RNDN);
  expect_constant(detail::quarters_of_radian, value);
  const std::array<unsigned long, 5> of_logs{6, 7, 9, 10, 11};
  for (std::size_t i = 0; i < of_logs.size(); ++i) {
    mpfr_set_d(value, static_cast<double>(of_logs.at(i)) / 8, MPFR_RNDN);
    mpfr_log(value, value, MPFR_RNDN);
    expect_constant(detail::logs_of_eighths.at(i), value);
  }
  for (std::size_t i = 0; i < detail::arctangents_of_eighths.size(); ++i) {
    mpfr_set_d(value, static_cast<double>(i + 1) / 8, MPFR_RNDN);
    mpfr_atan(value, value, MPFR_RNDN);
    expect_constant(detail::arctangents_of_eighths.at(i), value);
  }
}

// Ties are worked out by hand: each is half a unit.
template <class N>
constexpr N one_unit = N::from_raw(1);

TEST(LongWordTies, FollowThePolicy) {
  constexpr fixproof::policy to_even{.multiply = fixproof::rounding::half_even};
  constexpr fixproof::policy away{.multiply = fixproof::rounding::half_away};
  using even = fixproof::with_policy<q32_32, to_even>;
  using from_zero = fixproof::with_policy<q32_32, away>;
  EXPECT_EQ(exp2(q32_32(-33)), one_unit<q32_32>);
  EXPECT_EQ(exp2(even(-33)), 0);
  EXPECT_EQ(pow(q32_32(2), q32_32(-33)), one_unit<q32_32>);
  EXPECT_EQ(pow(even(2), even(-33)), 0);
  // (-2)^-33 is -1/2 unit, and (-8)^-11 too.
  EXPECT_EQ(pow(q32_32(-2), q32_32(-33)), 0);
  EXPECT_EQ(pow(from_zero(-8), from_zero(-11)).raw(), -1);
  // 3 / 2^11 cubed is 27 half units of 2^-32: 13.5 units.
  EXPECT_EQ(pow(q32_32(3) / q32_32(2048), q32_32(3)).raw(), 14);
  EXPECT_EQ(pow(even(3) / even(2048), even(3)).raw(), 14);
  // 5 / 2^11 cubed is 125 half units: 62.5 units.
  EXPECT_EQ(pow(q32_32(5) / q32_32(2048), q32_32(3)).raw(), 63);
  EXPECT_EQ(pow(even(5) / even(2048), even(3)).raw(), 62);
  // The root of 9 / 2^66 is 3 / 2^33, which is 1.5 units of 2^-32.
  using fine = number<std::uint64_t, 33>;
  EXPECT_EQ(rsqrt(number<std::int64_t, 16>::from_raw(std::int64_t{1} << 50)).raw(), 1);
  EXPECT_EQ(rsqrt(number<std::int64_t, 16, to_even>::from_raw(std::int64_t{1} << 50)).raw(), 0);
  EXPECT_EQ(exp2(number<std::int64_t, 16>(-17)).raw(), 1);
  EXPECT_EQ(pow(fine::from_raw(1), fine(1)).raw(), 1U);
}

TEST(LongWordTies, OfAnglesFollowThePolicy) {
  constexpr fixproof::policy to_even{.multiply = fixproof::rounding::half_even};
  using whole = number<std::int64_t, 0>;
  using even = number<std::int64_t, 0, to_even>;
  EXPECT_EQ(sin_of_degrees(whole(30)), 1);
  EXPECT_EQ(sin_of_degrees(whole(-30)), 0);
  EXPECT_EQ(sin_of_degrees(even(30)), 0);
  EXPECT_EQ(cos_of_degrees(whole(120)), 0);
  EXPECT_EQ(atan2_in_turns(whole(0), whole(-1)), 1);
  EXPECT_EQ(acos_in_turns(even(-1)), 0);
  EXPECT_EQ((atan_in_turns(number<std::int64_t, 2>(1))).raw(), 1);
  EXPECT_EQ((atan_in_turns(number<std::int64_t, 2>(-1))).raw(), 0);
}

TEST(LongWordDomains, AreThoseOfShortFormats) {
  EXPECT_EQ(log(q32_32(0)), std::numeric_limits<q32_32>::lowest());
  EXPECT_EQ(log1p(q32_32(-1)), std::numeric_limits<q32_32>::lowest());
  EXPECT_EQ(rsqrt(q32_32(0)), std::numeric_limits<q32_32>::max());
  EXPECT_EQ(tan_of_degrees(q32_32(-90)), std::numeric_limits<q32_32>::max());
  EXPECT_EQ(tan_of_turns(q32_32(0.75)), std::numeric_limits<q32_32>::max());
  EXPECT_EQ(asin(q32_32(1) + one_unit<q32_32>), 0);
  EXPECT_EQ(acosh(q32_32(1) - one_unit<q32_32>), 0);
  EXPECT_EQ(acosh(q32_32(1)), 0);
  EXPECT_EQ(atanh(q32_32(-1)), 0);
  EXPECT_EQ(pow(q32_32(0), q32_32(-1)), std::numeric_limits<q32_32>::max());
  EXPECT_EQ(pow(q32_32(-1), q32_32(0.5)), 0);
  EXPECT_EQ(pow(q32_32(0), q32_32(0)), 1);
  EXPECT_EQ(exp(fixproof::q48_16(100000)), std::numeric_limits<fixproof::q48_16>::max());
  using trapping = fixproof::with_policy<q32_32, fixproof::policies::trapping>;
  EXPECT_THROW(static_cast<void>(exp(trapping(100))), fixproof::overflow_error);
  EXPECT_THROW(static_cast<void>(log(trapping(0))), fixproof::domain_error);
  EXPECT_THROW(static_cast<void>(acosh(trapping(0))), fixproof::domain_error);
}

// Results of another format have the same code; q2_62 and q16_16 are enough for its two ways.
static_assert(exp<q32_32>(fixproof::q16_16(1)) == exp(q32_32(1)));
static_assert(sin<fixproof::q2_62>(q16_48(1)).raw() == 3880599975550901256);  // ...256.2
static_assert(log2<fixproof::q16_16>(fixproof::u0_64::from_raw(1)) == -64);

}  // namespace
}  // namespace long_words_test
