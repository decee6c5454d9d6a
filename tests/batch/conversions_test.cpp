/// Tests conversions from and to floating point on every path, in every rounding mode of the
/// processor, against exact integers and the type.
#include "batch/conversions.hpp"

#include "tests/batch/expected.hpp"
#include "tests/fixed/exact.hpp"
#include "tests/fixed/floats.hpp"
#include "tests/fixed/types.hpp"
#include "tests/support/rounding_mode.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

constexpr fixproof::policy to_even{.multiply = fixproof::rounding::half_even};
constexpr fixproof::policy to_even_and_saturate{.multiply = fixproof::rounding::half_even,
                                                .range = fixproof::overflow::saturate};

template <class Number>
class Floats : public testing::Test {};
using number_types =
    testing::Types<fixproof::q16_16, fixproof::q16_16_saturating, fixproof::q16_16_trapping,
                   fixproof::q16_16_i386_unrounded, fixproof::q16_16_i8088,
                   fixproof::q16_16_i8088_unrounded, fixproof::q8_8, fixproof::q8_8_saturating,
                   fixproof::number<std::int32_t, 16, to_even>,
                   fixproof::number<std::int16_t, 8, to_even_and_saturate>,
                   fixproof::number<std::int32_t, 31, fixproof::policies::saturating>,
                   fixproof::number<std::int32_t, 32>, fixproof::number<std::uint32_t, 16>,
                   fixproof::number<std::int8_t, 3>, fixproof::number<std::int64_t, 32>>;
TYPED_TEST_SUITE(Floats, number_types);

/// Every exponent, halves and their neighbours, infinities, NaN, zeros and subnormals.
template <class Float>
std::vector<Float> values(int fraction_bits) {
  using limits = std::numeric_limits<Float>;
  std::vector<Float> all{0,
                         limits::infinity(),
                         limits::quiet_NaN(),
                         limits::denorm_min(),
                         limits::min(),
                         limits::max(),
                         std::nextafter(limits::min(), Float{0})};
  std::mt19937_64 random(9);
  for (int exponent = -70; exponent < 100; ++exponent) {
    for (int i = 0; i < 24; ++i) {
      // Significands of few bits are ties and integers.
      const auto significand = static_cast<Float>(random() >> (i % 2 == 0 ? 40 : 60) | 1U);
      all.push_back(std::ldexp(significand, exponent - fraction_bits));
    }
  }
  for (int i = 0; i < 200; ++i) {
    const Float half =
        (static_cast<Float>(random() % 70000) + Float{0.5}) / std::ldexp(Float{1}, fraction_bits);
    all.insert(all.end(), {half, std::nextafter(half, Float{0}), std::nextafter(half, 2 * half)});
  }
  const std::size_t positive = all.size();
  for (std::size_t i = 0; i < positive; ++i) all.push_back(-all[i]);
  std::shuffle(all.begin(), all.end(), random);
  return all;
}

template <class Number, class Float>
Expected<Number> expected_from(Float x) {
  using limits = std::numeric_limits<Number>;
  constexpr fixproof::policy P = Number::rules;
  using Quiet = fixproof::number<typename Number::raw_type, Number::fraction_bits, quiet(P)>;
  using Loud = fixproof::number<typename Number::raw_type, Number::fraction_bits, loud(P)>;
  constexpr Fault beyond = P.range == fixproof::overflow::wrap ? Fault::none : Fault::overflow;
  // By their bits, because -ffast-math takes infinities and NaN for impossible.
  const auto [m, e] = floats::take_apart(x);
  constexpr int digits = std::numeric_limits<Float>::digits;
  if (e == std::numeric_limits<Float>::max_exponent - digits + 1) {
    if (std::abs(m) != std::int64_t{1} << (digits - 1)) return {Number(), Fault::domain_error};
    return {m > 0 ? limits::max() : limits::lowest(), beyond};
  }
  return {Number::from_raw(floats::converted<Quiet>(x).raw),
          floats::converted<Loud>(x).throws ? Fault::overflow : Fault::none};
}

template <class Number, class Float>
void check_from() {
  const std::vector<Float> all = values<Float>(Number::fraction_bits);
  std::vector<Expected<Number>> expected;
  for (const Float x : all) expected.push_back(expected_from<Number>(x));
  const auto check = [&](std::size_t first, std::size_t n, fixproof::batch::path path, int mode) {
    std::vector<Fault> faults;
    for (std::size_t i = 0; i < n; ++i) faults.push_back(expected[first + i].fault);
    Guarded<Number> out(n);
    Marked marked(n);
    fixproof::batch::report report;
    {
      const RoundingMode set(mode);
      report = fixproof::batch::from_floats(std::span(all).subspan(first, n), out.inside(),
                                            marked.how(path));
    }
    for (std::size_t i = 0; i < n; ++i) {
      ASSERT_EQ(out.inside()[i].raw(), expected[first + i].value.raw())
          << all[first + i] << ", path " << static_cast<int>(path) << ", mode " << mode << ", " << i
          << " of " << n;
    }
    marked.check(report, faults);
    ASSERT_TRUE(out.intact());
  };
  for (const auto path : paths()) {
    for (const int mode : RoundingMode::all) check(0, all.size(), path, mode);
    for (std::size_t n = 0; n <= 130; ++n) check(n * 7, n, path, FE_TONEAREST);
  }
}

TYPED_TEST(Floats, BecomeNumbers) {
  check_from<TypeParam, double>();
  check_from<TypeParam, float>();
}

template <class Number, class Float>
void check_to() {
  using raw = typename Number::raw_type;
  std::vector<Number> x;
  std::mt19937_64 random(3);
  for (int i = 0; i < 2000; ++i) x.push_back(Number::from_raw(static_cast<raw>(random())));
  for (const int step : {-2, -1, 0, 1, 2, 3}) {
    // About ties of 24 bits, and the ends of the range.
    for (const int bits : {0, 24, 25, 30, 31}) {
      x.push_back(Number::from_raw(static_cast<raw>((std::int64_t{1} << bits) + step)));
      x.push_back(Number::from_raw(static_cast<raw>(-(std::int64_t{1} << bits) - step)));
    }
  }
  std::vector<Float> want;
  for (const Number n : x) want.push_back(static_cast<Float>(n));
  for (const auto path : paths()) {
    for (const int mode : RoundingMode::all) {
      std::vector<std::size_t> counts{x.size()};
      for (std::size_t n = 0; n <= 40; ++n) counts.push_back(n);
      for (const std::size_t n : counts) {
        Guarded<Float> out(n);
        {
          const RoundingMode set(mode);
          fixproof::batch::to_floats(std::span(x).last(n), out.inside(), path);
        }
        // Bits, for the sign of zero.
        ASSERT_TRUE(n == 0 ||
                    std::memcmp(out.inside().data(), &want[x.size() - n], n * sizeof(Float)) == 0)
            << "path " << static_cast<int>(path) << ", mode " << mode << ", " << n;
        ASSERT_TRUE(out.intact());
      }
    }
  }
}

// The float of one number is tested in tests/fixed.
TYPED_TEST(Floats, ComeFromNumbers) {
  check_to<TypeParam, double>();
  check_to<TypeParam, float>();
}

TEST(FloatErrors, NameTheFirstElement) {
  const std::vector<double> x{1, 2, 3e9, 4e9};
  std::vector<fixproof::q16_16_trapping> out(4);
  try {
    fixproof::batch::from_floats(x, out);
    ADD_FAILURE() << "no error";
  } catch (const fixproof::overflow_error& error) {
    EXPECT_STREQ(error.what(), "fixed-point overflow: from_floats(element 2, 2 in all)");
  }
}

}  // namespace
}  // namespace batch_test
