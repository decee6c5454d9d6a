#include "verify/cases/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
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

/// Parses one to three digits without a leading zero or a sign.
std::optional<int> small_number(std::string_view digits) {
  if (digits.empty() || digits.size() > 3 || (digits.size() > 1 && digits[0] == '0')) return {};
  unsigned value = 0;  // of this type, from_chars takes no sign
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc() || stop != end) return {};
  return static_cast<int>(value);
}

/// The same with a minus sign before it, but for -0.
std::optional<int> small_integer(std::string_view text) {
  if (!text.starts_with('-')) return small_number(text);
  const auto size = small_number(text.substr(1));
  return size && *size != 0 ? std::optional(-*size) : std::nullopt;
}

/// Returns the format of a name of either kind, with any number of bits.
std::optional<Format> parsed(std::string_view name) {
  const std::size_t line = name.find('_');
  if (line == std::string_view::npos) return {};
  const auto fraction = small_integer(name.substr(line + 1));
  std::string_view before = name.substr(0, line);
  if (!fraction) return {};
  const bool is_decimal = before.starts_with('d') || before.starts_with("ud");
  if (!is_decimal && !before.starts_with('q') && !before.starts_with('u')) return {};
  const bool is_signed = !before.starts_with('u');
  before.remove_prefix(is_decimal && !is_signed ? 2 : 1);
  const auto number = small_integer(before);
  if (!number) return {};
  return Format{is_decimal ? *number : *number + *fraction, *fraction, is_signed, is_decimal};
}

/// Returns ` (did you mean NAME?)` for another way to write a format, such as Q16.16, or for one
/// that leaves out the sign, such as Q15.16 or q31; else nothing.
std::string meant_by(std::string_view name) {
  std::string letters;
  while (!name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0) {
    letters += static_cast<char>(std::tolower(static_cast<unsigned char>(name.front())));
    name.remove_prefix(1);
  }
  constexpr std::string_view digits = "0123456789";
  const std::size_t gap = std::min(name.find_first_not_of(digits), name.size());
  const bool has_two = gap < name.size();
  const auto first = small_number(name.substr(0, gap));
  const auto second = has_two ? small_number(name.substr(gap + 1)) : first;
  constexpr std::array<std::string_view, 7> for_signed{"", "q", "iq", "s", "fix", "fixed", "fx"};
  constexpr std::array<std::string_view, 3> for_unsigned{"u", "uq", "ufix"};
  const bool is_signed = std::ranges::find(for_signed, letters) != for_signed.end();
  const bool is_unsigned = std::ranges::find(for_unsigned, letters) != for_unsigned.end();
  if (!first || !second || is_signed == is_unsigned || (is_unsigned && !has_two)) return "";
  Format meant{(has_two ? *first : 1) + *second, *second, is_signed};
  if (is_signed && !is_of_type(meant)) ++meant.word_bits;
  return is_of_type(meant) ? fmt::format(" (did you mean {}?)", name_of(meant)) : "";
}

}  // namespace

std::string name_of(const Format& format) {
  if (format.is_decimal) {
    return fmt::format("{}{}_{}", format.is_signed ? "d" : "ud", format.word_bits,
                       format.fraction_bits);
  }
  return fmt::format("{}{}_{}", format.is_signed ? 'q' : 'u',
                     format.word_bits - format.fraction_bits, format.fraction_bits);
}

Format format_named(std::string_view name) {
  if (const auto format = parsed(name); format && is_of_type(*format)) return *format;
  throw support::UsageError(fmt::format(
      "{} is not a format{}; write one like q16_16 or u8_8, with 8, 16, 32 or 64 bits in all", name,
      meant_by(name)));
}

Format judged_format_named(std::string_view name) {
  const auto format = parsed(name);
  // A power of two beyond these is no scale that a word is meant to have, and one of ten costs
  // time.
  constexpr int most_digits = 38;
  const bool is_scale =
      format &&
      (format->is_decimal ? format->fraction_bits >= 0 && format->fraction_bits <= most_digits
                          : format->fraction_bits >= -64 && format->fraction_bits <= 128);
  if (is_scale && format->word_bits >= 2 && format->word_bits <= 64) return *format;
  throw support::UsageError(fmt::format(
      "{} is not a format{}; write one like q16_16, u8_8 or q2_16, with 2 to 64 bits in "
      "all, or like d64_8 for 64 bits in units of 10^-8",
      name, meant_by(name)));
}

std::span<const Format> named_formats() { return all_named; }

}  // namespace fixproof::cases
