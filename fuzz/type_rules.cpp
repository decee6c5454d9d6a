#include "fuzz/type_rules.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <string_view>
#include <type_traits>
#include <vector>

#include "fixed/fixed.hpp"
#include "fuzz/oracle_rule.hpp"
#include "oracle/decimal.hpp"
#include "oracle/format.hpp"

namespace fixproof::fuzz {

namespace {

using fixproof::overflow;
using fixproof::policy;
using oracle::Integer;
using oracle::Word;
/// A word, or nothing for an exception.
using Answer = std::optional<Word>;
using Words = std::span<const std::uint32_t, 3>;

/// The operations on a, b and c, in the order of the answers below.
constexpr auto operation_names = std::to_array<std::string_view>({
    "a / b",
    "try_divide(a, b)",
    "a /= b",
    "a + b",
    "a += b",
    "a - b",
    "a -= b",
    "-a",
    "a * b",
    "a *= b",
    "mul_add(a, b, c)",
    "lerp(a, b, c)",
    "dot({a, b, c}, {b, c, a})",
    "floor(a)",
    "ceil(a)",
    "trunc(a)",
    "round(a)",
    "abs(a)",
    "sqrt(a)",
    "a to an integer by the policy's rule",
    "a as an int",
    "a < b",
    "a == b",
    "min(a, b)",
    "max(a, b)",
    "whether a as a double is exact",
    "whether a as a float is the nearest",
    "a number of the double whose bits are those of a and b",
    "a number of the float whose bits are those of b",
    "a number of the integer whose bits are those of a and b",
    "a number of the other width, of the bits of b",
});

std::uint64_t joined(Words words) { return std::uint64_t{words[0]} << 32U | words[1]; }

double exact_double(Word word, int bits) {
  return std::ldexp(oracle::ulps(word, bits).convert_to<double>(), -bits);
}

template <int F, policy P>
class TypeAnswers {
 public:
  using Number = fixproof::number<std::conditional_t<F == 16, std::int32_t, std::int16_t>, F, P>;
  using Other =
      fixproof::number<std::conditional_t<F == 16, std::int16_t, std::int32_t>, 24 - F, P>;

  static std::vector<Answer> quotients(Words words) {
    const Number a = number(words[0]);
    const Number b = number(words[1]);
    const auto tried = fixproof::try_divide(a, b);
    return {said([=] { return a / b; }), tried ? Answer(word(*tried)) : Answer(),
            said([=] { return Number(a) /= b; })};
  }

  static std::vector<Answer> all(Words words) {
    auto answers = quotients(words);
    const Number a = number(words[0]);
    const Number b = number(words[1]);
    const Number c = number(words[2]);
    const auto add = [&](Answer answer) { answers.push_back(answer); };
    add(said([=] { return a + b; }));
    add(said([=] { return Number(a) += b; }));
    add(said([=] { return a - b; }));
    add(said([=] { return Number(a) -= b; }));
    add(said([=] { return -a; }));
    add(said([=] { return a * b; }));
    add(said([=] { return Number(a) *= b; }));
    add(said([=] { return mul_add(a, b, c); }));
    add(said([=] { return lerp(a, b, c); }));
    add(said([=] { return dot(std::array{a, b, c}, std::array{b, c, a}); }));
    add(said([=] { return floor(a); }));
    add(said([=] { return ceil(a); }));
    add(said([=] { return trunc(a); }));
    add(said([=] { return round(a); }));
    add(said([=] { return abs(a); }));
    add(said([=] { return sqrt(a); }));
    add(static_cast<Word>(fixproof::to_integer<P.multiply>(a)));
    add(static_cast<Word>(static_cast<int>(a)));
    add(a < b ? 1 : 0);
    add(a == b ? 1 : 0);
    add(word(fixproof::min(a, b)));
    add(word(fixproof::max(a, b)));
    const double exact = exact_double(words[0], F);
    add(static_cast<double>(a) == exact ? 1 : 0);
    add(static_cast<float>(a) == static_cast<float>(exact) ? 1 : 0);
    const std::uint64_t wide = joined(words);
    add(said([=] { return Number(std::bit_cast<double>(wide)); }));
    add(said([=] { return Number(std::bit_cast<float>(static_cast<std::uint32_t>(wide))); }));
    add(said([=] { return Number(static_cast<std::int64_t>(wide)); }));
    add(said([=] { return Number(Other::from_raw(static_cast<typename Other::raw_type>(wide))); }));
    return answers;
  }

 private:
  static Number number(Word word) {
    return Number::from_raw(static_cast<typename Number::raw_type>(word));
  }
  static Word word(Number x) {
    return static_cast<std::make_unsigned_t<typename Number::raw_type>>(x.raw());
  }
  template <class Make>
  static Answer said(Make make) {
    try {
      return word(make());
    } catch (const fixproof::overflow_error&) {
    } catch (const fixproof::divide_error&) {
    } catch (const fixproof::domain_error&) {
    }
    return std::nullopt;
  }
};

class OracleAnswers {
 public:
  OracleAnswers(int fraction_bits, const policy& rules, Words words)
      : fraction_bits_(fraction_bits),
        rules_(rules),
        multiply_(oracle_rule(rules.multiply)),
        wide_(joined(words)) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      words_.at(i) = words[i] & (~Word{0} >> (32 - bits()));
      units_.at(i) = oracle::ulps(words_.at(i), fraction_bits);
    }
  }

  [[nodiscard]] std::vector<Answer> quotients() const {
    const auto exact =
        oracle::exact_quotient(words_[0], words_[1], oracle_rule(rules_.divide), fraction_bits_);
    if (!exact) {
      const Answer limit = traps() || units_[0] != 0 ? end(units_[0] < 0) : Answer(0);
      return {limit, std::nullopt, limit};
    }
    return {in_range(*exact), in_range(*exact), in_range(*exact)};
  }

  [[nodiscard]] std::vector<Answer> all() const {
    using enum oracle::Rounding;
    auto answers = quotients();
    const auto add = [&](Answer answer) { answers.push_back(answer); };
    const auto add_twice = [&](const Integer& exact) {
      add(in_range(exact));
      add(in_range(exact));
    };
    const auto& [x, y, z] = units_;
    const auto& [a, b, c] = words_;
    const int f = fraction_bits_;
    add_twice(x + y);
    add_twice(x - y);
    add(in_range(-x));
    add_twice(oracle::exact_product(a, b, multiply_, f));
    add(in_range(oracle::exact_mul_add(a, b, c, multiply_, f)));
    add(in_range(oracle::exact_lerp(a, b, c, multiply_, f)));
    add(in_range(oracle::exact_dot(std::array{a, b, c}, std::array{b, c, a}, multiply_, f)));
    const Integer one = oracle::one(f);
    add(in_range(oracle::rounded(x, one, floor) * one));
    add(in_range(-oracle::rounded(-x, one, floor) * one));
    add(in_range(oracle::rounded(x, one, truncate) * one));
    add(in_range(oracle::rounded(x, one, multiply_ == half_away ? half_away : half_up) * one));
    add(in_range(abs(x)));
    const auto root = oracle::exact_root(a, half_up, f);
    add(root ? in_range(*root) : traps() ? Answer() : Answer(0));
    add(oracle::wrap(oracle::rounded(x, one, multiply_), 16));
    add(oracle::wrap(oracle::rounded(x, one, truncate), 16));
    add(x < y ? 1 : 0);
    add(x == y ? 1 : 0);
    add(x < y ? a : b);
    add(x < y ? b : a);
    add(1);
    add(1);
    add(of_float(std::bit_cast<double>(wide_)));
    add(of_float(static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(wide_)))));
    add(in_range(Integer(static_cast<std::int64_t>(wide_)) * one));
    const int other = 24 - f;
    const Integer other_units = oracle::ulps(static_cast<Word>(wide_), other);
    add(in_range(oracle::rounded(other_units * one, oracle::one(other), multiply_)));
    return answers;
  }

 private:
  [[nodiscard]] int bits() const { return 2 * fraction_bits_; }
  [[nodiscard]] bool traps() const { return rules_.range == overflow::trap; }

  [[nodiscard]] Answer in_range(const Integer& exact) const {
    if (rules_.range == overflow::saturate) return oracle::saturate(exact, fraction_bits_);
    if (traps() && !oracle::fits(exact, fraction_bits_)) return std::nullopt;
    return oracle::wrap(exact, fraction_bits_);
  }

  /// The end of the range, for operations without a result.
  [[nodiscard]] Answer end(bool negative) const {
    if (traps()) return std::nullopt;
    const Integer far = Integer(1) << bits();
    return oracle::saturate(negative ? -far : far, fraction_bits_);
  }

  [[nodiscard]] Answer of_float(double value) const {
    if (std::isnan(value)) return traps() ? Answer() : Answer(0);
    const auto exact = oracle::from_double(value, multiply_, fraction_bits_);
    return exact ? in_range(*exact) : end(value < 0);
  }

  int fraction_bits_;
  policy rules_;
  oracle::Rounding multiply_;
  std::uint64_t wide_;
  std::array<Word, 3> words_{};
  std::array<Integer, 3> units_;
};

std::optional<std::string> difference(int fraction_bits, const policy& rules, Words words,
                                      const std::vector<Answer>& type,
                                      const std::vector<Answer>& oracle) {
  const auto text = [](Answer word) {
    return word ? fmt::format("{:08x}", *word) : "an exception";
  };
  for (std::size_t i = 0; i < type.size(); ++i) {
    if (type[i] == oracle[i]) continue;
    return fmt::format(
        "fixproof::number<..., {}, policy{{.multiply = rounding({}), .divide = rounding({}), "
        ".range = "
        "overflow({})}}>: {}\n  a b c      {:08x} {:08x} {:08x}\n  type       {}\n  must be    {}",
        fraction_bits, static_cast<int>(rules.multiply), static_cast<int>(rules.divide),
        static_cast<int>(rules.range), operation_names.at(i), words[0], words[1], words[2],
        text(type[i]), text(oracle[i]));
  }
  return std::nullopt;
}

template <int F, policy P>
std::optional<std::string> difference_of(Words words, bool quotients_only) {
  const OracleAnswers oracle(F, P, words);
  if (quotients_only) {
    return difference(F, P, words, TypeAnswers<F, P>::quotients(words), oracle.quotients());
  }
  return difference(F, P, words, TypeAnswers<F, P>::all(words), oracle.all());
}

/// Compares quotients under every policy, and all operations under the policy that c chooses.
std::optional<std::string> first_difference(Words words, bool quotients_only) {
  using fixproof::rounding;
  using namespace fixproof::policies;
  constexpr policy saturating_away{
      .multiply = rounding::half_away, .divide = rounding::half_away, .range = overflow::saturate};
  constexpr policy trapping_floor{
      .multiply = rounding::floor, .divide = rounding::floor, .range = overflow::trap};
  constexpr policy wrapping_truncate{.multiply = rounding::truncate, .divide = rounding::truncate};
  static constexpr std::array trials{
      difference_of<16, wrapping>,          difference_of<8, wrapping>,
      difference_of<16, saturating>,        difference_of<8, saturating>,
      difference_of<16, trapping>,          difference_of<8, trapping>,
      difference_of<16, saturating_away>,   difference_of<8, trapping_floor>,
      difference_of<16, wrapping_truncate>,
  };
  if (!quotients_only) return trials.at(words[2] % trials.size())(words, false);
  for (const auto trial : trials) {
    if (auto found = trial(words, true)) return found;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> type_difference(Words words) { return first_difference(words, false); }

std::optional<std::string> quotient_difference(std::uint32_t n, std::uint32_t d) {
  return first_difference(std::array<std::uint32_t, 3>{n, d, 0}, true);
}

}  // namespace fixproof::fuzz
