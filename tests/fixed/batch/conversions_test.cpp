/// Tests conversions from and to floating point on every path, in every rounding mode of the
/// processor, against exact integers and the type.
#include "fixed/batch/conversions.hpp"

#include "fixed/batch/vectorizable.hpp"
#include "tests/fixed/batch/columns.hpp"
#include "tests/fixed/batch/expected.hpp"
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
constexpr fixproof::policy up{.multiply = fixproof::rounding::ceiling};
constexpr fixproof::policy up_and_saturate{.multiply = fixproof::rounding::ceiling,
                                           .range = fixproof::overflow::saturate};

#ifdef FIXPROOF_FEW_TYPES
using number_types = testing::Types<
    fixproof::q16_16, fixproof::q16_16_trapping, fixproof::q16_16_i8088_unrounded,
    fixproof::number<std::int32_t, 16, to_even>, fixproof::number<std::int32_t, 16, up>,
    fixproof::number<std::int16_t, 8, up_and_saturate>,
    fixproof::number<std::int16_t, 8, to_even_and_saturate>, fixproof::number<std::int32_t, 32>,
    fixproof::number<std::uint32_t, 16>, fixproof::number<std::int64_t, 32>>;
#else
using number_types = testing::Types<
    fixproof::q16_16, fixproof::q16_16_saturating, fixproof::q16_16_trapping,
    fixproof::q16_16_i386_unrounded, fixproof::q16_16_i8088, fixproof::q16_16_i8088_unrounded,
    fixproof::q8_8, fixproof::q8_8_saturating, fixproof::number<std::int32_t, 16, to_even>,
    fixproof::number<std::int32_t, 16, up>, fixproof::number<std::int16_t, 8, up_and_saturate>,
    fixproof::number<std::int16_t, 8, to_even_and_saturate>,
    fixproof::number<std::int32_t, 31, fixproof::policies::saturating>,
    fixproof::number<std::int32_t, 32>, fixproof::number<std::uint32_t, 16>,
    fixproof::number<std::int8_t, 3>, fixproof::number<std::int64_t, 32>>;
#endif

/// The number after the highest one, in ulps.
template <class Float>
Float range_end(const Type& type) {
  return std::ldexp(Float{1}, type.bits() - (type.is_signed ? 1 : 0));
}

/// Every exponent, halves and their neighbours, the ends of the range, infinities, NaN, zeros and
/// subnormals.
template <class Float>
std::vector<Float> values(const Type& type) {
  const int fraction_bits = type.fraction_bits;
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
  for (int quarters = -6; quarters <= 6; ++quarters) {
    const Float ulps = range_end<Float>(type) + static_cast<Float>(quarters) / 4;
    all.push_back(std::ldexp(ulps, -fraction_bits));
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

/// The conversions between one number type and one type of floating point.
template <class Float>
struct Conversion {
  Type type;
  Word (*expected)(Float x, Fault& fault);
  Report (*from_floats)(std::span<const Float> x, void* out, const Options& how);
  /// Nothing if the result is out of range.
  std::optional<Word> (*from_one)(Float x);
  Float (*expected_float)(Word x);
  void (*to_floats)(const void* x, std::span<Float> out, fixproof::batch::path path);
};

template <class N, class Float>
Conversion<Float> conversion() {
  return {Type::of<N>(),
          [](Float x, Fault& fault) -> Word {
            const auto want = expected_from<N>(x);
            fault = want.fault;
            return want.value.raw();
          },
          [](std::span<const Float> x, void* out, const Options& how) {
            return fixproof::batch::from_floats(x, numbers<N>(out, x.size()), how);
          },
          [](Float x) -> std::optional<Word> {
            constexpr fixproof::policy rules = [](fixproof::policy p) {
              p.range = fixproof::overflow::trap;
              return p;
            }(N::rules);
            using Trapping = fixproof::number<typename N::raw_type, N::fraction_bits, rules>;
            if (expected_from<Trapping>(x).fault != Fault::none) return std::nullopt;
            return fixproof::vectorizable_from<N>(x).raw();
          },
          [](Word x) { return static_cast<Float>(number_of<N>(x)); },
          [](const void* x, std::span<Float> out, fixproof::batch::path path) {
            fixproof::batch::to_floats(numbers<N>(x, out.size()), out, path);
          }};
}

/// Those of one number type.
struct OfType {
  Conversion<double> doubles;
  Conversion<float> floats;

  friend std::ostream& operator<<(std::ostream& out, const OfType& all) {
    return out << all.doubles.type;
  }
};
constexpr auto conversions_of = []<class N>(std::type_identity<N> /*number*/) -> OfType {
  return {conversion<N, double>(), conversion<N, float>()};
};

class Floats : public testing::TestWithParam<OfType> {};
INSTANTIATE_TEST_SUITE_P(OfEachType, Floats,
                         testing::ValuesIn(of_each(number_types(), conversions_of)));

/// Values in range, so that whole blocks have no fault.
template <class Float>
std::vector<Float> values_in_range(const Conversion<Float>& conversion) {
  std::vector<Float> all = values<Float>(conversion.type);
  std::erase_if(all, [&](Float x) { return !conversion.from_one(x); });
  return all;
}

template <class Float>
void check_from(const Conversion<Float>& conversion, const std::vector<Float>& all) {
  Words expected(all.size());
  std::vector<Fault> expected_faults(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    expected[i] = conversion.expected(all[i], expected_faults[i]);
  }
  const auto check = [&](std::size_t first, std::size_t n, fixproof::batch::path path, int mode) {
    const auto begin = static_cast<std::ptrdiff_t>(first);
    const auto end = static_cast<std::ptrdiff_t>(first + n);
    const Column want(conversion.type, {expected.begin() + begin, expected.begin() + end});
    Column out(conversion.type, n);
    Marked marked(n);
    Report report;
    {
      const RoundingMode set(mode);
      report =
          conversion.from_floats(std::span(all).subspan(first, n), out.at(0), marked.how(path));
    }
    SCOPED_TRACE(testing::Message() << "path " << static_cast<int>(path) << ", mode " << mode);
    if (!same(out, want)) {
      std::size_t i = 0;
      while (i + 1 < n && out[i] == want[i]) ++i;
      FAIL() << same(out, want).message() << ": of " << all[first + i];
    }
    marked.check(report, {expected_faults.begin() + begin, expected_faults.begin() + end});
  };
  for (const auto path : paths()) {
    for (const int mode : RoundingMode::all) check(0, all.size(), path, mode);
    for (std::size_t n = 0; n <= 130; ++n) check(n * 7, n, path, FE_TONEAREST);
  }
  // A single element has code of its own.
  for (const int mode : RoundingMode::all) {
    for (std::size_t i = 0; i < all.size(); ++i) check(i, 1, fixproof::batch::path::fastest, mode);
  }
}

// One NaN among numbers. Blocks are stored before they are tested, and then computed again.
template <class Float>
void check_from_with_one_fault(const Conversion<Float>& conversion) {
  constexpr std::size_t longest = 140;
  constexpr Float nan = std::numeric_limits<Float>::quiet_NaN();
  Fault none{};
  Fault one{};
  const Words words(longest, conversion.expected(Float{1.5}, none));
  const Word of_nan = conversion.expected(nan, one);
  for (std::size_t n = 1; n <= longest; n += n < 40 ? 1 : 12) {
    for (std::size_t at = 0; at < n; ++at) {
      std::vector<Float> x(n, Float{1.5});
      x[at] = nan;
      Words expected(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(n));
      expected[at] = of_nan;
      std::vector<Fault> faults(n, none);
      faults[at] = one;
      const Column want(conversion.type, expected);
      for (const auto path : paths()) {
        Column out(conversion.type, n);
        Marked marked(n);
        const Report report = conversion.from_floats(x, out.at(0), marked.how(path));
        SCOPED_TRACE(testing::Message() << "path " << static_cast<int>(path) << ", " << at);
        ASSERT_TRUE(same(out, want));
        marked.check(report, faults);
      }
    }
  }
}

template <class Float>
void check_from_one(const Conversion<Float>& conversion) {
  std::size_t in_range = 0;
  for (const Float x : values<Float>(conversion.type)) {
    Fault fault{};
    const Word want = conversion.expected(x, fault);
    for (const int mode : RoundingMode::all) {
      std::optional<Word> word;
      {
        const RoundingMode set(mode);
        word = conversion.from_one(x);
      }
      in_range += word ? 1U : 0U;
      ASSERT_EQ(word.value_or(want), want) << "of " << x << ", mode " << mode;
    }
  }
  EXPECT_GT(in_range, 4000U);
}

TEST_P(Floats, BecomeNumbers) {
  const auto& [doubles, floats] = GetParam();
  check_from(doubles, values<double>(doubles.type));
  check_from(floats, values<float>(floats.type));
}

TEST_P(Floats, InRangeBecomeNumbers) {
  const auto& [doubles, floats] = GetParam();
  check_from(doubles, values_in_range(doubles));
  check_from(floats, values_in_range(floats));
}

TEST_P(Floats, BecomeNumbersButOne) {
  check_from_with_one_fault(GetParam().doubles);
  check_from_with_one_fault(GetParam().floats);
}

// Each in a loop of one element.
TEST_P(Floats, BecomeNumbersInLoops) {
  check_from_one(GetParam().doubles);
  check_from_one(GetParam().floats);
}

template <class Float>
void check_to(const Conversion<Float>& conversion) {
  Words x;
  std::mt19937_64 random(3);
  for (int i = 0; i < 2000; ++i) x.push_back(static_cast<Word>(random()));
  for (const int step : {-2, -1, 0, 1, 2, 3}) {
    // About ties of 24 bits, and the ends of the range.
    for (const int bits : {0, 24, 25, 30, 31}) {
      x.push_back((Word{1} << bits) + step);
      x.push_back(-(Word{1} << bits) - step);
    }
  }
  std::vector<Float> want;
  for (const Word word : x) want.push_back(conversion.expected_float(word));
  const Column numbers(conversion.type, x);
  for (const auto path : paths()) {
    for (const int mode : RoundingMode::all) {
      std::vector<std::size_t> counts{x.size()};
      const std::size_t longest = mode == FE_TONEAREST ? 130 : 40;
      for (std::size_t n = 0; n <= longest; ++n) counts.push_back(n);
      for (const std::size_t n : counts) {
        Guarded<Float> out(n);
        {
          const RoundingMode set(mode);
          conversion.to_floats(numbers.at(x.size() - n), out.inside(), path);
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
TEST_P(Floats, ComeFromNumbers) {
  check_to(GetParam().doubles);
  check_to(GetParam().floats);
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
