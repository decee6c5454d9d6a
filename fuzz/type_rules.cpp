#include "fuzz/type_rules.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>
#include <type_traits>

#include "fixed/fixed.hpp"
#include "oracle/decimal.hpp"
#include "oracle/unbounded.hpp"

namespace fixproof::fuzz {

namespace {

using fixed::overflow;
using fixed::policy;
using oracle::Integer;
using oracle::Word;
/// A word, or nothing where there is an exception.
using Said = std::optional<Word>;

constexpr oracle::Rounding rule_of(fixed::rounding rule) {
  switch (rule) {
    case fixed::rounding::half_up:
      return oracle::Rounding::half_up;
    case fixed::rounding::half_away:
      return oracle::Rounding::half_away;
    case fixed::rounding::floor:
      return oracle::Rounding::floor;
    case fixed::rounding::truncate:
      break;
  }
  return oracle::Rounding::truncate;
}

/// One width and policy on one case.
template <int F, policy P>
class Trial {
 public:
  explicit Trial(std::span<const std::uint32_t, 3> words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      words_[i] = words[i] & mask;
      numbers_[i] = Number::from_raw(static_cast<typename Number::raw_type>(words_[i]));
      units_[i] = oracle::ulps(words_[i], F);
    }
    wide_ = std::uint64_t{words[0]} << 32U | words[1];
  }

  std::optional<std::string> all() {
    quotient();
    sums();
    whole_numbers();
    comparisons();
    from_elsewhere();
    return difference_;
  }

  std::optional<std::string> quotient_only() {
    quotient();
    return difference_;
  }

 private:
  using Number = fixed::number<F, P>;
  static constexpr int bits = 2 * F;
  static constexpr Word mask = ~Word{0} >> (32 - bits);
  static constexpr oracle::Rounding multiply = rule_of(P.multiply);

  static Said in_range(const Integer& exact) {
    switch (P.range) {
      case overflow::wrap:
        break;
      case overflow::saturate:
        return oracle::saturate(exact, bits);
      case overflow::trap:
        if (!oracle::fits(exact, bits)) return std::nullopt;
    }
    return oracle::wrap(exact, bits);
  }

  /// The end of the range that stands for what has no value.
  static Said end(bool negative) {
    if (P.range == overflow::trap) return std::nullopt;
    return oracle::saturate(negative ? Integer(-1) << bits : Integer(1) << bits, bits);
  }

  static Word word_of(Number x) {
    return static_cast<std::make_unsigned_t<typename Number::raw_type>>(x.raw());
  }

  template <class Make>
  static Said said(Make make) {
    try {
      return word_of(make());
    } catch (const fixed::overflow_error&) {
    } catch (const fixed::divide_error&) {
    } catch (const fixed::domain_error&) {
    }
    return std::nullopt;
  }

  template <class Make>
  void expect(std::string_view what, Said expected, Make make) {
    const Said got = said(make);
    if (got == expected || difference_) return;
    const auto text = [](Said word) {
      return word ? fmt::format("{:0{}x}", *word, bits / 4) : std::string("an exception");
    };
    difference_ = fmt::format(
        "fixed::number<{}, policy{{.multiply = {}, .divide = {}, .range = {}}}>: {} is {}, the "
        "oracle says {}\n  a b c       {:08x} {:08x} {:08x}",
        F, static_cast<int>(P.multiply), static_cast<int>(P.divide), static_cast<int>(P.range),
        what, text(got), text(expected), words_[0], words_[1], words_[2]);
  }

  void expect_true(std::string_view what, bool holds) {
    expect(what, Said(0), [holds] { return Number::from_raw(holds ? 0 : 1); });
  }

  void quotient() {
    const Number a = numbers_[0], b = numbers_[1];
    const auto exact = oracle::exact_quotient(words_[0], words_[1], rule_of(P.divide), F);
    const Said by_zero = units_[0] == 0 && P.range != overflow::trap ? Said(0) : end(units_[0] < 0);
    const Said expected = exact ? in_range(*exact) : by_zero;
    expect("a / b", expected, [&] { return a / b; });
    const auto tried = fixed::try_divide(a, b);
    expect_true("whether try_divide(a, b) has a value",
                tried.has_value() == (exact && expected.has_value()));
    if (tried) expect("try_divide(a, b)", expected, [&] { return *tried; });
  }

  void sums() {
    const Number a = numbers_[0], b = numbers_[1], c = numbers_[2];
    const Integer& x = units_[0];
    const Integer& y = units_[1];
    expect("a + b", in_range(x + y), [&] { return a + b; });
    expect("a - b", in_range(x - y), [&] { return a - b; });
    expect("-a", in_range(-x), [&] { return -a; });
    expect("a * b", in_range(oracle::exact_product(words_[0], words_[1], multiply, F)),
           [&] { return a * b; });
    expect("mul_add(a, b, c)",
           in_range(oracle::exact_mul_add(words_[0], words_[1], words_[2], multiply, F)),
           [&] { return mul_add(a, b, c); });
    expect("lerp(a, b, c)",
           in_range(oracle::exact_lerp(words_[0], words_[1], words_[2], multiply, F)),
           [&] { return lerp(a, b, c); });
    const std::array<Number, 3> turned{b, c, a};
    const std::array<Word, 3> turned_words{words_[1], words_[2], words_[0]};
    expect("dot({a, b, c}, {b, c, a})",
           in_range(oracle::exact_dot(words_, turned_words, multiply, F)),
           [&] { return dot(numbers_, turned); });
    const auto assigned = [&](auto operation) {
      return [this, operation] {
        Number changed = numbers_[0];
        operation(changed);
        return changed;
      };
    };
    expect("a += b", in_range(x + y), assigned([&](Number& n) { n += b; }));
    expect("a -= b", in_range(x - y), assigned([&](Number& n) { n -= b; }));
    expect("a *= b", in_range(oracle::exact_product(words_[0], words_[1], multiply, F)),
           assigned([&](Number& n) { n *= b; }));
    if (const auto exact = oracle::exact_quotient(words_[0], words_[1], rule_of(P.divide), F)) {
      expect("a /= b", in_range(*exact), assigned([&](Number& n) { n /= b; }));
    }
  }

  void whole_numbers() {
    const Number a = numbers_[0];
    const Integer& x = units_[0];
    const Integer one = oracle::one(F);
    using enum oracle::Rounding;
    const auto whole = [&](oracle::Rounding rule) { return oracle::rounded(x, one, rule); };
    expect("floor(a)", in_range(whole(floor) * one), [&] { return fixed::floor(a); });
    expect("ceil(a)", in_range(-oracle::rounded(-x, one, floor) * one),
           [&] { return fixed::ceil(a); });
    expect("trunc(a)", in_range(whole(truncate) * one), [&] { return fixed::trunc(a); });
    expect("round(a)", in_range(whole(multiply == half_away ? half_away : half_up) * one),
           [&] { return fixed::round(a); });
    expect("abs(a)", in_range(abs(x)), [&] { return fixed::abs(a); });
    const auto root = oracle::exact_root(words_[0], half_up, F);
    const Said no_root = P.range == overflow::trap ? Said() : Said(0);
    expect("sqrt(a)", root ? in_range(*root) : no_root, [&] { return fixed::sqrt(a); });
    expect_true("to_integer by the policy's rule",
                fixed::to_integer<P.multiply>(a) == whole(multiply));
    expect_true("a as an int", static_cast<int>(a) == whole(truncate));
  }

  void comparisons() {
    const Number a = numbers_[0], b = numbers_[1];
    const bool less = units_[0] < units_[1];
    expect_true("a < b", (a < b) == less);
    expect_true("a == b", (a == b) == (words_[0] == words_[1]));
    expect("min(a, b)", words_[less ? 0 : 1], [&] { return fixed::min(a, b); });
    expect("max(a, b)", words_[less ? 1 : 0], [&] { return fixed::max(a, b); });
  }

  /// @tparam Float float or double
  template <class Float>
  void from_float(std::string_view what, Float value) {
    const auto exact = oracle::from_double(static_cast<double>(value), multiply, F);
    Said expected = end(value < 0);
    if (exact) expected = in_range(*exact);
    if (std::isnan(value) && P.range != overflow::trap) expected = 0;
    expect(what, expected, [value] { return Number(value); });
  }

  void from_elsewhere() {
    const Number a = numbers_[0];
    const double value = std::ldexp(units_[0].template convert_to<double>(), -F);
    expect_true("a as a double", static_cast<double>(a) == value);
    expect_true("a as a float", static_cast<float>(a) == static_cast<float>(value));
    from_float("number(double of a's and b's bits)", std::bit_cast<double>(wide_));
    from_float("number(float of b's bits)",
               std::bit_cast<float>(static_cast<std::uint32_t>(wide_)));
    const auto integer = static_cast<std::int64_t>(wide_);
    expect("number(integer of a's and b's bits)", in_range(Integer(integer) * oracle::one(F)),
           [integer] { return Number(integer); });
    const auto other = fixed::number<24 - F, P>::from_raw(
        static_cast<typename fixed::number<24 - F, P>::raw_type>(wide_));
    const Word other_word = static_cast<Word>(wide_) & (~Word{0} >> (32 - 2 * (24 - F)));
    expect("number(another width's)",
           in_range(oracle::rounded(oracle::ulps(other_word, 24 - F) * oracle::one(F),
                                    oracle::one(24 - F), multiply)),
           [other] { return Number(other); });
  }

  std::array<Word, 3> words_{};
  std::array<Number, 3> numbers_{};
  std::array<Integer, 3> units_;
  std::uint64_t wide_ = 0;
  std::optional<std::string> difference_;
};

using fixed::rounding;
constexpr policy saturating_away{
    .multiply = rounding::half_away, .divide = rounding::half_away, .range = overflow::saturate};
constexpr policy trapping_floor{
    .multiply = rounding::floor, .divide = rounding::floor, .range = overflow::trap};
constexpr policy saturating_truncate{
    .multiply = rounding::truncate, .divide = rounding::truncate, .range = overflow::saturate};
constexpr policy wrapping_away{.multiply = rounding::half_away, .divide = rounding::half_away};

/// `ask(trial)` of every width and policy until one differs.
template <class Ask>
std::optional<std::string> each_trial(std::span<const std::uint32_t, 3> words, Ask ask) {
  using namespace fixed::policies;
  std::optional<std::string> found;
  const auto try_one = [&]<int F, policy P>(Trial<F, P> trial) {
    if (!found) found = ask(trial);
  };
  const auto try_policy = [&]<policy P>(std::integral_constant<policy, P>) {
    try_one(Trial<16, P>(words));
    try_one(Trial<8, P>(words));
  };
  try_policy(std::integral_constant<policy, wrapping>());
  try_policy(std::integral_constant<policy, saturating>());
  try_policy(std::integral_constant<policy, trapping>());
  try_policy(std::integral_constant<policy, saturating_away>());
  try_policy(std::integral_constant<policy, trapping_floor>());
  try_policy(std::integral_constant<policy, saturating_truncate>());
  try_policy(std::integral_constant<policy, wrapping_away>());
  return found;
}

}  // namespace

std::optional<std::string> type_difference(std::span<const std::uint32_t, 3> words) {
  return each_trial(words, [](auto& trial) { return trial.all(); });
}

std::optional<std::string> quotient_difference(std::uint32_t n, std::uint32_t d) {
  const std::array<std::uint32_t, 3> words{n, d, 0};
  return each_trial(words, [](auto& trial) { return trial.quotient_only(); });
}

}  // namespace fixproof::fuzz
