// Target `decimal_text`: reads the input as text in every way the type offers, writes its first
// four bytes as a word, and compares both with the oracle's decimal.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

#include "fixed/fixed.hpp"
#include "fixed/std_format.hpp"
#include "fuzz/finding.hpp"
#include "fuzz/oracle_rule.hpp"
#include "fuzz/words.hpp"
#include "oracle/decimal.hpp"
#include "oracle/format.hpp"

using namespace fixproof;

namespace {

using oracle::Word;

constexpr std::size_t max_text = 600;

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The length of the longest prefix that is a decimal number; 0 if there is none.
std::size_t number_at_start(std::string_view text) {
  const auto digits_from = [text](std::size_t at) {
    while (at < text.size() && is_digit(text[at])) ++at;
    return at;
  };
  const auto is_at = [text](std::size_t at, std::string_view any) {
    return at < text.size() && any.find(text[at]) != std::string_view::npos;
  };
  const std::size_t first = is_at(0, "-+") ? 1 : 0;
  std::size_t end = digits_from(first);
  if (is_at(end, ".")) end = digits_from(end + 1);
  if (text.substr(first, end - first).find_first_of("0123456789") == std::string_view::npos) {
    return 0;
  }
  if (!is_at(end, "eE")) return end;
  const std::size_t exponent = end + (is_at(end + 1, "-+") ? 2 : 1);
  const std::size_t last = digits_from(exponent);
  return last == exponent ? end : last;
}

/// The same number without an exponent. Exponents beyond max_text move every digit of the text out
/// of the range or below all ulps, so they need not be larger than that.
std::string without_exponent(std::string_view number) {
  const std::size_t mark = number.find_first_of("eE");
  if (mark == std::string_view::npos) return std::string(number);
  const bool has_sign = number[0] == '-' || number[0] == '+';
  const std::string_view all_digits = number.substr(0, mark).substr(has_sign ? 1 : 0);
  const std::size_t point = std::min(all_digits.find('.'), all_digits.size());
  std::string digits(all_digits.substr(0, point));
  if (point != all_digits.size()) digits += all_digits.substr(point + 1);
  constexpr std::size_t limit = max_text + 50;
  std::size_t exponent = 0;
  for (const char c : number.substr(mark + 1)) {
    if (is_digit(c)) exponent = std::min(limit, exponent * 10 + static_cast<std::size_t>(c - '0'));
  }
  std::size_t whole = point;
  if (number[mark + 1] == '-') {
    digits.insert(0, exponent + 1, '0');
    whole += 1;
  } else {
    digits.append(exponent + 1, '0');
    whole += exponent;
  }
  digits.insert(whole, 1, '.');
  return (number[0] == '-' ? "-" : "") + digits;
}

std::string shown(std::string_view text) { return fmt::format("\"{}\"", text.substr(0, 200)); }

template <class Number>
Word word_of(Number x) {
  return static_cast<std::make_unsigned_t<typename Number::raw_type>>(x.raw());
}

/// The word for the text; nothing if it is not a number in range.
template <class Number>
std::optional<Word> expected_word(std::string_view number) {
  const auto exact = oracle::from_decimal(without_exponent(number),
                                          fixproof::fuzz::oracle_rule(Number::rules.multiply),
                                          Number::fraction_bits);
  if (!exact || !oracle::fits(*exact, Number::fraction_bits)) return std::nullopt;
  return oracle::wrap(*exact, Number::fraction_bits);
}

template <class Number>
void read_text(std::string_view text) {
  const Number before = Number::from_raw(0x55);
  Number read = before;
  const auto result = fixproof::from_chars(text.data(), text.data() + text.size(), read);
  const std::size_t length = number_at_start(text);
  const auto expected = expected_word<Number>(text.substr(0, length));
  std::errc error{};
  if (length == 0) {
    error = std::errc::invalid_argument;
  } else if (!expected) {
    error = std::errc::result_out_of_range;
  }
  const Word word = expected.value_or(word_of(before));
  if (result.ec != error || result.ptr != text.data() + length || word_of(read) != word) {
    fuzz::report_finding(fmt::format(
        "from_chars of {}, {} fraction bits: {:08x}, error {}, {} characters; the oracle says "
        "{:08x}, error {}, {}",
        shown(text), Number::fraction_bits, word_of(read), static_cast<int>(result.ec),
        result.ptr - text.data(), word, static_cast<int>(error), length));
  }
}

/// Compares `>>` with from_chars() after white space, except for an exponent without digits.
template <class Number>
void read_stream(std::string_view text) {
  std::istringstream in{std::string(text)};
  Number read = Number::from_raw(0x55);
  in >> read;
  const std::size_t start = text.find_first_not_of(" \t\n\v\f\r");
  std::optional<Word> expected;
  if (start != std::string_view::npos) {
    const std::string_view rest = text.substr(start);
    const std::size_t length = number_at_start(rest);
    const std::string_view number = rest.substr(0, length);
    const char next = length > 0 && length < rest.size() ? rest[length] : ' ';
    const bool has_exponent = number.find_first_of("eE") != std::string_view::npos;
    const bool left = !has_exponent && (next == 'e' || next == 'E');
    if (!left) expected = expected_word<Number>(number);
  }
  if (in.fail() == expected.has_value() || word_of(read) != expected.value_or(0x55)) {
    fuzz::report_finding(
        fmt::format("stream of {}, {} fraction bits: {:08x}, fail {}; the oracle "
                    "says {}",
                    shown(text), Number::fraction_bits, word_of(read), in.fail(),
                    expected ? fmt::format("{:08x}", *expected) : "fail"));
  }
}

template <class Number>
void write_word(Word word) {
  const auto x = Number::from_raw(static_cast<typename Number::raw_type>(word));
  const std::string expected = oracle::to_decimal(word_of(x), Number::fraction_bits);
  const auto demand = [&](std::string_view how, std::string_view text) {
    if (text == expected) return;
    fuzz::report_finding(fmt::format("{} of {:0{}x}, {} fraction bits: {}; the oracle says {}", how,
                                     word_of(x), Number::fraction_bits / 2, Number::fraction_bits,
                                     shown(text), expected));
  };
  demand("to_string", fixproof::to_string(x));
  demand("format", fmt::format("{}", x));
  std::ostringstream out;
  out << x;
  demand("<<", out.str());
  std::array<char, fixproof::max_chars<Number>> buffer{};
  for (std::size_t room = 0; room <= buffer.size(); ++room) {
    buffer.fill('#');
    const auto written = fixproof::to_chars(buffer.data(), buffer.data() + room, x);
    const auto length = static_cast<std::size_t>(written.ptr - buffer.data());
    if (room >= expected.size()) {
      demand("to_chars", {buffer.data(), length});
    } else if (written.ec != std::errc::value_too_large || length != room || buffer[0] != '#') {
      fuzz::report_finding(fmt::format("to_chars of {:08x} into {} characters", word_of(x), room));
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // The oracle's time is quadratic in the number of digits.
  const std::string text(data, data + std::min(size, max_text));
  read_text<fixproof::q16_16>(text);
  read_text<fixproof::q16_16_saturating>(text);
  read_text<fixproof::q16_16_i8088>(text);
  read_text<fixproof::q16_16_i386_unrounded>(text);
  read_text<fixproof::q16_16_i8088_unrounded>(text);
  read_text<fixproof::q8_8>(text);
  read_stream<fixproof::q16_16>(text);
  read_stream<fixproof::q8_8_i8088>(text);
  std::array<std::uint32_t, 1> word{};
  fuzz::read_words({data, size}, word);
  write_word<fixproof::q16_16>(word[0]);
  write_word<fixproof::q8_8>(word[0]);
  return 0;
}
