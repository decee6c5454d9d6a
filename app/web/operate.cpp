#include "app/web/operate.hpp"

#include <array>
#include <charconv>
#include <optional>

#include "app/input/number.hpp"
#include "app/web/builds.hpp"
#include "app/web/json.hpp"
#include "app/web/operand.hpp"
#include "app/web/words.hpp"
#include "oracle/format.hpp"

namespace fixproof::web {

namespace {

using oracle::Integer;

constexpr std::array oracle_rules{oracle::Rounding::half_up,   oracle::Rounding::half_away,
                                  oracle::Rounding::half_even, oracle::Rounding::floor,
                                  oracle::Rounding::ceiling,   oracle::Rounding::truncate};

/// Returns the exact result in units, as a fraction. Returns nothing for a zero divisor, and for a
/// root, which may be irrational.
std::optional<oracle::Ratio> exact_units(Operation operation, const Integer& a, const Integer& b,
                                         int fraction_bits) {
  const Integer one = Integer(1) << fraction_bits;
  switch (operation) {
    case Operation::add:
      return oracle::Ratio{a + b};
    case Operation::sub:
      return oracle::Ratio{a - b};
    case Operation::mul:
      return oracle::Ratio{a * b, one};
    case Operation::div:
      if (b == 0) return std::nullopt;
      return b < 0 ? oracle::Ratio{-a * one, -b} : oracle::Ratio{a * one, b};
    case Operation::sqrt:
      break;
  }
  return std::nullopt;
}

/// Returns the exact result in units, rounded by a rule, or nothing for a zero divisor and for the
/// root of a negative number.
std::optional<Integer> rounded_units(Operation operation, std::uint64_t a, std::uint64_t b,
                                     oracle::Rounding rule, const oracle::Format& f) {
  if (operation == Operation::sqrt) {
    return oracle::exact_root(a, oracle::Rounding::half_up, f);
  }
  const auto exact =
      exact_units(operation, oracle::ulps(a, f), oracle::ulps(b, f), f.fraction_bits);
  if (!exact) return std::nullopt;
  return oracle::rounded(exact->numerator, exact->denominator, rule);
}

/// Tells whether the word is what the oracle expects.
bool agrees(const std::optional<std::uint64_t>& word, const std::optional<Integer>& expected,
            const oracle::Format& f) {
  return word.has_value() == expected.has_value() && (!word || *word == oracle::wrap(*expected, f));
}

/// Writes a word, its value, and its distance from the exact result.
void write_word(Json& json, std::uint64_t word, const std::optional<oracle::Ratio>& exact,
                const NumberFormat& format) {
  const auto f = format.format.as<oracle::Format>();
  json.field("word", hex(word, f.bits));
  json.field("value", format.write(word));
  if (!exact) return;
  const Integer off = oracle::ulps(word, f) * exact->denominator - exact->numerator;
  json.field("units", decimal_text(off, exact->denominator, 6));
}

/// Writes what each policy does with the root of a negative number.
void write_negative_root(Json& json, std::uint64_t a, const NumberFormat& format) {
  json.object([&] {
    json.field("name", "wrapping, saturating");
    if (const auto word = format.answer[0](Operation::sqrt, a, 0))
      write_word(json, *word, std::nullopt, format);
  });
  json.object([&] {
    json.field("name", "trapping");
    json.field("ending", "throws domain_error");
  });
}

void write_rules(Json& json, Operation operation, std::uint64_t a, std::uint64_t b,
                 const NumberFormat& format, const std::optional<oracle::Ratio>& exact) {
  const auto f = format.format.as<oracle::Format>();
  const bool root = operation == Operation::sqrt;  // rounded to nearest by every rule
  if (root && oracle::ulps(a, f) < 0) return write_negative_root(json, a, format);
  for (std::size_t i = 0; i < (root ? 1U : rules.size()); ++i) {
    json.object([&] {
      const auto expected = rounded_units(operation, a, b, oracle_rules[i], f);
      const auto word = format.answer[i](operation, a, b);
      json.field("name", root ? "to nearest" : rule_names[i]);
      json.field("agrees", agrees(word, expected, f));
      json.field("wraps", expected && !oracle::fits(*expected, f));
      if (word) write_word(json, *word, exact, format);
    });
  }
  const auto expected = rounded_units(operation, a, b, oracle_rules[0], f);
  if (!expected || oracle::fits(*expected, f)) return;
  json.object([&] {
    const std::uint64_t word = format.saturated(operation, a, b).value_or(0);
    json.field("name", "half up, saturating");
    json.field("agrees", word == oracle::saturate(*expected, f));
    json.field("wraps", false);
    write_word(json, word, exact, format);
  });
}

/// Tells whether the word of a build is a result out of range, modulo the word. No rule and no 8088
/// quotient is off by half the range otherwise.
bool wraps(std::uint64_t word, const oracle::Ratio& exact, const oracle::Format& f) {
  const Integer off = oracle::ulps(word, f) * exact.denominator - exact.numerator;
  return abs(off) >= (Integer(1) << (f.bits - 1)) * exact.denominator;
}

void write_builds(Json& json, Operation operation, std::uint64_t a, std::uint64_t b,
                  const NumberFormat& format, const std::optional<oracle::Ratio>& exact) {
  const auto f = format.format.as<oracle::Format>();
  for (const BuildAnswer& build :
       answers_of_builds(operation, format.format, static_cast<std::uint32_t>(a),
                         static_cast<std::uint32_t>(b))) {
    json.object([&] {
      json.field("name", build.name);
      json.field("agrees", build.agrees);
      json.field("wraps", build.word && exact && wraps(*build.word, *exact, f));
      json.field("link", build.link);
      if (build.word) write_word(json, *build.word, exact, format);
    });
  }
}

}  // namespace

std::string operation_view(std::string_view request) {
  const auto lines = lines_of(request);
  Json json;
  json.object([&] {
    const auto operation = operation_named(lines[0]);
    const NumberFormat* const format = lines.size() == 4 ? format_named(lines[1]) : nullptr;
    if (!operation || format == nullptr) {
      json.field("error", "Choose one of the operations and formats.");
      return;
    }
    const bool unary = *operation == Operation::sqrt;
    std::array<std::uint64_t, 2> words{};
    for (std::size_t i = 0; i < (unary ? 1U : 2U); ++i) {
      const WordOperand operand = word_operand_of(lines[2 + i], *format);
      if (!operand.error.empty()) {
        json.field("error", (i == 0 ? "First number: " : "Second number: ") + operand.error);
        return;
      }
      words[i] = operand.word;
    }
    const auto f = format->format.as<oracle::Format>();
    const auto exact = exact_units(*operation, oracle::ulps(words[0], f), oracle::ulps(words[1], f),
                                   f.fraction_bits);
    if (unary) json.field("negative", oracle::ulps(words[0], f) < 0);
    json.object("first", [&] { write_word(json, words[0], std::nullopt, *format); });
    json.object("second", [&] { write_word(json, words[1], std::nullopt, *format); });
    if (exact) {
      const Integer scale = exact->denominator * (Integer(1) << f.fraction_bits);
      const Integer below =
          oracle::rounded(exact->numerator, exact->denominator, oracle::Rounding::floor);
      json.field("exact", decimal_text(exact->numerator, scale, 60));
      json.field("between", decimal_text(exact->numerator - below * exact->denominator,
                                         exact->denominator, 6));
      // The exact result is in range if it lies between two words of the format, or on one.
      const bool whole = below * exact->denominator == exact->numerator;
      json.field("fits", oracle::fits(below, f) && (whole || oracle::fits(below + 1, f)));
      json.object("below",
                  [&] { write_word(json, oracle::wrap(below, f), std::nullopt, *format); });
      json.object("above",
                  [&] { write_word(json, oracle::wrap(below + 1, f), std::nullopt, *format); });
    }
    json.array("rules", [&] { write_rules(json, *operation, words[0], words[1], *format, exact); });
    json.array("builds",
               [&] { write_builds(json, *operation, words[0], words[1], *format, exact); });
  });
  return json.text();
}

std::string answers(std::string_view request) {
  const auto lines = lines_of(request);
  const auto wanted = input::parts_of(lines[0]);
  if (wanted.size() < 2 || wanted.size() > 3) return {};
  const auto operation = operation_named(wanted[0]);
  const NumberFormat* const format = format_named(wanted[1]);
  if (!operation || format == nullptr) return {};
  NumberFormat::Answer answer_of = format->answer[0];
  if (wanted.size() == 3) {
    std::size_t rule = 0;
    const char* const end = wanted[2].data() + wanted[2].size();
    if (std::from_chars(wanted[2].data(), end, rule).ptr != end || rule > rules.size()) return {};
    answer_of = rule == rules.size() ? format->saturated : format->answer.at(rule);
  }
  std::string text;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    std::array<std::uint64_t, 2> words{};
    const char* at = lines[i].data();
    const char* const end = at + lines[i].size();
    for (std::uint64_t& word : words) {
      const auto [stop, error] = std::from_chars(at, end, word, 16);
      if (error != std::errc()) break;
      at = stop == end ? end : stop + 1;
    }
    if (at != end) return {};
    const auto answer = answer_of(*operation, words[0], words[1]);
    text += answer ? hex(*answer, format->format.word_bits) : "DE";
    text += '\n';
  }
  return text;
}

}  // namespace fixproof::web
