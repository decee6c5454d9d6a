/// Tests that the steps with 184 bits are the same in digits of 16 bits as in words, and that the
/// functions have the same results in digits as in words, for every number of fraction bits and
/// every rule for ties.
#include <array>
#include <map>
#include <string>

#include "fixed/detail/arcsine.hpp"
#include "fixed/detail/digit_angle.hpp"
#include "fixed/detail/digit_phase.hpp"
#include "fixed/detail/digit_power.hpp"
#include "fixed/detail/hyperbolic.hpp"
#include "fixed/detail/phase.hpp"
#include "fixed/detail/power.hpp"
#include "tests/fixed/functions/hard_pairs.hpp"
#include "tests/support/test.hpp"

namespace {

namespace words = fixproof::detail;
namespace digits = fixproof::detail::in_digits;
using fixproof::rounding;
using words::angle_unit;
using words::exponential_base;
using words::hyperbola;
using words::logarithm_base;
using words::triangle_side;

/// All bits of digits, or the lower 224 of words.
std::array<std::uint64_t, 4> bits_of(const digits::real& x) {
  digits::real rest = x;
  std::array<std::uint64_t, 4> bits{};
  for (std::uint64_t& part : bits) {
    part = static_cast<std::uint64_t>(rest.units());
    rest.shift(-64);
  }
  return bits;
}
std::array<std::uint64_t, 4> bits_of(const words::real& x) {
  return {x.word(0), x.word(1), x.word(2), x.word(3)};
}

/// The same number twice.
struct Both {
  words::real word;
  digits::real digit;

  Both(std::int64_t integer, int places)
      : word(words::real{integer} << places), digit(digits::scaled_integer(integer, places)) {}
};

void expect_same(const words::real& word, const digits::real& digit, const Both& of) {
  ASSERT_EQ(bits_of(word), bits_of(digit)) << std::hex << bits_of(of.word)[0] << ' '
                                           << bits_of(of.word)[1] << ' ' << bits_of(of.word)[2];
}

class Digits : public testing::Test {
 public:
  /// From 0 to 2^bits - 1, of any length.
  std::int64_t positive(int bits) {
    const int length = static_cast<int>(random_() % static_cast<unsigned>(bits)) + 1;
    return static_cast<std::int64_t>(random_() >> (64 - length));
  }
  std::int64_t any(int bits) { return random_() % 2 == 0 ? positive(bits) : -positive(bits); }
  int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }

 private:
  std::mt19937_64 random_{1994};
};

TEST_F(Digits, SumsProductsQuotientsAndShiftsAreThoseOfWords) {
  for (int i = 0; i < 5000; ++i) {
    // a is up to 2 in magnitude and b up to 2^13, with bits at both ends.
    Both a(any(46), 139);
    const Both low(any(62), below(100));
    a.word = a.word + low.word;
    a.digit += low.digit;
    Both b(positive(58), 139);
    const Both lower(positive(62), below(100));
    b.word = b.word + lower.word;
    b.digit += lower.digit;

    digits::real result = a.digit;
    result -= b.digit;
    expect_same(a.word - b.word, result, a);
    result.negate();
    expect_same(b.word - a.word, result, a);
    result = a.digit;
    result *= b.digit;
    expect_same(product(a.word, b.word), result, a);
    const int places = below(200);
    result = a.digit;
    result.shift(-places);
    expect_same(a.word >> places, result, a);
    result = lower.digit;
    result.shift(places % 60);
    expect_same(lower.word << places % 60, result, lower);

    const auto n = static_cast<digits::digit>(below(65535) + 1);
    result = b.digit;
    result /= n;
    expect_same(words::quotient(b.word, n), result, b);
    const Both divisor(positive(30) + 1, 165 + below(15));
    result = b.digit;
    result /= divisor.digit;
    expect_same(words::ratio(b.word, divisor.word), result, divisor);
  }
}

TEST_F(Digits, PartsAreThoseOfWords) {
  for (int i = 0; i < 300; ++i) {
    Both x(i == 0 ? std::numeric_limits<std::int64_t>::max() : positive(63), 121);
    digits::real power = x.digit;
    digits::raise_two(power);
    expect_same(words::precise_power(x.word), power, x);

    digits::real angle = x.digit;
    digits::take_arctangent(angle);
    expect_same(words::precise_arctangent(x.word), angle, x);

    x.word = product(x.word, words::real_from(words::real_pi) >> 1);
    x.digit *= digits::half_pi;
    const words::precise_sine_and_cosine both = words::precise_sine_of(x.word);
    digits::real sine = x.digit;
    digits::take_sine(sine, false);
    expect_same(both.sine, sine, x);
    digits::real cosine = x.digit;
    digits::take_sine(cosine, true);
    expect_same(both.cosine, cosine, x);

    const std::int64_t m = (std::int64_t{1} << 32) + positive(32);
    expect_same(words::precise_logarithm(static_cast<std::uint64_t>(m)), digits::logarithm_of(m, 0),
                x);
    const auto squares = static_cast<std::uint64_t>(any(63));
    expect_same(words::precise_side(squares, 32), digits::root_of(squares, 0), x);
  }
  digits::real quarter = digits::real_one;
  digits::take_arctangent(quarter);
  EXPECT_EQ(bits_of(words::precise_arctangent(words::real_one)), bits_of(quarter));
}

/// The distance of a short number from a long one is below 2^-bits.
void expect_near(digits::real is_short, const digits::real& is_long, int bits = 77) {
  ASSERT_NE(is_short.lowest(), 0);
  is_short.use_from(0);
  is_short -= is_long;
  if (is_short.negative()) is_short.negate();
  is_short -= digits::scaled_integer(1, digits::real_bits - bits);
  ASSERT_TRUE(is_short.negative());
}

TEST_F(Digits, ShortPartsHaveTheirError) {
  // The lowest bit of an operand is 2^-63, that of a word 2^-32.
  const auto check = [](const digits::real& x, const auto& take) {
    digits::real is_long = x;
    take(is_long);
    digits::real is_short = x;
    is_short.use_from(digits::short_digit);
    take(is_short);
    expect_near(is_short, is_long);
  };
  for (int i = 0; i < 500; ++i) {
    const std::int64_t highest = std::numeric_limits<std::int64_t>::max();
    const digits::real x = digits::scaled_integer(i == 0 ? highest : positive(63), 121);
    check(x, [](digits::real& power) { digits::raise_two(power); });
    check(x, [](digits::real& angle) { digits::take_arctangent(angle); });
    check(x, [](digits::real& part) { part = digits::sine_of(part, false); });
    check(x, [](digits::real& part) { part = digits::sine_of(part, true); });
    check(x, [](digits::real& n) {
      n /= digits::scaled_integer(3, digits::real_bits - 1, n.lowest());
    });
    const std::int64_t m = (std::int64_t{1} << 32) + (i == 0 ? 0xffffffff : positive(32));
    expect_near(digits::logarithm_of(m, digits::short_digit), digits::logarithm_of(m, 0));
    const auto squares = static_cast<std::uint64_t>(any(63));
    expect_near(digits::root_of(squares, digits::short_digit), digits::root_of(squares, 0));

    const std::int64_t raw = any(32);
    const int fraction_bits = below(33);
    for (const angle_unit unit : {angle_unit::radian, angle_unit::degree, angle_unit::turn}) {
      const auto is_short = digits::phase_of(raw, fraction_bits, unit, digits::short_digit);
      const auto is_long = digits::phase_of(raw, fraction_bits, unit, 0);
      ASSERT_EQ(is_short.quarters, is_long.quarters) << raw << ' ' << fraction_bits;
      expect_near(is_short.part, is_long.part, 88 - 33 + fraction_bits);
    }
  }
}

TEST_F(Digits, PhasesAreThoseOfWords) {
  for (int i = 0; i < 1000; ++i) {
    const std::int64_t raw = any(32);
    const int fraction_bits = below(33);
    const auto check = [&](const auto& word, angle_unit unit) {
      digits::phase digit = digits::phase_of(raw, fraction_bits, unit, 0);
      digit.part *= digits::half_pi;
      ASSERT_EQ(word.quarters, static_cast<unsigned>(digit.quarters) % 4) << raw;
      ASSERT_EQ(bits_of(word.rest), bits_of(digit.part)) << raw << ' ' << fraction_bits;
    };
    check(words::precise_phase_of<angle_unit::radian>(raw, fraction_bits), angle_unit::radian);
    check(words::precise_phase_of<angle_unit::degree>(raw, fraction_bits), angle_unit::degree);
    check(words::precise_phase_of<angle_unit::turn>(raw, fraction_bits), angle_unit::turn);
  }
}

/// A function in words and in digits, of x, y, their fraction bits f and those of the result, g. It
/// takes words of at most 32 bits, or their magnitudes.
struct Named {
  const char* name;
  std::int64_t (*in_words)(std::int64_t, std::int64_t, int, int);
  std::int64_t (*in_digits)(std::int64_t, std::int64_t, int, int);
};

std::uint64_t magnitude(std::int64_t x) { return static_cast<std::uint64_t>(x < 0 ? -x : x); }

/// x in units of 2^-32 and limited to +-64, as the functions of exponential.hpp take it.
std::int64_t units(std::int64_t x, int fraction_bits) {
  const std::int64_t limit = std::int64_t{64} << fraction_bits;
  return std::clamp(x, -limit, limit) * (std::int64_t{1} << (32 - fraction_bits));
}

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): the same call in two namespaces
#define BOTH(name, ...)                                                            \
  Named {                                                                          \
    name,                                                                          \
        []([[maybe_unused]] std::int64_t x, [[maybe_unused]] std::int64_t y,       \
           [[maybe_unused]] int f,                                                 \
           [[maybe_unused]] int g) -> std::int64_t { return words::__VA_ARGS__; }, \
        []([[maybe_unused]] std::int64_t x, [[maybe_unused]] std::int64_t y,       \
           [[maybe_unused]] int f,                                                 \
           [[maybe_unused]] int g) -> std::int64_t { return digits::__VA_ARGS__; } \
  }

template <rounding R>
const std::array of_any{
    BOTH("exp2", nearest_exponential<exponential_base::two, R>(units(x, f), g)),
    BOTH("exp", nearest_exponential<exponential_base::e, R>(units(x, f), g)),
    BOTH("sinh", nearest_hyperbolic<hyperbola::sine>(units(x < 0 ? -x : x, f), g)),
    BOTH("cosh", nearest_hyperbolic<hyperbola::cosine>(units(x < 0 ? -x : x, f), g)),
    BOTH("tanh", nearest_hyperbolic_tangent(units(x < 0 ? -x : x, f), g)),
    BOTH("sin", nearest_sine_of<angle_unit::radian, R>(x, 0, f, g)),
    BOTH("cos", nearest_sine_of<angle_unit::radian, R>(x, 1, f, g)),
    BOTH("sin_of_degrees", nearest_sine_of<angle_unit::degree, R>(x, 0, f, g)),
    BOTH("cos_of_degrees", nearest_sine_of<angle_unit::degree, R>(x, 1, f, g)),
    BOTH("sin_of_turns", nearest_sine_of<angle_unit::turn, R>(x, 0, f, g)),
    BOTH("cos_of_turns", nearest_sine_of<angle_unit::turn, R>(x, 1, f, g)),
    BOTH("tan", nearest_tangent<angle_unit::radian>(x, f, g)),
    BOTH("is_pole of degrees", is_pole<angle_unit::degree>(x, f) ? 1 : 0),
    BOTH("is_pole of turns", is_pole<angle_unit::turn>(x, f) ? 1 : 0),
    BOTH("atan", nearest_angle(x, std::int64_t{1} << f, g)),
    BOTH("atan2", nearest_angle(y, x, g)),
    BOTH("cbrt", nearest_cube_root(magnitude(x), f)),
};

const std::array of_angles{
    BOTH("tan_of_degrees", nearest_tangent<angle_unit::degree>(x, f, g)),
    BOTH("tan_of_turns", nearest_tangent<angle_unit::turn>(x, f, g)),
};

template <rounding R>
const std::array of_positive{
    BOTH("log2", nearest_logarithm<logarithm_base::two>(magnitude(x), f, g)),
    BOTH("log", nearest_logarithm<logarithm_base::e>(magnitude(x), f, g)),
    BOTH("log10", nearest_logarithm<logarithm_base::ten>(magnitude(x), f, g)),
    BOTH("rsqrt", nearest_reciprocal_root<R>(magnitude(x), f)),
};

// `floor` is the rule for ties of negative powers.
template <rounding R>
const std::array powers{
    BOTH("pow", nearest_real_power<R>(magnitude(x), y, f)),
};

const std::array of_unit{
    BOTH("asin", nearest_triangle_angle<triangle_side::sine>(x, f, g)),
    BOTH("acos", nearest_triangle_angle<triangle_side::cosine>(x, f, g)),
};
#undef BOTH

template <std::size_t Size>
void expect_same(const std::array<Named, Size>& functions, std::int64_t x, std::int64_t y, int f,
                 int g) {
  // Beyond every format, results may differ.
  constexpr std::int64_t beyond = std::int64_t{1} << 33;
  for (const Named& each : functions) {
    ASSERT_EQ(std::clamp(each.in_words(x, y, f, g), -beyond, beyond),
              std::clamp(each.in_digits(x, y, f, g), -beyond, beyond))
        << each.name << " of " << x << ' ' << y << ' ' << f << ' ' << g;
  }
}

template <rounding R>
void expect_same_functions(std::int64_t x, std::int64_t y, int f, int g) {
  expect_same(of_any<R>, x, y, f, g);
  // Where words and digits agree on the poles
  if (!words::is_pole<angle_unit::degree>(x, f) && !words::is_pole<angle_unit::turn>(x, f)) {
    expect_same(of_angles, x, y, f, g);
  }
  if (x != 0) expect_same(of_positive<R>, x, y, f, g);
  if (x != 0) expect_same(powers<R>, x, y, f, g);
  if (magnitude(x) <= std::uint64_t{1} << f) expect_same(of_unit, x, y, f, g);
}

TEST_F(Digits, FunctionsAreThoseOfWords) {
  constexpr std::int64_t highest = std::numeric_limits<std::uint32_t>::max();
  constexpr std::int64_t lowest = std::numeric_limits<std::int32_t>::min();
  for (int i = 0; i < 4000; ++i) {
    const int f = below(33);
    const int g = below(2) == 0 ? f : below(33);
    std::int64_t x = any(32);
    std::int64_t y = any(32);
    // Next to powers of two, and numbers whose powers, sines and poles are rational
    if (i % 5 == 0) x = (std::int64_t{1} << below(33)) + below(3) - 1;
    if (i % 7 == 0) x = (below(720) - 360) * (std::int64_t{1} << f);
    if (i % 11 == 0) x = (below(200) - 100) * (std::int64_t{1} << below(f + 1));
    if (i % 3 == 0) y = (below(33) - 16) * (std::int64_t{1} << f) / 4;
    x = std::clamp(x, lowest, highest);
    y = std::clamp(y, lowest, highest);
    if (i % 4 == 0) {
      expect_same_functions<rounding::half_even>(x, y, f, g);
    } else if (i % 4 == 1) {
      expect_same_functions<rounding::half_away>(x, y, f, g);
    } else if (i % 4 == 2) {
      expect_same_functions<rounding::half_up>(x, y, f, g);
    } else if (x != 0) {
      expect_same(powers<rounding::floor>, x, y, f, g);
    }
  }
}

// Small operands have all ties: 1.5^2 is 4.5 halves.
TEST_F(Digits, TiesAreThoseOfWords) {
  for (int f = 0; f < 4; ++f) {
    for (std::int64_t x = 1; x <= 64; ++x) {
      for (int quarters = -12; quarters <= 12; ++quarters) {
        const std::int64_t y = quarters * (std::int64_t{1} << f) / 4;
        expect_same(powers<rounding::half_up>, x, y, f, f);
        expect_same(powers<rounding::half_even>, x, y, f, f);
        expect_same(powers<rounding::floor>, x, y, f, f);
      }
      for (int g = 0; g < 4; ++g) {
        for (const std::int64_t either : {x, -x}) {
          expect_same_functions<rounding::half_up>(either, 1, f, g);
          expect_same_functions<rounding::half_even>(either, 1, f, g);
          expect_same_functions<rounding::half_away>(either, 1, f, g);
        }
      }
    }
  }
}

TEST_F(Digits, HardPairsAreThoseOfTheFiles) {
  const std::map<std::string, int> fraction_bits{
      {"q8_8", 8}, {"q16_16", 16}, {"q24_8", 8}, {"q8_24", 24}, {"q2_30", 30}};
  std::size_t pairs = 0;
  for (const char* name : {"hard_pairs.txt", "hard_pairs_32.txt"}) {
    for (const functions::HardPair& pair : functions::hard_pairs(name)) {
      ASSERT_TRUE(fraction_bits.contains(pair.format)) << name << ": format " << pair.format;
      ASSERT_EQ(digits::nearest_angle(pair.y, pair.x, fraction_bits.at(pair.format)), pair.result)
          << pair.format << ' ' << pair.y << ' ' << pair.x;
      ++pairs;
    }
  }
  EXPECT_EQ(pairs, 2687U);
}

}  // namespace
