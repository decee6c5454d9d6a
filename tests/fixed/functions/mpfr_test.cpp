/// Compares the functions with MPFR, which other authors wrote, in 300 digits.
#include <boost/multiprecision/mpfr.hpp>

#include "oracle/real_function.hpp"
#include "tests/fixed/functions/functions.hpp"
#include "tests/fixed/functions/hard_words.hpp"
#include "tests/support/each_type.hpp"
#include "tests/support/paths.hpp"

namespace {

using functions::Format;
/// A number of 300 digits.
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<300>,
                                           boost::multiprecision::et_off>;

/// The result of MPFR, rounded half up and saturated.
std::int64_t by_mpfr(const Format& format, oracle::Function function, std::int64_t x,
                     std::int64_t y) {
  const auto real = [&](std::int64_t raw) { return ldexp(Real(raw), -format.fraction_bits); };
  const Real value = ldexp(oracle::real_function(function, real(x), real(y)), format.fraction_bits);
  // MPFR is off by less than 2^-900, so this makes every tie go up.
  const Real biased = floor(value + 0.5 + ldexp(Real(1), -900));
  if (biased >= format.highest()) return format.highest();
  if (biased <= format.lowest()) return format.lowest();
  return biased.convert_to<std::int64_t>();
}

void expect_equal(const Format& format, std::span<const functions::Name> names, int count) {
  std::mt19937_64 random(1994);
  const auto word = [&] {
    const auto bits = static_cast<std::int64_t>(random());
    return format.raw_of(bits >> (32 + random() % 32));
  };
  for (int i = 0; i < count; ++i) {
    const std::int64_t x = word();
    const std::int64_t y = word();
    for (const auto& [function, name] : names) {
      if (!oracle::in_domain<std::int64_t>(function, x, y, format.fraction_bits)) continue;
      ASSERT_EQ(format.compute(function, x, y), by_mpfr(format, function, x, y))
          << name << " of raw " << x << ' ' << y;
    }
  }
}

const auto every_format = each_type::all<Format>(functions::Formats());

TEST_OF_EACH(Mpfr, GivesTheSameWords, Format, every_format) {
  expect_equal(type, functions::names_of_one, 150);
  expect_equal(type, functions::names_of_two, 500);
}

TEST(MpfrHardWords, HaveTheSameResults) {
  functions::for_each_hard_word(
      paths::source("tests/fixed/functions/hard_words.txt"),
      []<class N>(const functions::HardWord& word) {
        const auto& [function, name] = functions::named(functions::names_of_one, word.function);
        EXPECT_EQ(by_mpfr(Format::of<N>(), function, word.operand, 0), word.result)
            << name << " of raw " << word.operand;
      });
}

}  // namespace
