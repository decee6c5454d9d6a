#include "cases/words.hpp"

#include <fmt/format.h>

#include <cmath>

#include "support/hex.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cases {

namespace {

std::int32_t signed_word(std::uint32_t word, int bits) {
  const int unused = 32 - bits;
  return static_cast<std::int32_t>(word << unused) >> unused;
}

std::string decimal(const Variant& v, std::uint32_t word) {
  if (v.operation == Operation::cossin) {
    return fmt::format("{:.1f} degrees", signed_word(word, operand_bits(v)) / 10.0);
  }
  // The conversion is exact: a word has fewer bits than a double.
  std::string text =
      fmt::format("{:.5f}", std::ldexp(signed_word(word, operand_bits(v)), -v.fraction_bits));
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

void parse_words(std::string_view line, const Variant& v, std::span<std::uint32_t> words) {
  const auto digits = static_cast<std::size_t>(operand_bits(v) / 4);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto space = line.find(' ');
    const bool last = i + 1 == words.size();
    if (last != (space == std::string_view::npos)) {
      throw support::UsageError(fmt::format("{} takes {} word{}, separated by single spaces",
                                            name_of(v.operation), words.size(),
                                            words.size() > 1 ? "s" : ""));
    }
    words[i] = support::parse_hex(line.substr(0, space), digits);
    if (!last) line.remove_prefix(space + 1);
  }
}

std::string hex_words(std::span<const std::uint32_t> words, int bits) {
  std::string text;
  for (const std::uint32_t word : words) {
    if (!text.empty()) text += ' ';
    support::append_hex(text, word, static_cast<std::size_t>(bits / 4));
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

}  // namespace fixproof::cases
