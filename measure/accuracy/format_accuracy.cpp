#include "measure/accuracy/format_accuracy.hpp"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cmath>
#include <string>
#include <type_traits>
#include <variant>

#include "judge/check/word.hpp"
#include "measure/host/provenance.hpp"
#include "oracle/format.hpp"
#include "support/usage_error.hpp"
#include "verify/cases/format_makers.hpp"
#include "verify/parties/with_format.hpp"

namespace fixproof::measure {

namespace {

using cases::Draw;
using cases::Format;
using cases::WordPair;
using oracle::Integer;

constexpr std::uint64_t default_format_cases = 500'000;
/// Bits below one ulp of a root.
constexpr int root_digits = 48;

enum class Operation { mul, div, sqrt };
constexpr std::array operations{Operation::mul, Operation::div, Operation::sqrt};

const char* name_of(Operation operation) {
  return operation == Operation::mul ? "mul" : operation == Operation::div ? "div" : "sqrt";
}

/// A word, or ulps in floating point.
using Result = std::variant<std::uint64_t, double>;

struct FormatSubject {
  std::string name;
  Result (*answer)(Operation operation, const Format& format, WordPair in);
};

template <class Number>
Result answer_of_type(Operation operation, const Format& /*format*/, WordPair in) {
  const auto x = parties::number_from<Number>(in.first);
  const auto y = parties::number_from<Number>(in.second);
  return parties::bits_of<Number>(operation == Operation::mul   ? x * y
                                  : operation == Operation::div ? x / y
                                                                : sqrt(x));
}

/// Operands with more bits than the significand round to nearest.
template <class Float>
Result answer_of_float(Operation operation, const Format& format, WordPair in) {
  const auto value = [&](std::uint64_t word) {
    const Integer ulps = oracle::ulps(word, format.as<oracle::Format>());
    return std::ldexp(static_cast<Float>(ulps), -format.fraction_bits);
  };
  const Float x = value(in.first);
  const Float result = operation == Operation::mul   ? x * value(in.second)
                       : operation == Operation::div ? x / value(in.second)
                                                     : std::sqrt(x);
  return std::ldexp(static_cast<double>(result), format.fraction_bits);
}

template <class Number, rounding Rule>
using rounded_by = with_policy<Number, policy{.multiply = Rule, .divide = Rule}>;

/// The subjects of an operation. Roots are the same under every rule.
std::vector<FormatSubject> subjects_in(const Format& format, Operation operation) {
  std::vector<FormatSubject> subjects;
  const std::string name = cases::name_of(format);
  require_named(format);
  parties::with_number_in(format, [&]<class Number>(std::type_identity<Number> /*type*/) {
    if (operation == Operation::sqrt) {
      subjects.push_back({name, answer_of_type<Number>});
      return;
    }
    const auto add = [&]<rounding Rule>(const char* rule) {
      subjects.push_back(
          {fmt::format("{}, {}", name, rule), answer_of_type<rounded_by<Number, Rule>>});
    };
    add.template operator()<rounding::half_up>("half up");
    add.template operator()<rounding::half_even>("half even");
    add.template operator()<rounding::half_away>("half away");
    add.template operator()<rounding::floor>("floor");
    add.template operator()<rounding::truncate>("truncate");
  });
  subjects.push_back({"float", answer_of_float<float>});
  subjects.push_back({"double", answer_of_float<double>});
  return subjects;
}

/// Empty if there is no result: a zero divisor or the root of a negative number.
std::optional<ExactResult> exact_result(Operation operation, const Format& format, WordPair in) {
  const Integer x = oracle::ulps(in.first, format.as<oracle::Format>());
  const Integer y = oracle::ulps(in.second, format.as<oracle::Format>());
  const Integer one = Integer(1) << format.fraction_bits;
  if (operation == Operation::mul) return ExactResult{x * y, one};
  if (operation == Operation::div) {
    if (y == 0) return std::nullopt;
    return y < 0 ? ExactResult{-x * one, -y} : ExactResult{x * one, y};
  }
  if (x < 0) return std::nullopt;
  return ExactResult{sqrt(x * one << 2 * root_digits), Integer(1) << root_digits};
}

/// Whether a word can hold the exact result rounded in either direction.
bool fits(const ExactResult& exact, const oracle::Format& format) {
  return exact.numerator >= oracle::lowest(format) * exact.denominator &&
         exact.numerator <= oracle::highest(format) * exact.denominator;
}

/// The low bits of a word, sign-extended if the format is signed.
std::uint64_t narrowed(std::uint64_t word, int bits, const Format& format) {
  const int unused = 64 - bits;
  const std::uint64_t high = word << unused;
  return (format.is_signed ? static_cast<std::uint64_t>(static_cast<std::int64_t>(high) >> unused)
                           : high >> unused) &
         cases::all_ones(format);
}

/// The bits of factors whose product fits: all after the point and half of those before it.
int factor_bits(const Format& format) { return (format.word_bits + format.fraction_bits) / 2; }

WordPair uniform(Draw& draw, Operation operation, const Format& format) {
  WordPair in{cases::any_word(draw, format), cases::any_word(draw, format)};
  if (operation == Operation::mul) {
    in.first = narrowed(in.first, factor_bits(format), format);
    in.second = narrowed(in.second, factor_bits(format), format);
  }
  return in;
}

WordPair log_uniform(Draw& draw, Operation /*operation*/, const Format& format) {
  return {cases::any_width(draw, format), cases::any_width(draw, format)};
}

struct OperandStream {
  const char* name;
  WordPair (*draw)(Draw& draw, Operation operation, const Format& format);
};
constexpr std::array streams{OperandStream{"uniform", uniform},
                             OperandStream{"log-uniform", log_uniform}};

/// Roots have the magnitudes of the operands.
WordPair not_negative(WordPair in, Operation operation, const Format& format) {
  const bool is_negative = format.is_signed && in.first >> (format.word_bits - 1) != 0;
  if (operation == Operation::sqrt && is_negative) {
    in.first = ~in.first & cases::all_ones(format);
  }
  return in;
}

struct Part {
  Operation operation = Operation::mul;
  Format format;
  OperandStream stream = streams.front();
  std::uint64_t key = 0;  ///< of the operands

  /// The operands of case i.
  [[nodiscard]] WordPair operands(std::uint64_t i) const {
    Draw draw(key, i);
    return not_negative(stream.draw(draw, operation, format), operation, format);
  }
};

/// Returns one row for each subject. If `stop` ends the run early, the rows cover the cases so far.
std::vector<AccuracyRow> measure_stream(const Part& part,
                                        const std::vector<FormatSubject>& subjects,
                                        std::uint64_t cases, const std::atomic<bool>& stop) {
  const auto format = part.format.as<oracle::Format>();
  std::vector<AccuracyRow> rows;
  rows.reserve(subjects.size());
  for (const FormatSubject& subject : subjects) {
    rows.push_back({name_of(part.operation), part.stream.name, subject.name, "", {}, 0, 0});
  }
  for (std::uint64_t i = 0; i < cases && !stop; ++i) {
    const WordPair in = part.operands(i);
    const auto exact = exact_result(part.operation, part.format, in);
    const bool counts = exact && fits(*exact, format);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (!counts) {
        ++rows[k].beyond;
        continue;
      }
      const Result answer = subjects[k].answer(part.operation, part.format, in);
      if (const auto* word = std::get_if<std::uint64_t>(&answer)) {
        add_error(rows[k].errors, oracle::ulps(*word, format), *exact);
      } else {
        add_error(rows[k].errors, std::get<double>(answer), *exact);
      }
    }
  }
  return rows;
}

}  // namespace

void require_named(const Format& format) {
  if (parties::with_number_in(format, [](auto /*type*/) {})) return;
  throw support::UsageError(
      fmt::format("--format {}: --accuracy measures the formats that fixed/formats.hpp names; see "
                  "`fixproof verify --help`",
                  cases::name_of(format)));
}

std::optional<FormatAccuracyResult> measure_format_accuracy(const MeasureRequest& request,
                                                            MeasureProgress& progress) {
  const Format& format = request.format;
  const std::uint64_t cases = request.cases.value_or(default_format_cases);
  FormatAccuracyResult result{request.seed, format, {}};
  progress.begin(operations.size() * streams.size(), "parts");
  std::uint64_t key = cases::mix(request.seed);
  for (const Operation operation : operations) {
    const std::vector<FormatSubject> subjects = subjects_in(format, operation);
    for (const OperandStream& stream : streams) {
      const auto rows =
          measure_stream({operation, format, stream, key++}, subjects, cases, progress.stop());
      if (progress.stop()) return std::nullopt;
      result.rows.insert(result.rows.end(), rows.begin(), rows.end());
      progress.add_part();
    }
  }
  return result;
}

void to_json(support::Json& json, const FormatAccuracyResult& result) {
  json = {{"made", made_by_json(result.function.empty()
                                    ? "measure --accuracy --format"
                                    : "measure --accuracy --function " + result.function,
                                result.seed)},
          {"format", cases::name_of(result.format)},
          {"accuracy", result.rows}};
}

}  // namespace fixproof::measure
