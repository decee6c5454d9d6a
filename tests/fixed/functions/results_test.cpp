/// Compares the functions whose result has a format of its own with MPFR, in 300 digits, for each
/// pair of formats.
#include <boost/multiprecision/mpfr.hpp>
#include <cstdlib>
#include <exception>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "fixed/fixed.hpp"
#include "oracle/real_function.hpp"
#include "tests/support/test.hpp"

namespace results_test {

using fixproof::number;
using fixproof::rounding;
using oracle::Function;
/// A number of 300 digits.
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<300>,
                                           boost::multiprecision::et_off>;

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): the names of functions and of enumerators
#define FUNCTIONS(X) \
  X(sin)             \
  X(cos)             \
  X(tan)             \
  X(sin_of_degrees)  \
  X(cos_of_degrees)  \
  X(tan_of_degrees)  \
  X(sin_of_turns)    \
  X(cos_of_turns)    \
  X(tan_of_turns)    \
  X(exp2)            \
  X(exp)             \
  X(expm1)           \
  X(sinh)            \
  X(cosh)            \
  X(tanh)            \
  X(log)             \
  X(log1p)           \
  X(log2)            \
  X(log10)           \
  X(atan)            \
  X(asin)            \
  X(acos)            \
  X(exp10)           \
  X(asinh)           \
  X(acosh)           \
  X(atanh)           \
  X(atan_in_degrees) \
  X(asin_in_degrees) \
  X(acos_in_degrees) \
  X(atan_in_turns)   \
  X(asin_in_turns)   \
  X(acos_in_turns)

#define FUNCTIONS_OF_TWO(X) X(atan2) X(atan2_in_degrees) X(atan2_in_turns)

struct Name {
  Function function;
  const char* name;
};
#define NAME(name) Name{Function::name, #name "<To>"},
constexpr std::array names{FUNCTIONS(NAME) FUNCTIONS_OF_TWO(NAME)};
#undef NAME

template <class To, class From>
std::int64_t call(Function function, std::int64_t x_raw, std::int64_t y_raw) {
  const From x = From::from_raw(static_cast<typename From::raw_type>(x_raw));
  const From y = From::from_raw(static_cast<typename From::raw_type>(y_raw));
#define CASE(name)     \
  case Function::name: \
    return fixproof::name<To>(x).raw();
#define CASE_OF_TWO(name) \
  case Function::name:    \
    return fixproof::name<To>(x, y).raw();
  switch (function) {
    FUNCTIONS(CASE)
    FUNCTIONS_OF_TWO(CASE_OF_TWO)
    default:
      std::abort();
  }
#undef CASE
#undef CASE_OF_TWO
}

/// A format at run time.
struct Format {
  int bits;
  bool is_signed;
  int fraction_bits;
  rounding ties;

  template <class N>
  static Format of() {
    using raw = typename N::raw_type;
    return {8 * sizeof(raw), std::is_signed_v<raw>, N::fraction_bits, N::rules.multiply};
  }

  [[nodiscard]] std::int64_t highest() const {
    return (std::int64_t{1} << (is_signed ? bits - 1 : bits)) - 1;
  }
  [[nodiscard]] std::int64_t lowest() const { return is_signed ? -highest() - 1 : 0; }
  /// The stored integer with the low bits of a word.
  [[nodiscard]] std::int64_t raw_of(std::int64_t word) const {
    const std::int64_t low = word & ((std::int64_t{1} << bits) - 1);
    return low > highest() ? low - (std::int64_t{1} << bits) : low;
  }
};

/// The functions with a result in one format and operands in another.
struct Calls {
  Format to;
  Format from;
  std::int64_t (*call)(Function function, std::int64_t x, std::int64_t y);

  template <class To, class From>
  static Calls of() {
    return {Format::of<To>(), Format::of<From>(), results_test::call<To, From>};
  }
};

/// What docs/functions.md says of operands outside the domain.
std::int64_t outside(const Format& to, Function function) {
  switch (function) {
    case Function::log:
    case Function::log1p:
    case Function::log2:
    case Function::log10:
      return to.lowest();
    case Function::asin:
    case Function::acos:
    case Function::acosh:
    case Function::atanh:
    case Function::asin_in_degrees:
    case Function::acos_in_degrees:
    case Function::asin_in_turns:
    case Function::acos_in_turns:
      return 0;
    default:
      return to.highest();
  }
}

std::int64_t expected(const Calls& calls, Function function, std::int64_t x, std::int64_t y) {
  const Format& to = calls.to;
  const int places = calls.from.fraction_bits;
  if (!oracle::in_domain<std::int64_t>(function, x, y, places)) return outside(to, function);
  const Real value =
      ldexp(oracle::real_function(function, ldexp(Real(x), -places), ldexp(Real(y), -places)),
            to.fraction_bits);
  // MPFR is off by less than 2^-900, so a half that is this near is a tie.
  const Real low = floor(value);
  const Real over = value - low - 0.5;
  const bool is_tie = abs(over) < ldexp(Real(1), -900);
  const bool is_odd = fmod(low, Real(2)) != 0;
  const bool tie_goes_up = to.ties == rounding::half_even   ? is_odd
                           : to.ties == rounding::half_away ? value > 0
                                                            : true;
  const Real nearest = (is_tie ? tie_goes_up : over > 0) ? low + 1 : low;
  if (nearest >= to.highest()) return to.highest();
  if (nearest <= to.lowest()) return to.lowest();
  return nearest.convert_to<std::int64_t>();
}

void expect_equal(const Calls& calls, std::mt19937_64& random) {
  const Format& from = calls.from;
  const auto word = [&](int i) {
    // Whole numbers, whose sines in degrees can be ties, and their neighbours; powers of two.
    if (i % 8 == 0) {
      const auto whole = static_cast<std::int64_t>(random() % 49) * 15 - 360;
      return from.raw_of(whole * (std::int64_t{1} << from.fraction_bits) + i / 8 % 3 - 1);
    }
    if (i % 8 == 1) return from.raw_of((std::int64_t{1} << random() % 33) - 1 + i / 8 % 3);
    const auto bits = static_cast<std::int64_t>(random());
    return from.raw_of(bits >> (32 + random() % 32));
  };
  for (int i = 0; i < 48; ++i) {
    const std::int64_t x = word(i);
    const std::int64_t y = word(i + 3);
    for (const auto& [function, name] : names) {
      // Of atan2(y, x) and its like, the first operand is y.
      ASSERT_EQ(calls.call(function, x, y), expected(calls, function, x, y))
          << name << " of " << x << ' ' << y << " with " << from.fraction_bits
          << " fraction bits, to " << calls.to.fraction_bits << " of " << calls.to.bits;
    }
  }
}

constexpr fixproof::policy even{.multiply = rounding::half_even};
constexpr fixproof::policy away{.multiply = rounding::half_away,
                                .range = fixproof::overflow::saturate};
constexpr fixproof::policy floor_wraps{.multiply = rounding::floor};
using Formats =
    std::tuple<fixproof::q32_0, number<std::int8_t, 0, even>, number<std::int32_t, 0, away>,
               number<std::int16_t, 8, floor_wraps>, fixproof::q16_16, fixproof::u16_16,
               fixproof::q8_24, fixproof::q2_30, fixproof::u1_31, fixproof::u0_32,
               number<std::int32_t, 32>, fixproof::q1_7>;

template <class To, class... From>
std::vector<Calls> from_each(std::tuple<From...>* /*of*/) {
  return {Calls::of<To, From>()...};
}
template <class... To>
std::vector<std::vector<Calls>> to_each(std::tuple<To...>* of) {
  return {from_each<To>(of)...};
}

TEST(FunctionResults, AreNearestInEachFormatFromEach) {
  std::mt19937_64 random(1994);
  for (const auto& row : to_each(static_cast<Formats*>(nullptr))) {
    for (const Calls& calls : row) expect_equal(calls, random);
  }
}

// What a call does is the policy's of the result, and the text shows the operands in their formats.
TEST(FunctionResults, ErrorsFollowThePolicyOfTheResult) {
  using fixproof::q16_16;
  using fixproof::q16_16_trapping;
  using Traps = number<std::int8_t, 7, fixproof::policies::trapping>;
  const auto text = [](const auto& call) {
    try {
      call();
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  EXPECT_EQ(text([] { return sin<Traps>(q16_16(1.5)); }), "fixed-point overflow: sin(1.5)");
  EXPECT_EQ(text([] { return log<Traps>(q16_16(-2)); }), "fixed-point domain error: log(-2)");
  EXPECT_EQ(text([] { return asin<Traps>(q16_16(1.25)); }), "fixed-point domain error: asin(1.25)");
  EXPECT_EQ(text([] { return tan_of_degrees<Traps>(q16_16(90)); }),
            "fixed-point domain error: tan_of_degrees(90)");
  EXPECT_EQ(text([] { return atan2<Traps>(q16_16(2), q16_16(-0.5)); }),
            "fixed-point overflow: atan2(2, -0.5)");
  EXPECT_EQ(log<q16_16>(q16_16_trapping(-2)), std::numeric_limits<q16_16>::lowest());
  EXPECT_EQ(sin<fixproof::q1_7>(q16_16_trapping(1.5)), std::numeric_limits<fixproof::q1_7>::max());
  static_assert(noexcept(exp<q16_16>(q16_16_trapping())) &&
                !noexcept(exp<q16_16_trapping>(q16_16())));
}

// Functions of one format and refusals stay as they are.
template <class To, class... Operands>
constexpr bool has_atan2 = requires(Operands... of) {
  fixproof::atan2<To>(of...);
};
using fixproof::q16_16;
using fixproof::q2_30;
static_assert(has_atan2<q2_30, q16_16, q16_16> && !has_atan2<q2_30, q16_16, q2_30> &&
              !has_atan2<q2_30, q2_30, q16_16>);
static_assert(sin<q16_16>(q16_16(1)) == sin(q16_16(1)) &&
              sin_cos<q2_30>(q16_16(1)).sin == sin<q2_30>(q16_16(1)));

}  // namespace results_test
