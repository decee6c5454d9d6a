#include "support/plain_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace fixproof::support {

namespace {

/// Returns the length in bytes of a character at the beginning of `text` that controls a terminal
/// or changes the text direction, else 0. These are C0, DEL, C1 (U+0080 to U+009F) and the marks of
/// the bidirectional algorithm.
std::size_t control_length(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < ' ' || byte(0) == 0x7f) return 1;
  if (text.size() >= 2 && byte(0) == 0xc2 && byte(1) >= 0x80 && byte(1) < 0xa0) return 2;
  if (text.size() < 3 || byte(0) != 0xe2) return 0;
  const bool mark = byte(1) == 0x80 && (byte(2) == 0x8e || byte(2) == 0x8f);     // U+200E, U+200F
  const bool embedding = byte(1) == 0x80 && byte(2) >= 0xaa && byte(2) <= 0xae;  // U+202A to U+202E
  const bool isolate = byte(1) == 0x81 && byte(2) >= 0xa6 && byte(2) <= 0xa9;    // U+2066 to U+2069
  return mark || embedding || isolate ? 3 : 0;
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

std::string printable(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t bytes = control_length(text.substr(i));
    result += bytes > 0 ? '?' : text[i];
    i += std::max<std::size_t>(bytes, 1);
  }
  return result;
}

std::string printable_ascii(std::string_view text) {
  std::string result(text);
  for (char& c : result) {
    if (c < ' ' || c > '~') c = '?';
  }
  return result;
}

std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 40;
  return fmt::format("'{}{}'", printable_ascii(text.substr(0, longest)),
                     text.size() > longest ? "..." : "");
}

}  // namespace fixproof::support
