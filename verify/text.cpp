#include "verify/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "verify/hex.hpp"

namespace fixproof {

namespace {

std::string_view on_off(bool on) { return on ? "on" : "off"; }

/// Two's complement of `bits` bits.
std::int32_t signed_word(std::uint32_t word, int bits) {
  const int unused = 32 - bits;
  return static_cast<std::int32_t>(word << unused) >> unused;
}

std::string decimal(const Variant& v, std::uint32_t word) {
  if (v.operation == Operation::cossin) {
    return fmt::format("{:.1f} degrees", signed_word(word, operand_bits(v)) / 10.0);
  }
  // Exact: a word has fewer bits than a double.
  std::string text =
      fmt::format("{:.5f}", std::ldexp(signed_word(word, operand_bits(v)), -v.fraction_bits));
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

/// Options that choose the variant, each with a space before it.
std::string variant_options(const Variant& v, std::string_view rounding_option) {
  std::string options = fmt::format(" --target {}", name_of(v.target));
  if (v.target != Target::standard && v.operation != Operation::cossin) {
    options += fmt::format(" {} {}", rounding_option, on_off(rounds(v)));
  }
  if (v.chapter_52) options += " --chapter 52";
  if (v.repaired) options += " --repaired";
  return options;
}

std::string_view rounding_option(const Variant& v) {
  return v.operation == Operation::div ? "--div-round" : "--mul-round";
}

}  // namespace

std::string grouped(std::uint64_t number) {
  const std::string digits = fmt::to_string(number);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string duration(double seconds) {
  if (seconds < 60) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<std::uint64_t>(seconds);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

std::string name_of(const Variant& v) {
  std::string name = fmt::format("{} {}", name_of(v.operation), name_of(v.target));
  if (v.target != Target::standard) name += fmt::format(" {}", on_off(rounds(v)));
  if (v.chapter_52) name += ", chapter 52";
  if (v.repaired) name += ", repaired";
  if (v.fraction_bits == 8) name += ", 8.8";
  return name;
}

std::string hex_words(std::span<const std::uint32_t> words, int bits) {
  std::string text;
  for (const std::uint32_t word : words) {
    if (!text.empty()) text += ' ';
    append_hex(text, word, static_cast<std::size_t>(bits / 4));
  }
  return text;
}

std::string decimal_words(const Variant& v, std::span<const std::uint32_t> words) {
  std::string text;
  for (const std::uint32_t word : words) {
    if (!text.empty()) text += ' ';
    text += decimal(v, word);
  }
  return text;
}

std::string trace_line(const Variant& v, std::span<const std::uint32_t> words) {
  return fmt::format("fixproof trace {}{} {}", name_of(v.operation),
                     variant_options(v, rounding_option(v)), hex_words(words, operand_bits(v)));
}

std::string replay(const Row& row, std::span<const std::uint32_t> words) {
  const Variant& v = row.variant;
  const std::string hex = hex_words(words, operand_bits(v));
  if (v.target != Target::standard && v.fraction_bits == 16) {
    return fmt::format("echo '{}' | fixproof eval {}{} --by {}", hex, name_of(v.operation),
                       variant_options(v, rounding_option(v)), row.parties.front());
  }
  constexpr std::array<std::string_view, 4> usual{"model", "oracle", "fast", "type"};
  const bool unusual =
      std::any_of(row.parties.begin(), row.parties.end(), [&](const std::string& party) {
        return std::find(usual.begin(), usual.end(), party) == usual.end();
      });
  // Without these, rows of the other chapter or width, or the repaired routine's, would answer as
  // well.
  const bool other_chapter = (v.target == Target::i386 || loses_carry(v)) && !v.chapter_52;
  std::string line = fmt::format(
      "fixproof verify {}{}{}{} --case '{}'", name_of(v.operation), variant_options(v, "--round"),
      other_chapter ? " --chapter 54" : "", v.fraction_bits == 8 ? " --width half" : "", hex);
  if (unusual) {
    line += fmt::format(" --by {} --against {}", row.parties.front(),
                        fmt::join(row.parties.begin() + 1, row.parties.end(), ","));
  }
  return line;
}

}  // namespace fixproof
