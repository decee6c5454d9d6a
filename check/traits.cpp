#include "check/traits.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdlib>

namespace fixproof::check {

namespace {

constexpr std::uint32_t sign_bit = 0x80000000;
constexpr std::uint32_t whole_one = 0x10000;  ///< 1.0

/// A trait of one operand. The text has its name without an article in place of {}.
struct WordTrait {
  std::string_view text;
  bool (*holds)(std::uint32_t);
};
constexpr auto word_traits = std::to_array<WordTrait>({
    {"has {} 80000000", [](std::uint32_t w) { return w == sign_bit; }},
    {"has {} 7fffffff", [](std::uint32_t w) { return w == sign_bit - 1; }},
    {"has {} 00000000", [](std::uint32_t w) { return w == 0; }},
    {"has {} 00000001", [](std::uint32_t w) { return w == 1; }},
    {"has {} ffffffff", [](std::uint32_t w) { return w == 0xffffffff; }},
    {"has {} 00010000", [](std::uint32_t w) { return w == whole_one; }},
    {"has {} ffff0000", [](std::uint32_t w) { return w == 0U - whole_one; }},
    {"has a power of two as {}", [](std::uint32_t w) { return std::has_single_bit(magnitude(w)); }},
    {"has a whole number as {}", [](std::uint32_t w) { return w % whole_one == 0; }},
    {"has a negative {}", is_negative},
    {"has a positive {}", [](std::uint32_t w) { return w != 0 && !is_negative(w); }},
    {"has an odd {}", [](std::uint32_t w) { return w % 2 == 1; }},
    {"has an even {}", [](std::uint32_t w) { return w % 2 == 0; }},
});
constexpr std::size_t operand_groups = 3;  ///< first, second, either

/// A trait of two operands or of the exact result.
struct WholeTrait {
  About about;
  std::string_view text;
  bool (*holds)(const TraitCase&);
};

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
     [](const TraitCase& c) { return c.words[0] != 0 && c.words[0] == 0U - c.words[1]; }},
    {About::both, "has two negative operands",
     [](const TraitCase& c) { return is_negative(c.words[0]) && is_negative(c.words[1]); }},
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
     [](const TraitCase& c) { return inexact(c.kind) && c.place.floor == -1; }},
    {About::sign, "has an exact result below 0",
     [](const TraitCase& c) { return c.place.has_result && c.place.negative; }},
    {About::sign, "has an exact result above 0",
     [](const TraitCase& c) {
       return c.place.has_result && !c.place.negative && (c.place.floor > 0 || inexact(c.kind));
     }},
});
static_assert(operand_groups * word_traits.size() + pair_traits.size() + place_traits.size() <=
              max_traits);

/// Returns the wrong result minus the expected one modulo 2^32; 0 unless both are words.
constexpr std::int32_t error_of(const TraitCase& c) {
  return c.expected && c.said ? static_cast<std::int32_t>(*c.said - *c.expected) : 0;
}
constexpr bool both_words(const TraitCase& c) { return c.expected && c.said; }
constexpr std::int32_t outward(const TraitCase& c) { return c.place.negative ? -1 : 1; }

/// The first that holds is shown, so a trait stands before those that it implies.
constexpr auto wrong_traits = std::to_array<ResultTrait>({
    {"is DE in place of a word", [](const TraitCase& c) { return !c.said; }},
    {"is a word in place of DE", [](const TraitCase& c) { return !c.expected; }},
    {"is 1 ulp too low", [](const TraitCase& c) { return error_of(c) == -1; }},
    {"is 1 ulp too high", [](const TraitCase& c) { return error_of(c) == 1; }},
    {"is 1 ulp too far from 0", [](const TraitCase& c) { return error_of(c) == outward(c); }},
    {"is 1 ulp too near to 0", [](const TraitCase& c) { return error_of(c) == -outward(c); }},
    {"is off by 1 ulp", [](const TraitCase& c) { return std::abs(error_of(c)) == 1; }},
    {"is 1.0 too low, as if a carry from the fraction were lost",
     [](const TraitCase& c) { return error_of(c) == -static_cast<std::int32_t>(whole_one); }},
    {"is 1.0 too high, as if a borrow from the integer part were lost",
     [](const TraitCase& c) { return error_of(c) == static_cast<std::int32_t>(whole_one); }},
    {"has only the sign bit wrong",
     [](const TraitCase& c) { return both_words(c) && (*c.said ^ *c.expected) == sign_bit; }},
    {"is minus the expected one",
     [](const TraitCase& c) { return both_words(c) && *c.said == 0U - *c.expected; }},
    {"is 00000000", [](const TraitCase& c) { return c.said == 0U; }},
    {"is 7fffffff", [](const TraitCase& c) { return c.said == sign_bit - 1; }},
    {"is 80000000", [](const TraitCase& c) { return c.said == sign_bit; }},
    {"is 7fffffff or 80000000, by the sign of the exact result",
     [](const TraitCase& c) { return c.said == (c.place.negative ? sign_bit : sign_bit - 1); }},
    {"has the expected fraction, and another integer part",
     [](const TraitCase& c) { return both_words(c) && (*c.said ^ *c.expected) % whole_one == 0; }},
    {"has the expected integer part, and another fraction",
     [](const TraitCase& c) { return both_words(c) && (*c.said ^ *c.expected) < whole_one; }},
    {"is too low", [](const TraitCase& c) { return error_of(c) < 0; }},
    {"is too high", [](const TraitCase& c) { return error_of(c) > 0; }},
});
static_assert(wrong_traits.size() <= max_traits);

template <class Traits, class Case>
TraitSet set_of(const Traits& traits, const Case& of) {
  TraitSet set = 0;
  for (std::size_t i = 0; i < traits.size(); ++i) set |= TraitSet{traits[i].holds(of)} << i;
  return set;
}

}  // namespace

std::size_t case_trait_count() {
  return operand_groups * word_traits.size() + pair_traits.size() + place_traits.size();
}

TraitSet case_traits(cases::Operation operation, const TraitCase& of) {
  const TraitSet first = set_of(word_traits, of.words[0]);
  TraitSet operands = first;
  if (cases::words_in(operation) == 2) {
    const TraitSet second = set_of(word_traits, of.words[1]);
    operands |= second << word_traits.size() | (first | second) << (2 * word_traits.size()) |
                set_of(pair_traits, of) << (operand_groups * word_traits.size());
  }
  return operands | set_of(place_traits, of)
                        << (operand_groups * word_traits.size() + pair_traits.size());
}

About about(std::size_t case_trait) {
  const std::size_t group = case_trait / word_traits.size();
  if (group < operand_groups) return static_cast<About>(group);
  const std::size_t rest = case_trait - operand_groups * word_traits.size();
  return rest < pair_traits.size() ? pair_traits.at(rest).about
                                   : place_traits.at(rest - pair_traits.size()).about;
}

std::string case_trait_text(cases::Operation operation, std::size_t case_trait) {
  const std::size_t group = case_trait / word_traits.size();
  if (group < operand_groups) {
    const std::string_view noun = noun_of(operation, static_cast<About>(group));
    return fmt::format(fmt::runtime(word_traits.at(case_trait % word_traits.size()).text),
                       noun.substr(noun.find(' ') + 1));
  }
  const std::size_t rest = case_trait - operand_groups * word_traits.size();
  return std::string(rest < pair_traits.size() ? pair_traits.at(rest).text
                                               : place_traits.at(rest - pair_traits.size()).text);
}

std::string_view noun_of(cases::Operation operation, About operand) {
  if (operand == About::either || cases::words_in(operation) == 1) return "an operand";
  if (operation == cases::Operation::div) {
    return operand == About::first ? "a dividend" : "a divisor";
  }
  return operand == About::first ? "a first operand" : "a second operand";
}

TraitSet result_traits(const TraitCase& of) { return set_of(wrong_traits, of); }
std::size_t result_trait_count() { return wrong_traits.size(); }
std::string_view result_trait_text(std::size_t result_trait) {
  return wrong_traits.at(result_trait).text;
}

}  // namespace fixproof::check
