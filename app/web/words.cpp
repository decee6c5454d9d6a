#include "app/web/words.hpp"

#include <algorithm>

namespace fixproof::web {

std::string hex(std::uint64_t word, int bits) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (int at = (bits + 3) / 4 - 1; at >= 0; --at) text += digits[word >> (4 * at) & 15U];
  return text;
}

std::string decimal_text(const oracle::Integer& numerator, const oracle::Integer& denominator,
                         std::size_t digits) {
  const bool negative = (numerator < 0) != (denominator < 0) && numerator != 0;
  const oracle::Integer divisor = abs(denominator);
  oracle::Integer rest = abs(numerator);
  const auto digit_of = [](const oracle::Integer& value) {
    return static_cast<char>('0' + static_cast<int>(value));
  };
  // Boost's own conversion uses streams, which would take half of the module.
  std::string text;
  oracle::Integer whole = rest / divisor;
  do {
    text += digit_of(oracle::Integer(whole % 10));
    whole /= 10;
  } while (whole != 0);
  if (negative) text += '-';
  std::reverse(text.begin(), text.end());
  rest %= divisor;
  if (rest == 0) return text;
  text += '.';
  for (std::size_t i = 0; i < digits && rest != 0; ++i) {
    rest *= 10;
    text += digit_of(oracle::Integer(rest / divisor));
    rest %= divisor;
  }
  return rest == 0 ? text : text + "\u2026";
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (true) {
    const std::size_t end = text.find('\n');
    lines.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return lines;
    text.remove_prefix(end + 1);
  }
}

}  // namespace fixproof::web
