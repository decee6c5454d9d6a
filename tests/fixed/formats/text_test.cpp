/// Tests the text of numbers of every format against integers of 1,024 bits: digits after the
/// point, scientific, hexadecimal and binary output, and input with and without an exponent.
#include <iomanip>

#include "fixed/fixed.hpp"
#include "tests/fixed/formats/reference.hpp"
#include "tests/fixed/formats/types.hpp"
#include "tests/support/test.hpp"
// The order matters: the test needs fmt after fixed, so do not sort the includes.
#include <fmt/format.h>

#include "fixed/std_format.hpp"

namespace text_test {

using fixproof::rounding;
using reference::integer;
using reference::number_of;
using reference::power;
using reference::Type;
using reference::with_point;
using reference::Word;
using reference::word_of;

/// Writing and reading numbers of one type.
struct Calls {
  Type type;
  std::string (*format)(const std::string& text, Word x);
  void (*write)(std::ostream& out, Word x);
  /// Read a number. Without one, or with one that is out of range, x stays as it is.
  std::from_chars_result (*from_chars)(const std::string& text, Word& x);
  void (*read)(std::istream& in, Word& x);

  template <class N>
  static Calls of() {
    return {Type::of<N>(),
            [](const std::string& text, Word x) {
              return fmt::format(fmt::runtime(text), number_of<N>(x));
            },
            [](std::ostream& out, Word x) { out << number_of<N>(x); },
            [](const std::string& text, Word& x) {
              auto number = number_of<N>(x);
              const auto result =
                  fixproof::from_chars(text.data(), text.data() + text.size(), number);
              x = word_of(number);
              return result;
            },
            [](std::istream& in, Word& x) {
              auto number = number_of<N>(x);
              in >> number;
              x = word_of(number);
            }};
  }
};

/// The value of a stored integer without its sign.
integer magnitude(const Type& type, Word x) {
  const integer value = type.value(x);
  return value < 0 ? -value : value;
}

std::string sign_of(const Type& type, Word x) { return type.value(x) < 0 ? "-" : ""; }

std::string fixed_text(const Type& type, Word x, int precision) {
  const integer scaled = magnitude(type, x) * power(10, precision);
  const integer digits = reference::round(scaled, type.one, rounding::half_even);
  return sign_of(type, x) + with_point(digits.str(), precision);
}

std::string scientific_text(const Type& type, Word x, int precision) {
  int exponent = 0;
  integer n = magnitude(type, x);
  integer d = type.one;
  if (n != 0) {
    for (; n >= 10 * d; d *= 10) ++exponent;
    for (; n < d; n *= 10) --exponent;
  }
  integer digits = reference::round(n * power(10, precision), d, rounding::half_even);
  if (digits == power(10, precision + 1)) {
    digits /= 10;
    ++exponent;
  }
  const std::string size = std::to_string(exponent < 0 ? -exponent : exponent);
  return sign_of(type, x) + with_point(digits.str(), precision) + (exponent < 0 ? "e-" : "e+") +
         (size.size() < 2 ? "0" : "") + size;
}

/// The text in a base of 2^bits_per_digit.
std::string binary_text(const Type& type, Word x, int bits_per_digit) {
  const int places = (type.fraction_bits + bits_per_digit - 1) / bits_per_digit;
  integer units = magnitude(type, x) * power(2, places * bits_per_digit - type.fraction_bits);
  std::string digits;
  for (; units != 0; units /= power(2, bits_per_digit)) {
    const auto digit = static_cast<int>(units % power(2, bits_per_digit));
    digits.insert(0, 1, "0123456789abcdef"[digit]);
  }
  if (digits.empty()) digits = "0";
  digits = with_point(digits, places);
  if (places > 0) digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return sign_of(type, x) + digits;
}

std::string streamed(const Calls& calls, Word x, std::ios_base& (*form)(std::ios_base&),
                     int precision) {
  std::ostringstream out;
  out << form << std::setprecision(precision);
  calls.write(out, x);
  return out.str();
}

template <class... More, class... T>
testing::Types<T..., More...> with(testing::Types<T...> formats);

/// The reader of text changes its method at 18 and at 60 fraction bits.
using TextFormats =
    decltype(with<fixproof::number<std::int32_t, 17>, fixproof::number<std::int32_t, 18>,
                  fixproof::number<std::int64_t, 59, formats::even_saturate>,
                  fixproof::number<std::uint64_t, 60>>(formats::wide()));

bool text_test(const char* test, void (*body)(const Calls&), int line = __builtin_LINE()) {
  return each_type::add_each<TextFormats>("FormatText", test, body, __FILE__, line);
}

[[maybe_unused]] const bool precisions = text_test("RoundsToAnyPrecision", [](const Calls& calls) {
  const Type& type = calls.type;
  for (const Word x : reference::operands(type, 10)) {
    for (int precision = 0; precision <= 70; precision += precision < 24 ? 1 : 5) {
      const std::string decimal = fixed_text(type, x, precision);
      ASSERT_EQ(calls.format(fmt::format("{{:.{}f}}", precision), x), decimal);
      ASSERT_EQ(streamed(calls, x, std::fixed, precision), decimal);
      const std::string scientific = scientific_text(type, x, precision);
      ASSERT_EQ(calls.format(fmt::format("{{:.{}e}}", precision), x), scientific)
          << listed(type, {x});
      ASSERT_EQ(streamed(calls, x, std::scientific, precision), scientific) << listed(type, {x});
    }
  }
});

/// Where long double holds every number exactly, printf must agree.
[[maybe_unused]] const bool like_printf = text_test("AgreesWithPrintf", [](const Calls& calls) {
  if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "long double is too short";
  const Type& type = calls.type;
  std::array<char, 200> text{};
  for (const Word x : reference::operands(type, 100)) {
    const auto raw = type.is_signed ? static_cast<long double>(static_cast<std::int64_t>(x))
                                    : static_cast<long double>(x);
    const long double value = std::ldexp(raw, -type.fraction_bits);
    for (const int precision : {0, 1, 2, 6, 17, 70}) {
      std::snprintf(text.data(), text.size(), "%.*Lf", precision, value);
      ASSERT_EQ(streamed(calls, x, std::fixed, precision), text.data());
      std::snprintf(text.data(), text.size(), "%.*Le", precision, value);
      ASSERT_EQ(streamed(calls, x, std::scientific, precision), text.data());
    }
  }
});

[[maybe_unused]] const bool bases = text_test("HexadecimalAndBinary", [](const Calls& calls) {
  const Type& type = calls.type;
  for (const Word x : reference::operands(type, 60)) {
    ASSERT_EQ(calls.format("{:x}", x), binary_text(type, x, 4)) << listed(type, {x});
    ASSERT_EQ(calls.format("{:b}", x), binary_text(type, x, 1)) << listed(type, {x});
  }
});

/// digits * 10^exponent, as a text of either form.
struct Decimal {
  bool negative = false;
  integer digits = 0;
  int exponent = 0;
};

/// The first text of the number that is read wrong, or nothing.
std::string first_wrong(const Calls& calls, const Decimal& decimal) {
  const Type& type = calls.type;
  const integer n = (decimal.negative ? -decimal.digits : decimal.digits) * type.one *
                    power(10, (std::max)(decimal.exponent, 0));
  const integer expected =
      reference::round(n, power(10, (std::max)(-decimal.exponent, 0)), type.rules.multiply);
  const bool fits = type.fits(expected);
  const std::string sign = decimal.negative ? "-" : "";
  const std::string digits = decimal.digits.str();
  const auto size = static_cast<int>(digits.size());
  const std::string zeros(300, '0');
  // Without an exponent.
  const int places = (std::max)(-decimal.exponent, 0);
  const auto missing = static_cast<std::size_t>((std::max)(places + 1 - size, 0));
  const std::string padded = std::string(missing, '0') + digits +
                             zeros.substr(0, static_cast<std::size_t>(decimal.exponent + places));
  const auto power_text = [](int exponent) { return "e" + std::to_string(exponent); };
  for (const std::string& text : {
           with_point(padded, places),
           digits + power_text(decimal.exponent),
           digits + zeros + power_text(decimal.exponent - 300),
           zeros + digits + "." + zeros + power_text(decimal.exponent),
           "0." + digits + power_text(decimal.exponent + size),
           "0." + zeros + digits + power_text(decimal.exponent + size + 300),
           digits.substr(0, 1) + "." + digits.substr(1) + "0E" +
               std::to_string(decimal.exponent + size - 1),
       }) {
    const std::string all = sign + text;
    const Word before = 77;
    const Word right = fits ? type.stored(expected) : before;
    Word read = before;
    const auto result = calls.from_chars(all, read);
    const auto error = fits ? std::errc() : std::errc::result_out_of_range;
    if (result.ec != error || result.ptr != all.data() + all.size() || read != right) return all;
    std::istringstream in(all);
    Word streamed = before;
    calls.read(in, streamed);
    if (in.fail() == fits || streamed != right) return "stream: " + all;
  }
  return {};
}

/// Ties, numbers beside them and random ones.
std::vector<Decimal> decimals_of(const Type& type) {
  const int places = type.fraction_bits + 1;
  std::vector<Decimal> decimals;
  for (const Word x : reference::operands(type, 10)) {
    // A tie, the numbers beside it at any distance, and the number itself.
    const integer tie = (2 * magnitude(type, x) + 1) * power(5, places);
    for (const bool negative : {false, true}) {
      decimals.push_back(
          {negative, magnitude(type, x) * power(5, type.fraction_bits), -type.fraction_bits});
      decimals.push_back({negative, tie, -places});
      for (const int further : {1, 40}) {
        const integer scaled = tie * power(10, further);
        decimals.push_back({negative, scaled + 1, -places - further});
        decimals.push_back({negative, scaled - 1, -places - further});
      }
    }
  }
  std::mt19937_64 random(5);
  for (int i = 0; i < 100; ++i) {
    integer digits = 0;
    for (auto k = random() % 90 + 1; k > 0; --k) digits = digits * 10 + random() % 10;
    const auto size = static_cast<int>(digits.str().size());
    decimals.push_back({random() % 2 == 0, digits, static_cast<int>(random() % 50) - 28 - size});
    decimals.push_back({random() % 2 == 0, digits, static_cast<int>(random() % 240) - 120});
  }
  return decimals;
}

[[maybe_unused]] const bool scientific = text_test("ReadsScientific", [](const Calls& calls) {
  for (const Decimal& decimal : decimals_of(calls.type)) {
    ASSERT_EQ(first_wrong(calls, decimal), "") << calls.type;
  }
});

[[maybe_unused]] const bool exponents =
    text_test("ReadsExponentsOfAnySize", [](const Calls& calls) {
      const Type& type = calls.type;
      const std::string nines(100'000, '9');
      for (const std::string& exponent : {std::string("999999999"), nines}) {
        for (const std::string sign : {"", "-"}) {
          Word value = 77;
          const std::string huge = sign + "0.001e" + exponent;
          auto read = calls.from_chars(huge, value);
          ASSERT_EQ(read.ec, std::errc::result_out_of_range);
          ASSERT_EQ(read.ptr, huge.data() + huge.size());
          ASSERT_EQ(value, 77U);
          const std::string tiny = sign + "1000e-" + exponent;
          const integer expected = reference::round(sign.empty() ? integer(1) : integer(-1),
                                                    power(10, 200), type.rules.multiply);
          read = calls.from_chars(tiny, value);
          ASSERT_EQ(read.ptr, tiny.data() + tiny.size());
          if (expected < type.lowest) {
            ASSERT_EQ(read.ec, std::errc::result_out_of_range);
          } else {
            ASSERT_EQ(read.ec, std::errc());
            ASSERT_EQ(type.value(value), expected);
          }
        }
      }
    });

}  // namespace text_test
