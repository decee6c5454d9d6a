/// Tests what every function throws under overflow::trap: the domain and the range come from the
/// oracle.
#include <set>
#include <string>

#include "tests/fixed/functions/functions.hpp"
#include "tests/support/thrown.hpp"

namespace error_test {

using namespace fixproof;
using functions::Named;

/// The functions that ended in each way.
using Names = std::set<std::string>;
struct Seen {
  Names domain_errors, overflow_errors;
};

template <class N, std::size_t size>
void expect_endings(const std::array<Named<N>, size>& all, N x, N y, Seen& seen) {
  using limits = std::numeric_limits<typename N::raw_type>;
  for (const Named<N>& f : all) {
    const auto exact =
        oracle::nearest(f.function, x.raw(), y.raw(), N::fraction_bits, oracle::Rounding::half_up);
    const Thrown want = !exact                                             ? Thrown::domain_error
                        : *exact < limits::min() || *exact > limits::max() ? Thrown::overflow_error
                                                                           : Thrown::nothing;
    N result;
    ASSERT_EQ(thrown_by([&] { result = f.compute(x, y); }, f.name), want)
        << f.name << " of raw " << x.raw() << ' ' << y.raw();
    if (want == Thrown::nothing) {
      ASSERT_EQ(result.raw(), *exact) << f.name << " of raw " << x.raw() << ' ' << y.raw();
    }
    if (want == Thrown::domain_error) seen.domain_errors.insert(f.name);
    if (want == Thrown::overflow_error) seen.overflow_errors.insert(f.name);
  }
}

/// The ends of the range, the limits of the domains, and words of any length.
template <class N>
std::vector<N> operands() {
  using raw = typename N::raw_type;
  using limits = std::numeric_limits<raw>;
  std::vector<N> words{std::numeric_limits<N>::lowest(), std::numeric_limits<N>::max()};
  constexpr std::int64_t one = std::int64_t{1} << N::fraction_bits;
  for (const std::int64_t place : {std::int64_t{0}, one, one / 4, one / 2, 11 * one, 90 * one}) {
    for (const std::int64_t off : {-1, 0, 1}) {
      for (const std::int64_t sign : {-1, 1}) {
        const std::int64_t word = sign * (place + off);
        if (word >= limits::min() && word <= limits::max()) {
          words.push_back(N::from_raw(static_cast<raw>(word)));
        }
      }
    }
  }
  std::mt19937_64 random(1994);
  for (int i = 0; i < 40; ++i) {
    const auto bits = static_cast<std::int64_t>(random());
    words.push_back(N::from_raw(static_cast<raw>(bits >> (32 + random() % 32))));
  }
  return words;
}

template <class N>
Seen expect_endings_of_all() {
  Seen seen;
  const std::vector<N> words = operands<N>();
  for (std::size_t i = 0; i < words.size(); ++i) {
    expect_endings(functions::unary<N>, words[i], N(), seen);
    for (std::size_t k = i % 3; k < words.size(); k += 3) {
      expect_endings(functions::binary<N>, words[i], words[k], seen);
    }
  }
  return seen;
}

// The sets are those of the functions that have such operands in the format.
TEST(FunctionErrors, Of16FractionBits) {
  const Seen seen = expect_endings_of_all<q16_16_trapping>();
  EXPECT_EQ(seen.domain_errors,
            (Names{"log", "log2", "log10", "log1p", "rsqrt", "reciprocal", "tan_of_degrees",
                   "tan_of_turns", "asin", "acos", "pow", "acosh", "atanh", "asin_in_degrees",
                   "acos_in_degrees", "asin_in_turns", "acos_in_turns"}));
  EXPECT_EQ(seen.overflow_errors, (Names{"exp", "exp2", "expm1", "sinh", "cosh", "tan_of_degrees",
                                         "reciprocal", "hypot", "pow", "exp10"}));
}

TEST(FunctionErrors, Of30FractionBits) {
  const Seen seen = expect_endings_of_all<number<std::int32_t, 30, policies::trapping>>();
  EXPECT_EQ(seen.domain_errors,
            (Names{"log", "log2", "log10", "log1p", "rsqrt", "reciprocal", "tan_of_turns", "asin",
                   "acos", "pow", "acosh", "atanh", "asin_in_degrees", "acos_in_degrees",
                   "asin_in_turns", "acos_in_turns"}));
  EXPECT_EQ(seen.overflow_errors, (Names{"exp",
                                         "exp2",
                                         "expm1",
                                         "log",
                                         "log2",
                                         "log10",
                                         "log1p",
                                         "sinh",
                                         "cosh",
                                         "tan",
                                         "tan_of_turns",
                                         "acos",
                                         "rsqrt",
                                         "reciprocal",
                                         "atan2",
                                         "hypot",
                                         "pow",
                                         "exp10",
                                         "atanh",
                                         "asin_in_degrees",
                                         "acos_in_degrees",
                                         "atan_in_degrees",
                                         "atan2_in_degrees"}));
}

TEST(FunctionErrors, Of15FractionBitsIn16) {
  const Seen seen = expect_endings_of_all<number<std::int16_t, 15, policies::trapping>>();
  EXPECT_EQ(seen.domain_errors, (Names{"log", "log2", "log10", "log1p", "rsqrt", "reciprocal",
                                       "tan_of_turns", "pow", "acosh", "atanh"}));
  // The cosine of 0 is out of range, and so is the cube root of the highest number.
  EXPECT_EQ(seen.overflow_errors, (Names{"exp",
                                         "exp2",
                                         "expm1",
                                         "log",
                                         "log2",
                                         "log10",
                                         "log1p",
                                         "sinh",
                                         "cosh",
                                         "cos",
                                         "tan",
                                         "cos_of_degrees",
                                         "sin_of_turns",
                                         "cos_of_turns",
                                         "tan_of_turns",
                                         "asin",
                                         "acos",
                                         "cbrt",
                                         "rsqrt",
                                         "reciprocal",
                                         "atan2",
                                         "hypot",
                                         "pow",
                                         "exp10",
                                         "atanh",
                                         "asin_in_degrees",
                                         "acos_in_degrees",
                                         "atan_in_degrees",
                                         "atan2_in_degrees"}));
}

}  // namespace error_test
