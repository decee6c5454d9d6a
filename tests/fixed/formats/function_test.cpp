/// Tests the functions of real numbers against the oracle, in formats of every width and with
/// fraction bits at both ends.
#include "oracle/function.hpp"

#include "fixed/angle.hpp"
#include "fixed/constants.hpp"
#include "fixed/exponential.hpp"
#include "fixed/fixed.hpp"
#include "fixed/literals.hpp"
#include "fixed/power.hpp"
#include "fixed/trigonometry.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using oracle::Function;
using oracle::Integer;

template <class N>
struct Named {
  Function function;
  const char* name;
  N (*compute)(N x, N y);
};

template <class N>
constexpr std::array unary{
    Named<N>{Function::exp2, "exp2", [](N x, N) { return exp2(x); }},
    Named<N>{Function::exp, "exp", [](N x, N) { return exp(x); }},
    Named<N>{Function::expm1, "expm1", [](N x, N) { return expm1(x); }},
    Named<N>{Function::log2, "log2", [](N x, N) { return log2(x); }},
    Named<N>{Function::log, "log", [](N x, N) { return log(x); }},
    Named<N>{Function::log10, "log10", [](N x, N) { return log10(x); }},
    Named<N>{Function::log1p, "log1p", [](N x, N) { return log1p(x); }},
    Named<N>{Function::sinh, "sinh", [](N x, N) { return sinh(x); }},
    Named<N>{Function::cosh, "cosh", [](N x, N) { return cosh(x); }},
    Named<N>{Function::tanh, "tanh", [](N x, N) { return tanh(x); }},
    Named<N>{Function::sin, "sin", [](N x, N) { return sin(x); }},
    Named<N>{Function::cos, "cos", [](N x, N) { return cos(x); }},
    Named<N>{Function::tan, "tan", [](N x, N) { return tan(x); }},
    Named<N>{Function::sin_of_degrees, "sin_of_degrees", [](N x, N) { return sin_of_degrees(x); }},
    Named<N>{Function::cos_of_degrees, "cos_of_degrees", [](N x, N) { return cos_of_degrees(x); }},
    Named<N>{Function::tan_of_degrees, "tan_of_degrees", [](N x, N) { return tan_of_degrees(x); }},
    Named<N>{Function::sin_of_turns, "sin_of_turns", [](N x, N) { return sin_of_turns(x); }},
    Named<N>{Function::cos_of_turns, "cos_of_turns", [](N x, N) { return cos_of_turns(x); }},
    Named<N>{Function::tan_of_turns, "tan_of_turns", [](N x, N) { return tan_of_turns(x); }},
    Named<N>{Function::asin, "asin", [](N x, N) { return asin(x); }},
    Named<N>{Function::acos, "acos", [](N x, N) { return acos(x); }},
    Named<N>{Function::atan, "atan", [](N x, N) { return atan(x); }},
    Named<N>{Function::cbrt, "cbrt", [](N x, N) { return cbrt(x); }},
    Named<N>{Function::rsqrt, "rsqrt", [](N x, N) { return rsqrt(x); }},
    Named<N>{Function::reciprocal, "reciprocal", [](N x, N) { return reciprocal(x); }},
};

template <class N>
constexpr std::array binary{
    Named<N>{Function::atan2, "atan2", [](N x, N y) { return atan2(x, y); }},
    Named<N>{Function::hypot, "hypot", [](N x, N y) { return hypot(x, y); }},
    Named<N>{Function::pow, "pow", [](N x, N y) { return pow(x, y); }},
};

/// What the functions return outside their domain.
template <class N>
N outside(Function function, const Integer& x) {
  switch (function) {
    case Function::log2:
    case Function::log:
    case Function::log10:
    case Function::log1p:
      return std::numeric_limits<N>::lowest();
    case Function::rsqrt:
    case Function::reciprocal:
    case Function::tan_of_degrees:
    case Function::tan_of_turns:
      return std::numeric_limits<N>::max();
    case Function::pow:
      return x == 0 ? std::numeric_limits<N>::max() : N();
    default:
      return N();
  }
}

/// The oracle's result in a type that saturates.
template <class N>
N expected(Function function, N x, N y, oracle::Rounding ties) {
  using raw = typename N::raw_type;
  const auto ulps = oracle::nearest(function, x.raw(), y.raw(), N::fraction_bits, ties);
  if (!ulps) return outside<N>(function, x.raw());
  constexpr raw lowest = std::numeric_limits<raw>::min();
  constexpr raw highest = std::numeric_limits<raw>::max();
  if (*ulps < lowest) return N::from_raw(lowest);
  return N::from_raw(*ulps > highest ? highest : static_cast<raw>(*ulps));
}

template <class N, std::size_t Size>
void expect_nearest(const std::array<Named<N>, Size>& functions, N x, N y = N(),
                    oracle::Rounding ties = oracle::Rounding::half_up) {
  for (const Named<N>& f : functions) {
    ASSERT_EQ(+f.compute(x, y).raw(), +expected(f.function, x, y, ties).raw())
        << f.name << " of raw " << +x.raw() << ' ' << +y.raw();
  }
}

template <class N>
class Functions : public testing::Test {
 public:
  using raw = typename N::raw_type;

  /// A word of any length, so that small numbers and their negatives occur too.
  N word() {
    const auto bits = static_cast<std::int64_t>(random_());
    return N::from_raw(static_cast<raw>(bits >> (32 + random_() % 32)));
  }

  static std::vector<N> edges() {
    std::vector<N> words;
    for (int bit = 0; bit <= std::numeric_limits<raw>::digits; ++bit) {
      for (const int off : {-1, 0, 1}) {
        const std::int64_t word = (std::int64_t{1} << bit) + off;
        words.push_back(N::from_raw(static_cast<raw>(word)));
        words.push_back(N::from_raw(static_cast<raw>(-word)));
      }
    }
    return words;
  }

 private:
  std::mt19937_64 random_{1994};
};
using FunctionFormats =
    testing::Types<q8_0, q4_4, q1_7, u4_4, u0_8, q12_4, q8_8, q1_15, u8_8, u0_16, q32_0, q24_8,
                   q16_16, q8_24, q2_30, q1_31, u24_8, u16_16, u1_31, u0_32>;
TYPED_TEST_SUITE(Functions, FunctionFormats);

TYPED_TEST(Functions, OfOneNumberAreNearest) {
  using N = TypeParam;
  if constexpr (sizeof(N) == 1) {
    for (int word = 0; word < 256; ++word) {
      expect_nearest(unary<N>, N::from_raw(static_cast<typename N::raw_type>(word)));
    }
  } else {
    for (const N x : this->edges()) expect_nearest(unary<N>, x);
    for (int i = 0; i < 150; ++i) expect_nearest(unary<N>, this->word());
    // Whole degrees, of which some have rational sines.
    for (int degrees = -360; degrees <= 720; degrees += 15) expect_nearest(unary<N>, N(degrees));
  }
}

TYPED_TEST(Functions, OfTwoNumbersAreNearest) {
  using N = TypeParam;
  for (int i = 0; i < 250; ++i) {
    const N x = this->word();
    // Next to a diagonal, too.
    const auto close =
        static_cast<typename N::raw_type>(x.raw() + static_cast<typename N::raw_type>(i % 3));
    expect_nearest(binary<N>, x, i % 4 == 0 ? N::from_raw(close) : this->word());
  }
  const std::vector<N> edges = this->edges();
  for (std::size_t i = 0; i < edges.size(); i += 5) {
    for (std::size_t k = i % 7; k < edges.size(); k += 7) {
      expect_nearest(binary<N>, edges[i], edges[k]);
    }
  }
  // Powers of which many are rational.
  for (int i = -12; i <= 12; ++i) {
    for (int k = -12; k <= 12; ++k) expect_nearest(binary<N>, N(i) / N(2), N(k) / N(4));
  }
}

}  // namespace
