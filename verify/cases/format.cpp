#include "verify/cases/format.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>

#include "support/usage_error.hpp"

namespace fixproof::cases {

namespace {

constexpr Format q(int whole, int fraction) { return {whole + fraction, fraction, true}; }
constexpr Format u(int whole, int fraction) { return {whole + fraction, fraction, false}; }

// The aliases of fixed/formats.hpp. A test compares the two lists.
constexpr std::array all_named{q(8, 0),   q(4, 4),  q(1, 7),  u(4, 4),   u(0, 8),   q(12, 4),
                               q(8, 8),   q(4, 12), q(2, 14), q(1, 15),  u(8, 8),   u(1, 15),
                               u(0, 16),  q(32, 0), q(26, 6), q(24, 8),  q(20, 12), q(16, 16),
                               q(8, 24),  q(4, 28), q(2, 30), q(1, 31),  u(24, 8),  u(16, 16),
                               u(8, 24),  u(1, 31), u(0, 32), q(48, 16), q(40, 24), q(32, 32),
                               q(16, 48), q(2, 62), q(1, 63), u(48, 16), u(32, 32), u(0, 64)};

/// Parses one or two digits without a leading zero or a sign.
std::optional<int> small_number(std::string_view digits) {
  if (digits.empty() || digits.size() > 2 || (digits.size() == 2 && digits[0] == '0')) return {};
  unsigned value = 0;  // of this type, from_chars takes no sign
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc() || stop != end) return {};
  return static_cast<int>(value);
}

}  // namespace

std::string name_of(const Format& format) {
  return fmt::format("{}{}_{}", format.is_signed ? 'q' : 'u',
                     format.word_bits - format.fraction_bits, format.fraction_bits);
}

Format format_named(std::string_view name) {
  const bool is_signed = name.starts_with('q');
  const std::size_t line = name.find('_');
  if ((is_signed || name.starts_with('u')) && line != std::string_view::npos) {
    const auto whole = small_number(name.substr(1, line - 1));
    const auto fraction = small_number(name.substr(line + 1));
    if (whole && fraction) {
      const int bits = *whole + *fraction;
      if (bits == 8 || bits == 16 || bits == 32 || bits == 64) return {bits, *fraction, is_signed};
    }
  }
  throw support::UsageError(fmt::format(
      "{} is not a format; write one like q16_16 or u8_8, with 8, 16, 32 or 64 bits in all", name));
}

std::span<const Format> named_formats() { return all_named; }

}  // namespace fixproof::cases
