#include "support/hex.hpp"

#include <fmt/format.h>

#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::support {

std::uint64_t parse_long_hex(std::string_view text, std::size_t digits) {
  std::uint64_t word = 0;
  for (const char c : text) {
    const bool decimal = c >= '0' && c <= '9';
    if (!decimal && (c < 'a' || c > 'f')) {
      throw UsageError(fmt::format("{} is not lower-case hex", quoted(text)));
    }
    word = word << 4U | static_cast<std::uint64_t>(decimal ? c - '0' : c - 'a' + 10);
  }
  if (text.size() != digits) {
    throw UsageError(fmt::format("{} has {} hex digit{} instead of {}", quoted(text), text.size(),
                                 text.size() == 1 ? "" : "s", digits));
  }
  return word;
}

std::uint32_t parse_hex(std::string_view text, std::size_t digits) {
  return static_cast<std::uint32_t>(parse_long_hex(text, digits));
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

}  // namespace fixproof::support
