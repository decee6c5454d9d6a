#include "judge/check/ports.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace fixproof::check {

namespace {

using cases::Operation;
using oracle::Rounding;
using Words = std::span<const std::int64_t>;

constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t least = std::numeric_limits<std::int32_t>::min();
constexpr std::int64_t unit = 65536;  ///< 1.0

/// The low 32 bits.
Said word(std::int64_t value) { return static_cast<std::uint32_t>(value); }

std::int64_t size(std::int64_t x) { return x < 0 ? -x : x; }

/// IDIV of a 64-bit dividend. It faults unless the truncated quotient fits 32 bits.
Said idiv(std::int64_t dividend, std::int64_t divisor) {
  if (divisor == 0) return std::nullopt;
  // The one quotient that does not fit 64 bits either.
  if (dividend == std::numeric_limits<std::int64_t>::min() && divisor == -1) return std::nullopt;
  const std::int64_t result = dividend / divisor;
  return result < least || result > most ? Said() : word(result);
}

/// abs() in 32 bits, in which the lowest number has no counterpart and stays as it is.
std::int64_t wrapped_size(std::int64_t x) { return x == least ? x : size(x); }

/// The guard of Doom's FixedDiv.
bool is_guarded(Words x) { return wrapped_size(x[0]) >> 14 >= wrapped_size(x[1]); }
Said guarded(Words x) { return word((x[0] ^ x[1]) < 0 ? least : most); }

/// The end of Allegro's range on the side of a sign. Its lowest number is not the end.
Said end_of_allegro(bool negative) { return word(negative ? -most : most); }

/// ftofix() of numerator / denominator, for a denominator above 0. From 32767 on it saturates.
Said rounded_by_allegro(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t whole = size(numerator) / denominator;
  const std::int64_t rest = size(numerator) % denominator;
  if (whole > 32767 * unit || (whole == 32767 * unit && rest != 0)) {
    return end_of_allegro(numerator < 0);
  }
  const std::int64_t rounded = whole + (rest >= denominator - rest ? 1 : 0);
  return word(numerator < 0 ? -rounded : rounded);
}

Said shifted_product(Words x, int fraction_bits) { return word((x[0] * x[1]) >> fraction_bits); }

Said product_half_up(Words x, int /*fraction_bits*/) {
  return word((x[0] * x[1] + unit / 2) >> 16);
}

Said shifted_quotient(Words x, int fraction_bits) {
  return idiv(x[0] * (std::int64_t{1} << fraction_bits), x[1]);
}

Said scaled(Words x, int /*fraction_bits*/) { return idiv(x[0] * x[1], x[2]); }

Said doom_quotient(Words x, int fraction_bits) {
  return is_guarded(x) ? guarded(x) : shifted_quotient(x, fraction_bits);
}

Said chocolate_quotient(Words x, int /*fraction_bits*/) {
  if (is_guarded(x)) return guarded(x);
  return x[1] == 0 ? Said() : word(x[0] * unit / x[1]);
}

Said allegro_i386_product(Words x, int /*fraction_bits*/) {
  const std::int64_t floor = (x[0] * x[1]) >> 16;
  if (floor < least || floor > most) return end_of_allegro((x[0] < 0) != (x[1] < 0));
  return word(floor);
}

Said allegro_i386_quotient(Words x, int /*fraction_bits*/) {
  const bool negative = (x[0] < 0) != (x[1] < 0);
  if (x[1] == 0) return end_of_allegro(negative);
  const std::int64_t truncated = size(x[0]) * unit / size(x[1]);
  if (truncated > most) return end_of_allegro(negative);
  return word(negative ? -truncated : truncated);
}

Said allegro_c_product(Words x, int /*fraction_bits*/) {
  const std::int64_t exact = x[0] * x[1];
  if (exact > most * unit) return word(most);
  if (exact < -most * unit) return word(least);
  return word(exact >> 16);
}

Said allegro_c_quotient(Words x, int /*fraction_bits*/) {
  if (x[1] == 0) return end_of_allegro(x[0] < 0);
  return rounded_by_allegro((x[1] < 0 ? -x[0] : x[0]) * unit, size(x[1]));
}

Said allegro_double_product(Words x, int /*fraction_bits*/) {
  return rounded_by_allegro(x[0] * x[1], unit);
}

Said wolf3d_product(Words x, int /*fraction_bits*/) {
  const std::int64_t cut = (size(x[0]) * (x[1] & 0xffff)) >> 16;
  return word((x[0] < 0) != (x[1] < 0) ? -cut : cut);
}

constexpr PortRule floored_product{.operation = Operation::mul,
                                   .text = "(int)((int64_t)a * b >> {F})",
                                   .result = shifted_product,
                                   .rounding = Rounding::floor,
                                   .overflow = Overflow::wrap};
constexpr PortRule idiv_quotient{
    .operation = Operation::div,
    .text = "IDIV of (int64_t)a << {F} by b: toward zero, DE if it does not fit",
    .result = shifted_quotient,
    .rounding = Rounding::truncate,
    .overflow = Overflow::error};
constexpr PortRule idiv_of_product{
    .operation = Operation::mul_div,
    .text = "IMUL, then IDIV: a * b / c toward zero, DE if it does not fit",
    .result = scaled,
    .rounding = Rounding::truncate,
    .overflow = Overflow::error};

constexpr PortRule named(std::string_view name, std::string_view routine, PortRule rule) {
  rule.name = name;
  rule.routine = routine;
  return rule;
}
constexpr PortRule shifting(PortRule rule) {
  rule.has_shift = true;
  return rule;
}

constexpr std::array all_rules{
    named("doom", "FixedMul", floored_product),
    named("doom", "FixedDiv",
          {.operation = Operation::div,
           .text = "if abs(a) >> 14 >= abs(b), 7fffffff or, if a ^ b < 0, 80000000; else IDIV",
           .result = doom_quotient,
           .rounding = Rounding::truncate,
           .overflow = Overflow::error,
           .is_general = false,
           .has_guard = true}),
    named("chocolate-doom", "FixedMul", floored_product),
    named("chocolate-doom", "FixedDiv",
          {.operation = Operation::div,
           .text = "the same with a 64-bit quotient, which wraps; DE for 80000000 / 0",
           .result = chocolate_quotient,
           .rounding = Rounding::truncate,
           .overflow = Overflow::wrap,
           .is_general = false,
           .has_guard = true}),
    named("build", "mulscale", shifting(floored_product)),
    named("build", "divscale", shifting(idiv_quotient)),
    named("build", "scale", shifting(idiv_of_product)),
    named("rott", "FixedMul",
          {.operation = Operation::mul,
           .text = "(int)(((int64_t)a * b + 0x8000) >> 16)",
           .result = product_half_up,
           .rounding = Rounding::half_up,
           .overflow = Overflow::wrap}),
    named("rott", "FixedDiv2", idiv_quotient),
    named("rott", "FixedScale", idiv_of_product),
    named("descent", "fixmul", floored_product),
    named("descent", "fixdiv", idiv_quotient),
    named("descent", "fixmuldiv", idiv_of_product),
    named("allegro-i386", "fixmul",
          {.operation = Operation::mul,
           .text = "IMUL: floor, 7fffffff or 80000001 beyond",
           .result = allegro_i386_product,
           .rounding = Rounding::floor,
           .overflow = Overflow::symmetric}),
    named("allegro-i386", "fixdiv",
          {.operation = Operation::div,
           .text = "DIV: toward zero, 7fffffff or 80000001 beyond, at -32768 and for b = 0",
           .result = allegro_i386_quotient,
           .rounding = Rounding::truncate,
           .overflow = Overflow::symmetric,
           .no_result = NoResult::symmetric,
           .is_general = false}),
    named("allegro-c", "fixmul",
          {.operation = Operation::mul,
           .text = "in 64 bits: floor, 7fffffff or 80000000 beyond",
           .result = allegro_c_product,
           .rounding = Rounding::floor,
           .overflow = Overflow::saturate}),
    named("allegro-c", "fixdiv",
          {.operation = Operation::div,
           .text = "in double: half away, 7fffffff or 80000001 beyond 32767 and for b = 0",
           .result = allegro_c_quotient,
           .rounding = Rounding::half_away,
           .overflow = Overflow::symmetric,
           .no_result = NoResult::symmetric,
           .is_general = false}),
    named("allegro-double", "fixmul",
          {.operation = Operation::mul,
           .text = "in double: half away, 7fffffff or 80000001 beyond 32767",
           .result = allegro_double_product,
           .rounding = Rounding::half_away,
           .overflow = Overflow::symmetric,
           .is_general = false}),
    named("wolf3d", "FixedByFrac",
          {.operation = Operation::mul,
           .text = "toward zero; b has its sign in bit 31 and a fraction in bits 0 to 15",
           .result = wolf3d_product,
           .rounding = Rounding::truncate,
           .overflow = Overflow::wrap,
           .is_general = false,
           .has_signed_fraction = true})};

}  // namespace

bool PortRule::is_for(const cases::Variant& of) const {
  const cases::Format& format = of.format;
  if (of.operation != operation || of.from || !cases::is_of_type(format)) return false;
  if (!has_shift) return format == cases::q16_16;
  return format.word_bits == 32 && format.is_signed && format.fraction_bits > 0;
}

std::span<const PortRule> port_rules() { return all_rules; }

Rules rules_of(const PortRule& rule, const cases::Format& format) {
  return {.variant = cases::variant_of(rule.operation, format),
          .rounding = rule.rounding,
          .overflow = rule.overflow,
          .no_result = rule.no_result,
          .port = &rule};
}

Said result_of(const PortRule& rule, const cases::Format& format, const Operands& operands) {
  std::array<std::int64_t, 3> values{};
  const auto used = std::span(values).first(cases::words_in(rule.operation));
  for (std::size_t i = 0; i < used.size(); ++i) {
    const std::uint64_t bits =
        operands.valued() != nullptr ? operands.valued()->words.at(i) : operands.words()[i];
    used[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(bits));
  }
  return rule.result(used, format.fraction_bits);
}

std::array<std::uint64_t, 2> read_words(const PortRule& rule,
                                        const std::array<std::uint64_t, 2>& words) {
  if (!rule.has_signed_fraction) return words;
  const std::uint64_t fraction = words[1] & 0xffff;
  const bool negative = is_negative(words[1], cases::q16_16);
  return {words[0], negative ? minus(fraction, cases::q16_16) : fraction};
}

std::string port_rules_text() {
  std::string text;
  for (const PortRule& rule : all_rules) {
    const std::string what = fmt::format(fmt::runtime(rule.text),
                                         fmt::arg("F", rule.has_shift ? std::string("F") : "16"));
    text += fmt::format("  {:<14} {:<7} {:<11} {}\n", rule.name, cases::name_of(rule.operation),
                        rule.routine, what);
  }
  return text;
}

}  // namespace fixproof::check
