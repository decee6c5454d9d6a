#include "fuzz/judged_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdlib>
#include <exception>
#include <string_view>
#include <vector>

#include "judge/check/cases.hpp"
#include "judge/check/judge.hpp"
#include "judge/check/verdict_text.hpp"
#include "verify/cases/words.hpp"

namespace fixproof::fuzz {

namespace {

using boost::multiprecision::cpp_int;
using boost::multiprecision::cpp_rational;
using cases::Operation;

/// The choices that bytes make; the first of each once they are used up.
class Choices {
 public:
  explicit Choices(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  /// Returns 0 ... count - 1.
  std::size_t below(std::size_t count) {
    std::size_t number = 0;
    for (int i = 0; i < 2; ++i) {
      number = number << 8U;
      if (at_ < bytes_.size()) number |= bytes_[at_++];
    }
    return number % count;
  }
  int between(int first, int last) {
    return first + static_cast<int>(below(static_cast<std::size_t>(last - first) + 1));
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

cases::Format any_format(Choices& choices) {
  cases::Format format;
  format.word_bits = choices.between(2, 64);
  format.is_signed = choices.below(2) == 0;
  format.is_decimal = choices.below(4) == 0;
  format.fraction_bits =
      format.is_decimal ? choices.between(0, 12) : choices.between(-8, format.word_bits + 8);
  return format;
}

cpp_rational unit_value(const cases::Format& format) {
  const cpp_int power = pow(cpp_int(format.is_decimal ? 10 : 2),
                            static_cast<unsigned>(std::abs(format.fraction_bits)));
  return format.fraction_bits < 0 ? cpp_rational(power) : cpp_rational(1, power);
}

cpp_int number_of(std::uint64_t word, const cases::Format& format) {
  const bool is_negative = format.is_signed && (word >> (format.word_bits - 1)) != 0;
  return is_negative ? cpp_int(word) - (cpp_int(1) << format.word_bits) : cpp_int(word);
}

/// The exact result, or nothing for a zero divisor.
std::optional<cpp_rational> exact_result(const cases::Variant& v,
                                         const std::vector<std::uint64_t>& words) {
  const cases::Format format = operand_format(v);
  std::vector<cpp_rational> x;
  for (const std::uint64_t word : words) x.push_back(number_of(word, format) * unit_value(format));
  switch (v.operation) {
    case Operation::add:
      return x[0] + x[1];
    case Operation::sub:
      return x[0] - x[1];
    case Operation::mul:
      return x[0] * x[1];
    case Operation::div:
      if (x[1] == 0) return std::nullopt;
      return x[0] / x[1];
    case Operation::mul_div:
      if (x[2] == 0) return std::nullopt;
      return x[0] * x[1] / x[2];
    case Operation::mul_add:
      return x[0] * x[1] + x[2];
    case Operation::lerp:
      return x[0] + (x[1] - x[0]) * x[2];
    case Operation::dot: {
      cpp_rational sum = 0;
      for (std::size_t i = 0; i < v.terms; ++i) sum += x[i] * x[v.terms + i];
      return sum;
    }
    default:
      return x[0];  // convert
  }
}

cpp_int floor_of(const cpp_rational& value) {
  const cpp_int truncated = numerator(value) / denominator(value);
  return cpp_rational(truncated) > value ? truncated - 1 : truncated;
}

cpp_int rounded(const cpp_rational& ulps, oracle::Rounding rule) {
  const cpp_int floor = floor_of(ulps);
  const cpp_rational above = ulps - floor;
  const cpp_rational half(1, 2);
  if (above == 0) return floor;
  switch (rule) {
    case oracle::Rounding::floor:
      return floor;
    case oracle::Rounding::ceiling:
      return floor + 1;
    case oracle::Rounding::truncate:
      return ulps < 0 ? floor + 1 : floor;
    case oracle::Rounding::half_up:
      return above < half ? floor : floor + 1;
    case oracle::Rounding::half_away:
      return above < half || (above == half && ulps < 0) ? floor : floor + 1;
    case oracle::Rounding::half_even:
      break;
  }
  return above < half || (above == half && floor % 2 == 0) ? floor : floor + 1;
}

/// The word that the rules want. Rules name `wrap`, `saturate` or `error`, and `error` or `zero`.
check::Said right_result(const check::Rules& rules, const std::vector<std::uint64_t>& words) {
  const cases::Format& format = rules.variant.format;
  const auto exact = exact_result(rules.variant, words);
  if (!exact) return rules.no_result == check::NoResult::zero ? check::Said(0) : check::Said();
  const cpp_int modulus = cpp_int(1) << format.word_bits;
  const cpp_int least = format.is_signed ? cpp_int(-(modulus / 2)) : cpp_int(0);
  const cpp_int most = least + modulus - 1;
  cpp_int ulps = rounded(*exact / unit_value(format), rules.rounding);
  if (ulps < least || ulps > most) {
    if (rules.overflow == check::Overflow::error) return std::nullopt;
    if (rules.overflow == check::Overflow::saturate) ulps = ulps < 0 ? least : most;
  }
  cpp_int rest = ulps % modulus;
  if (rest < 0) rest += modulus;
  return static_cast<std::uint64_t>(rest);
}

/// Changes a result: to its neighbour, in one bit, to DE or to no word.
check::Said spoiled(const check::Said& right, const cases::Format& format, Choices& choices) {
  if (!right) return 1;
  switch (choices.below(4)) {
    case 0:
      return (*right + 1) & cases::all_ones(format);
    case 1:
      return *right ^ std::uint64_t{1} << choices.below(static_cast<std::size_t>(format.word_bits));
    case 2:
      return std::nullopt;
    default: {
      const auto stored = static_cast<std::size_t>(cases::storage_bits(format));
      return *right ^ std::uint64_t{1} << choices.below(stored);
    }
  }
}

/// Judges the same cases; `wrong_case` has the wrong result.
check::Judge judged(const check::Rules& rules, std::uint64_t cases,
                    std::optional<std::uint64_t> wrong_case, Choices& choices) {
  check::GeneratedCases source(rules.variant, {.seed = cases, .cases = cases});
  check::Judge judge(rules, 3);
  check::JudgedCase one;
  one.origin = "combination";
  std::vector<std::uint32_t> parts(cases::words_in(rules.variant));
  std::vector<std::uint64_t> words(cases::operands_of(rules.variant));
  while (source.next(parts)) {
    check::join_words(parts, operand_format(rules.variant), words);
    std::string line;
    cases::append_operands(line, rules.variant, parts);
    if (check::is_judged_by_value(rules.variant)) {
      one.valued = check::parse_valued(line, rules.variant);
    } else {
      std::copy_n(words.begin(), std::min(words.size(), one.words.size()), one.words.begin());
    }
    one.said = right_result(rules, words);
    if (one.number == wrong_case) {
      one.said = spoiled(one.said, rules.variant.format, choices);
    }
    ++one.number;
    judge.add(one);
  }
  return judge;
}

/// Returns the first value of a verdict that should be a word of the format and is none.
std::string no_word_in(std::string_view text, const cases::Format& format) {
  constexpr std::string_view mark = " expected";
  for (std::size_t at = text.find(mark); at != std::string_view::npos;
       at = text.find(mark, at + 1)) {
    const std::size_t start = text.rfind(' ', at - 1) + 1;
    const std::string_view word = text.substr(start, at - start);
    const check::Said said = check::parse_result(word, format);
    if (said && !check::is_word(*said, format)) return std::string(word);
  }
  return "";
}

}  // namespace

std::optional<std::string> judged_results(std::span<const std::uint8_t> bytes) {
  constexpr std::array operations{Operation::mul,     Operation::div,     Operation::add,
                                  Operation::sub,     Operation::convert, Operation::mul_div,
                                  Operation::mul_add, Operation::lerp,    Operation::dot};
  Choices choices(bytes);
  const Operation operation = operations.at(choices.below(operations.size()));
  const cases::Format from = any_format(choices);
  const bool has_other = operation == Operation::convert || choices.below(2) == 0;
  const cases::Format to = has_other ? any_format(choices) : from;
  check::Rules rules{.variant = cases::variant_of(operation, from, to)};
  if (operation == Operation::dot) rules.variant.terms = 1 + choices.below(5);
  rules.rounding = check::roundings()[choices.below(check::roundings().size())];
  constexpr std::array overflows{check::Overflow::wrap, check::Overflow::saturate,
                                 check::Overflow::error};
  rules.overflow = overflows.at(choices.below(overflows.size()));
  if (choices.below(2) == 0) rules.no_result = check::NoResult::zero;
  const std::uint64_t cases = 20 + choices.below(20);
  const std::string what = fmt::format(
      "{} {} to {}, {}, overflow {}", cases::name_of(operation), cases::name_of(from),
      cases::name_of(to), check::name_of(rules.rounding), check::name_of(rules.overflow));
  try {
    Choices none({});
    const check::Judge right = judged(rules, cases, std::nullopt, none);
    const std::string said = check::verdict_text(right);
    if (!right.is_right()) return fmt::format("{}: right results are called wrong\n{}", what, said);
    const std::uint64_t wrong_case = choices.below(right.cases());
    const check::Judge wrong = judged(rules, cases, wrong_case, choices);
    const std::string text = check::verdict_text(wrong);
    if (wrong.wrong() != 1) return fmt::format("{}: one result is wrong\n{}", what, text);
    if (const std::string word = no_word_in(text, to); !word.empty()) {
      return fmt::format("{}: {} is no word of {}\n{}", what, word, cases::name_of(to), text);
    }
  } catch (const std::exception& error) {
    return fmt::format("{}: {}", what, error.what());
  }
  return std::nullopt;
}

}  // namespace fixproof::fuzz
