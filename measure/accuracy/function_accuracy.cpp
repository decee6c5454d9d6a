#include "measure/accuracy/function_accuracy.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "judge/check/cases.hpp"
#include "judge/check/rules.hpp"
#include "measure/accuracy/subjects.hpp"
#include "support/edits.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"
#include "verify/cases/variant.hpp"
#include "verify/parties/formats.hpp"

namespace fixproof::measure {

namespace {

using cases::Format;
using Words = std::array<std::uint64_t, 3>;

struct FunctionSubject {
  std::string name;
  std::function<std::uint64_t(const Words&)> answer;
};

/// The C library's function, as a user of this type would call it.
template <class Float>
Float library_function(cases::Operation operation, Float x, Float y, Float z) {
  constexpr Float degree = std::numbers::pi_v<Float> / 180;
  constexpr Float turn = 2 * std::numbers::pi_v<Float>;
  using enum cases::Operation;
  switch (operation) {
    case exp2:
      return std::exp2(x);
    case exp:
      return std::exp(x);
    case expm1:
      return std::expm1(x);
    case log2:
      return std::log2(x);
    case log:
      return std::log(x);
    case log10:
      return std::log10(x);
    case log1p:
      return std::log1p(x);
    case sinh:
      return std::sinh(x);
    case cosh:
      return std::cosh(x);
    case tanh:
      return std::tanh(x);
    case sin:
      return std::sin(x);
    case cos:
      return std::cos(x);
    case tan:
      return std::tan(x);
    case sin_of_degrees:
      return std::sin(x * degree);
    case cos_of_degrees:
      return std::cos(x * degree);
    case tan_of_degrees:
      return std::tan(x * degree);
    case sin_of_turns:
      return std::sin(x * turn);
    case cos_of_turns:
      return std::cos(x * turn);
    case tan_of_turns:
      return std::tan(x * turn);
    case asin:
      return std::asin(x);
    case acos:
      return std::acos(x);
    case atan:
      return std::atan(x);
    case cbrt:
      return std::cbrt(x);
    case rsqrt:
      return 1 / std::sqrt(x);
    case reciprocal:
      return 1 / x;
    case atan2:
      return std::atan2(x, y);
    case hypot:
      return std::hypot(x, y);
    case pow:
      return std::pow(x, y);
    case fmod:
      return std::fmod(x, y);
    case remainder:
      return std::remainder(x, y);
    case mul_div:
      return x * y / z;
    case hypot3:
      return std::hypot(x, y, z);
    case exp10:
      return std::pow(Float(10), x);
    case asinh:
      return std::asinh(x);
    case acosh:
      return std::acosh(x);
    case atanh:
      return std::atanh(x);
    case asin_in_degrees:
      return std::asin(x) / degree;
    case acos_in_degrees:
      return std::acos(x) / degree;
    case atan_in_degrees:
      return std::atan(x) / degree;
    case asin_in_turns:
      return std::asin(x) / turn;
    case acos_in_turns:
      return std::acos(x) / turn;
    case atan_in_turns:
      return std::atan(x) / turn;
    case atan2_in_degrees:
      return std::atan2(x, y) / degree;
    case atan2_in_turns:
      return std::atan2(x, y) / turn;
    default:
      throw std::invalid_argument("not a function");
  }
}

std::int64_t ulps_of(std::uint64_t word, const Format& format) {
  return static_cast<std::int64_t>(oracle::ulps(word, format.as<oracle::Format>()));
}

/// Saturates, and so turns a result that rounds out of range into the nearest word.
template <class Float>
std::uint64_t rounded_word(Float result, const Format& format) {
  const Float ulps = std::ldexp(result, format.fraction_bits);
  if (!(ulps > static_cast<Float>(ulps_of(cases::lowest(format), format)))) {
    return cases::lowest(format);
  }
  if (ulps >= static_cast<Float>(cases::highest(format))) return cases::highest(format);
  return static_cast<std::uint64_t>(std::llrint(ulps)) & cases::all_ones(format);
}

template <class Float>
FunctionSubject floating(const char* name, cases::Operation operation, const Format& format) {
  return {name, [=](const Words& in) {
            const auto value = [&](std::uint64_t word) {
              return std::ldexp(static_cast<Float>(ulps_of(word, format)), -format.fraction_bits);
            };
            return rounded_word(
                library_function(operation, value(in[0]), value(in[1]), value(in[2])), format);
          }};
}

FunctionSubject of_type(const cases::Variant& variant) {
  return {cases::name_of(variant.format), [variant](const Words& in) -> std::uint64_t {
            const std::array words{static_cast<std::uint32_t>(in[0]),
                                   static_cast<std::uint32_t>(in[1]),
                                   static_cast<std::uint32_t>(in[2])};
            std::array<std::uint32_t, 1> out{};
            std::array<parties::Ending, 1> endings{};
            const auto operands = std::span(words).first(cases::words_in(variant));
            parties::answer_by_type(variant, {operands, out, endings});
            return out[0];
          }};
}

std::vector<FunctionSubject> subjects_of(const cases::Variant& variant) {
  std::vector<FunctionSubject> subjects{of_type(variant)};
  const auto add = [&](const char* library, WordFunction function) {
    if (function == nullptr || variant.format != cases::q16_16) return;
    subjects.push_back({library, [function](const Words& in) -> std::uint64_t {
                          return function(static_cast<std::uint32_t>(in[0]),
                                          static_cast<std::uint32_t>(in[1]));
                        }});
  };
  add("libfixmath", libfixmath_function(cases::name_of(variant.operation)));
  add("FreeType", freetype_function(cases::name_of(variant.operation)));
  subjects.push_back(floating<float>("float", variant.operation, variant.format));
  subjects.push_back(floating<double>("double", variant.operation, variant.format));
  return subjects;
}

/// Returns one row for each subject. If `stop` ends the run early, the rows cover the cases so far.
std::vector<AccuracyRow> measure_function(const cases::Variant& variant,
                                          const MeasureRequest& request,
                                          const std::atomic<bool>& stop) {
  const Format& format = variant.format;
  const std::vector<FunctionSubject> subjects = subjects_of(variant);
  const check::Curve empty(variant);
  std::vector<check::Curve> curves(subjects.size(), empty);
  std::vector<AccuracyRow> rows;
  for (const FunctionSubject& subject : subjects) {
    rows.push_back({std::string(cases::name_of(variant.operation)),
                    "cases of fixproof gen",
                    subject.name,
                    "",
                    {},
                    0,
                    0});
  }
  check::GeneratedCases source(variant, {.seed = request.seed, .cases = request.cases});
  while (const auto operands = source.next_valued()) {
    if (stop) break;
    const auto rounded = check::rounded_result(variant, *operands, oracle::Rounding::half_up);
    if (!rounded || !rounded->fits) {
      for (AccuracyRow& row : rows) ++row.beyond;
      continue;
    }
    std::array<std::uint64_t, 3> three{};
    std::ranges::copy(operands->words, three.begin());
    check::JudgedCase judged;
    judged.valued = operands;
    const ExactResult exact{operands->value->numerator << format.fraction_bits,
                            operands->value->denominator};
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const std::uint64_t said = subjects[k].answer(three);
      const double largest = rows[k].errors.max();
      const double error = std::fabs(
          add_error(rows[k].errors, oracle::ulps(said, format.as<oracle::Format>()), exact));
      if (error > largest) rows[k].worst = check::text_of(*operands, variant);
      judged.said = said;
      curves[k].add(judged, error, rounded->word);
    }
  }
  for (std::size_t k = 0; k < rows.size(); ++k) rows[k].curve = curves[k].figures();
  return rows;
}

std::vector<cases::Operation> functions_named(const std::string& name, const Format& format) {
  std::vector<cases::Operation> functions;
  for (const cases::OperationRow& row : cases::operations) {
    const cases::Operation operation = row.operation;
    if (!cases::is_function(operation) && !cases::is_quotient_function(operation)) continue;
    const bool is_of_all = name == "all" && cases::is_in_format(operation, format);
    if (is_of_all || name == cases::name_of(operation)) functions.push_back(operation);
  }
  if (functions.empty()) {
    std::vector<std::string> names;
    for (const cases::OperationRow& row : cases::operations) names.emplace_back(row.name);
    throw support::UsageError(fmt::format("--function {}: choose all or one of {}{}",
                                          support::printable(name), cases::function_names(),
                                          support::suggestion(name, names)));
  }
  return functions;
}

}  // namespace

std::optional<FormatAccuracyResult> measure_function_accuracy(const MeasureRequest& request,
                                                              MeasureProgress& progress) {
  require_named(request.format);
  if (request.format.word_bits > 32) {
    throw support::UsageError(
        fmt::format("--format {}: --function measures formats of at most 32 bits",
                    cases::name_of(request.format)));
  }
  const std::vector<cases::Operation> functions = functions_named(request.function, request.format);
  cases::check_format(functions.front(), request.format);
  FormatAccuracyResult result{request.seed, request.format, {}, request.function};
  progress.begin(functions.size(), "functions");
  for (const cases::Operation function : functions) {
    const auto rows =
        measure_function(cases::variant_of(function, request.format), request, progress.stop());
    if (progress.stop()) return std::nullopt;
    result.rows.insert(result.rows.end(), rows.begin(), rows.end());
    progress.add_part();
  }
  return result;
}

}  // namespace fixproof::measure
