#include "verify/hex.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "verify/usage_error.hpp"

namespace fixproof {

namespace {

/// The bytes of a character at the beginning of `text` that steers a terminal or turns the
/// direction of writing: C0 and DEL, C1 (U+0080 ...), and the marks of the bidirectional algorithm;
/// else 0.
std::size_t steering(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < ' ' || byte(0) == 0x7f) return 1;
  if (text.size() >= 2 && byte(0) == 0xc2 && byte(1) >= 0x80 && byte(1) < 0xa0) return 2;
  if (text.size() < 3 || byte(0) != 0xe2) return 0;
  const bool mark = byte(1) == 0x80 && (byte(2) == 0x8e || byte(2) == 0x8f);     // U+200E, F
  const bool embedding = byte(1) == 0x80 && byte(2) >= 0xaa && byte(2) <= 0xae;  // U+202A ... E
  const bool isolate = byte(1) == 0x81 && byte(2) >= 0xa6 && byte(2) <= 0xa9;    // U+2066 ... 9
  return mark || embedding || isolate ? 3 : 0;
}

}  // namespace

std::string printable(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t bytes = steering(std::string_view(text).substr(i));
    result += bytes > 0 ? '?' : text[i];
    i += std::max<std::size_t>(bytes, 1);
  }
  return result;
}

std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result = "'";
  for (const char c : text.substr(0, longest)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (text.size() > longest ? "...'" : "'");
}

std::uint32_t parse_hex(std::string_view text, std::size_t digits) {
  std::uint32_t word = 0;
  for (const char c : text) {
    const bool decimal = c >= '0' && c <= '9';
    if (!decimal && (c < 'a' || c > 'f')) {
      throw UsageError(fmt::format("{} is not lower-case hex", quoted(text)));
    }
    word = word << 4U | static_cast<std::uint32_t>(decimal ? c - '0' : c - 'a' + 10);
  }
  if (text.size() != digits) {
    throw UsageError(fmt::format("{} has {} hex digit{} instead of {}", quoted(text), text.size(),
                                 text.size() == 1 ? "" : "s", digits));
  }
  return word;
}

void parse_words(std::string_view line, const Variant& v, std::span<std::uint32_t> words) {
  const auto digits = static_cast<std::size_t>(operand_bits(v) / 4);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto space = line.find(' ');
    const bool last = i + 1 == words.size();
    if (last != (space == std::string_view::npos)) {
      throw UsageError(fmt::format("{} takes {} word{} with single spaces between",
                                   name_of(v.operation), words.size(),
                                   words.size() > 1 ? "s" : ""));
    }
    words[i] = parse_hex(line.substr(0, space), digits);
    if (!last) line.remove_prefix(space + 1);
  }
}

void append_hex(std::string& to, std::uint32_t word, std::size_t digits) {
  constexpr std::string_view alphabet = "0123456789abcdef";
  const std::size_t end = to.size() + digits;
  to.resize(end);
  for (std::size_t i = 1; i <= digits; ++i) {
    to[end - i] = alphabet[word & 0xFU];
    word >>= 4U;
  }
}

}  // namespace fixproof
