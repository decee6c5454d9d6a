#include "app/cli/words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/input/number.hpp"
#include "oracle/format.hpp"
#include "support/hex.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"
#include "verify/cases/value.hpp"
#include "verify/cases/words.hpp"

namespace fixproof::cli {

namespace {

bool is_plain_word(std::string_view text, const cases::Format& format) {
  return cases::storage_bits(format) == format.word_bits &&
         text.size() == static_cast<std::size_t>(format.word_bits / 4) &&
         text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::string range_of(const cases::Format& format) {
  const std::uint64_t highest = cases::highest(format);
  return fmt::format("{} to {}",
                     format.is_signed ? "-" + cases::decimal_of(highest + 1, format) : "0",
                     cases::decimal_of(highest, format));
}

}  // namespace

std::uint64_t word_of(std::string_view text, const cases::Format& format) {
  // Most input is from programs, and is read fast.
  if (is_plain_word(text, format))
    return support::parse_long_hex(text, static_cast<std::size_t>(format.word_bits / 4));
  const input::Number number = input::number_of(text, format, input::Bare::word);
  if (!number.error.empty())
    throw support::UsageError(fmt::format("{}: {}", support::quoted(text), number.error));
  const auto f = format.as<oracle::Format>();
  const oracle::Integer units = cases::to_ulps(number.exact, oracle::Rounding::half_up, format);
  if (!oracle::fits(units, f)) {
    // Digits that a person takes for a word are a number unless they are as many as it has.
    const bool may_be_word =
        number.decimal == text && text.find_first_not_of("0123456789") == std::string_view::npos;
    throw support::UsageError(fmt::format(
        "{}: out of range, {} has {}{}", support::quoted(text), cases::name_of(format),
        range_of(format),
        may_be_word ? fmt::format("; a word has {} hexadecimal digits, or fewer after 0x",
                                  cases::storage_bits(format) / 4)
                    : ""));
  }
  if (f.fraction_bits == 0 && units * number.exact.denominator != number.exact.numerator)
    throw support::UsageError(fmt::format("{} is not a whole number", support::quoted(text)));
  return oracle::wrap(units, f);
}

void read_words(std::span<const std::string_view> numbers, const cases::Variant& v,
                std::span<std::uint32_t> words) {
  const std::size_t each = cases::operand_bits(v) > 32 ? 2 : 1;
  const std::size_t wanted = words.size() / each;
  if (numbers.size() != wanted) {
    throw support::UsageError(fmt::format("{} takes {} word{}, not {}", cases::name_of(v.operation),
                                          wanted, wanted == 1 ? "" : "s", numbers.size()));
  }
  const cases::Format format = v.operation == cases::Operation::cossin
                                   ? cases::Format{cases::operand_bits(v), 0, true}
                                   : cases::operand_format(v);
  for (std::size_t i = 0; i < wanted; ++i) {
    const std::uint64_t word = word_of(numbers[i], format);
    words[i * each] = static_cast<std::uint32_t>(word);
    if (each == 2) words[2 * i + 1] = static_cast<std::uint32_t>(word >> 32U);
  }
}

void read_words(std::string_view line, const cases::Variant& v, std::span<std::uint32_t> words) {
  const auto numbers = input::parts_of(line);
  read_words(numbers, v, words);
}

}  // namespace fixproof::cli
