#include "judge/check/traits.hpp"

#include <fmt/format.h>

#include <bit>
#include <optional>

namespace fixproof::check {

namespace {

using cases::Format;

/// A trait of one operand. The text has its name without an article in place of {}.
struct WordTrait {
  std::string_view text;
  bool (*holds)(std::uint64_t, const Format&);
};

using Value = std::optional<std::uint64_t>;

Value minus_one(const Format& f) {
  const Value one = f.is_signed ? whole_one(f) : std::nullopt;
  return one ? Value(minus(*one, f)) : std::nullopt;
}

/// The values of an operand that are traits; empty if the format lacks one.
constexpr std::size_t value_count = 7;
std::array<Value, value_count> values_of(const Format& f) {
  return {lowest(f),          highest(f),   Value(0),    Value(1),
          cases::all_ones(f), whole_one(f), minus_one(f)};
}
constexpr auto word_traits = std::to_array<WordTrait>({
    {"has a power of two as {}",
     [](std::uint64_t w, const Format& f) { return std::has_single_bit(magnitude(w, f)); }},
    {"has a whole number as {}",
     [](std::uint64_t w, const Format& f) { return (w & fraction_of(f)) == 0; }},
    {"has a negative {}", is_negative},
    {"has a positive {}",
     [](std::uint64_t w, const Format& f) { return w != 0 && !is_negative(w, f); }},
    {"has an odd {}", [](std::uint64_t w, const Format&) { return w % 2 == 1; }},
    {"has an even {}", [](std::uint64_t w, const Format&) { return w % 2 == 0; }},
});
constexpr std::size_t operand_traits = value_count + word_traits.size();
constexpr std::size_t operand_groups = 3;  ///< first, second, either

/// A trait of two operands or of the exact result.
struct WholeTrait {
  About about;
  std::string_view text;
  bool (*holds)(const TraitCase&);
};

/// The text has the highest word in place of {0}, the lowest in place of {1}, and 0 for {2}.
struct ResultTrait {
  std::string_view text;
  bool (*holds)(const TraitCase&);
};

constexpr bool inexact(CaseKind kind) {
  return kind == CaseKind::tie || kind == CaseKind::near_tie || kind == CaseKind::between;
}

constexpr auto pair_traits = std::to_array<WholeTrait>({
    {About::both, "has equal operands",
     [](const TraitCase& c) { return c.words[0] == c.words[1]; }},
    {About::both, "has operands that differ only in sign",
     [](const TraitCase& c) {
       return c.words[0] != 0 && c.words[0] == minus(c.words[1], c.operands);
     }},
    {About::both, "has two negative operands",
     [](const TraitCase& c) {
       return is_negative(c.words[0], c.operands) && is_negative(c.words[1], c.operands);
     }},
    {About::both, "has two odd operands",
     [](const TraitCase& c) { return (c.words[0] & c.words[1] & 1U) != 0; }},
});
constexpr auto place_traits = std::to_array<WholeTrait>({
    {About::kind, "divides by zero",
     [](const TraitCase& c) { return c.kind == CaseKind::no_result; }},
    {About::kind, "is an exact tie", [](const TraitCase& c) { return c.kind == CaseKind::tie; }},
    {About::kind, "is less than 1/1024 ulp below a tie",
     [](const TraitCase& c) { return c.kind == CaseKind::near_tie && c.place.fraction < 0.5; }},
    {About::kind, "is less than 1/1024 ulp above a tie",
     [](const TraitCase& c) { return c.kind == CaseKind::near_tie && c.place.fraction >= 0.5; }},
    {About::kind, "has a whole number of ulps as exact result",
     [](const TraitCase& c) { return c.kind == CaseKind::exact; }},
    {About::kind, "has an exact result between two words",
     [](const TraitCase& c) { return inexact(c.kind); }},
    {About::kind, "overflows", [](const TraitCase& c) { return c.kind == CaseKind::overflow; }},
    {About::sign, "has an exact result between -1 and 0 ulp",
     [](const TraitCase& c) {
       return inexact(c.kind) && c.place.floor.negative &&
              c.place.floor.word == cases::all_ones(c.format);
     }},
    {About::sign, "has an exact result below 0",
     [](const TraitCase& c) { return c.place.has_result && c.place.negative; }},
    {About::sign, "has an exact result above 0",
     [](const TraitCase& c) {
       return c.place.has_result && !c.place.negative &&
              (!c.place.floor.fits || c.place.floor.word != 0 || inexact(c.kind));
     }},
});
static_assert(operand_groups * operand_traits + pair_traits.size() + place_traits.size() <=
              max_traits);

constexpr bool both_words(const TraitCase& c) { return c.expected && c.said; }
/// Returns the wrong result minus the expected one as a word; 0 unless both are words.
constexpr std::uint64_t error_of(const TraitCase& c) {
  return both_words(c) ? (*c.said - *c.expected) & cases::all_ones(c.format) : 0;
}
/// Tells whether the wrong result is `word` above the expected one.
constexpr bool is_off_by(const TraitCase& c, Value word) { return word && error_of(c) == *word; }
/// Tells whether the nearer way from the expected result to the wrong one goes down.
constexpr bool goes_down(const TraitCase& c) {
  return (error_of(c) & std::uint64_t{1} << (c.format.word_bits - 1)) != 0;
}
constexpr bool up_by_1(const TraitCase& c) { return error_of(c) == 1; }
constexpr bool down_by_1(const TraitCase& c) { return error_of(c) == cases::all_ones(c.format); }
constexpr bool outward(const TraitCase& c) { return c.place.negative ? down_by_1(c) : up_by_1(c); }
constexpr bool inward(const TraitCase& c) { return c.place.negative ? up_by_1(c) : down_by_1(c); }
/// Tells whether words have an integer part and a fraction.
constexpr bool has_both_parts(const Format& f) {
  return !f.is_decimal && f.fraction_bits > 0 && f.fraction_bits < f.word_bits;
}
constexpr std::uint64_t wrong_bits(const TraitCase& c) {
  return both_words(c) ? *c.said ^ *c.expected : 0;
}

/// The first that holds is shown, so a trait stands before those that it implies.
constexpr auto wrong_traits = std::to_array<ResultTrait>({
    {"is no word of the format, which the bits above it show",
     [](const TraitCase& c) { return c.said && !is_word(*c.said, c.format); }},
    {"is DE in place of a word", [](const TraitCase& c) { return !c.said; }},
    {"is a word in place of DE", [](const TraitCase& c) { return !c.expected; }},
    {"is 1 ulp too low", down_by_1},
    {"is 1 ulp too high", up_by_1},
    {"is 1 ulp too far from 0", outward},
    {"is 1 ulp too near to 0", inward},
    {"is off by 1 ulp", [](const TraitCase& c) { return up_by_1(c) || down_by_1(c); }},
    {"is 1.0 too low, as if a carry from the fraction were lost",
     [](const TraitCase& c) {
       const Value one = whole_one(c.format);
       return one && is_off_by(c, minus(*one, c.format));
     }},
    {"is 1.0 too high, as if a borrow from the integer part were lost",
     [](const TraitCase& c) { return is_off_by(c, whole_one(c.format)); }},
    {"has only the sign bit wrong",
     [](const TraitCase& c) { return c.format.is_signed && wrong_bits(c) == sign_bit(c.format); }},
    {"is minus the expected one",
     [](const TraitCase& c) { return both_words(c) && *c.said == minus(*c.expected, c.format); }},
    {"is {2}", [](const TraitCase& c) { return c.said == 0U; }},
    {"is {0}", [](const TraitCase& c) { return c.said == highest(c.format); }},
    {"is {1}", [](const TraitCase& c) { return c.said == lowest(c.format); }},
    {"is {0} or {1}, by the sign of the exact result",
     [](const TraitCase& c) {
       return c.said == (c.place.negative ? lowest(c.format) : highest(c.format));
     }},
    {"has the expected fraction, and another integer part",
     [](const TraitCase& c) {
       return both_words(c) && has_both_parts(c.format) &&
              (wrong_bits(c) & fraction_of(c.format)) == 0;
     }},
    {"has the expected integer part, and another fraction",
     [](const TraitCase& c) {
       return both_words(c) && has_both_parts(c.format) &&
              (wrong_bits(c) & ~fraction_of(c.format)) == 0;
     }},
    {"is too low", goes_down},
    {"is too high", [](const TraitCase& c) { return error_of(c) != 0 && !goes_down(c); }},
});
static_assert(wrong_traits.size() <= max_traits);

template <class Traits>
TraitSet set_of(const Traits& traits, const TraitCase& of) {
  TraitSet set = 0;
  for (std::size_t i = 0; i < traits.size(); ++i) {
    set |= static_cast<TraitSet>(traits[i].holds(of)) << i;
  }
  return set;
}

TraitSet set_of_operand(std::uint64_t word, const Format& format) {
  TraitSet set = 0;
  const auto values = values_of(format);
  for (std::size_t i = 0; i < value_count; ++i) {
    set |= static_cast<TraitSet>(values[i] == word) << i;
  }
  for (std::size_t i = 0; i < word_traits.size(); ++i) {
    set |= static_cast<TraitSet>(word_traits[i].holds(word, format)) << (value_count + i);
  }
  return set;
}

}  // namespace

std::size_t case_trait_count() {
  return operand_groups * operand_traits + pair_traits.size() + place_traits.size();
}

TraitSet case_traits(const cases::Variant& variant, const TraitCase& of) {
  const std::size_t count = words_of(variant);
  const TraitSet first = count == 0 ? 0 : set_of_operand(of.words[0], of.operands);
  TraitSet operands = first;
  if (count == 2) {
    const TraitSet second = set_of_operand(of.words[1], of.operands);
    operands |= second << operand_traits | (first | second) << (2 * operand_traits) |
                set_of(pair_traits, of) << (operand_groups * operand_traits);
  }
  return operands | set_of(place_traits, of)
                        << (operand_groups * operand_traits + pair_traits.size());
}

About about(std::size_t case_trait) {
  const std::size_t group = case_trait / operand_traits;
  if (group < operand_groups) return static_cast<About>(group);
  const std::size_t rest = case_trait - operand_groups * operand_traits;
  return rest < pair_traits.size() ? pair_traits.at(rest).about
                                   : place_traits.at(rest - pair_traits.size()).about;
}

std::string case_trait_text(const cases::Variant& variant, std::size_t case_trait) {
  const cases::Operation operation = variant.operation;
  const Format format = operand_format(variant);
  const std::size_t group = case_trait / operand_traits;
  if (group < operand_groups) {
    const std::string_view with_article = noun_of(operation, static_cast<About>(group));
    const std::string_view noun = with_article.substr(with_article.find(' ') + 1);
    const std::size_t of_operand = case_trait % operand_traits;
    if (of_operand < value_count) {
      return fmt::format("has {} {}", noun,
                         hex_text(values_of(format).at(of_operand).value(), format));
    }
    return fmt::format(fmt::runtime(word_traits.at(of_operand - value_count).text), noun);
  }
  const std::size_t rest = case_trait - operand_groups * operand_traits;
  if (rest < pair_traits.size()) return std::string(pair_traits.at(rest).text);
  if (rest == pair_traits.size() && operation == cases::Operation::from_binary64) {
    return "has NaN or an infinity as operand";
  }
  if (rest == pair_traits.size() && cases::is_function(operation)) {
    return "has an operand outside the domain";
  }
  return std::string(place_traits.at(rest - pair_traits.size()).text);
}

std::string_view noun_of(cases::Operation operation, About operand) {
  if (operand == About::either || cases::words_in(operation) == 1) return "an operand";
  if (operation == cases::Operation::div || is_remainder(operation)) {
    return operand == About::first ? "a dividend" : "a divisor";
  }
  return operand == About::first ? "a first operand" : "a second operand";
}

TraitSet result_traits(const TraitCase& of) { return set_of(wrong_traits, of); }
std::string result_trait_text(const Format& format, std::size_t result_trait) {
  return fmt::format(fmt::runtime(wrong_traits.at(result_trait).text),
                     hex_text(highest(format), format), hex_text(lowest(format), format),
                     hex_text(0, format));
}

}  // namespace fixproof::check
