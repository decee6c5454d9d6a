/// Tests exact decimal conversion in both directions, its single rounding, and invalid text.
#include <boost/multiprecision/cpp_int.hpp>
#include <charconv>
#include <iomanip>

#include "fixed/fixed.hpp"
#include "tests/fixed/exact.hpp"
#include "tests/fixed/property.hpp"
#include "tests/fixed/types.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using boost::multiprecision::cpp_int;

/// The decimal expansion raw / 2^F = raw 5^F / 10^F without trailing zeros.
template <class Number>
std::string expansion(Number x) {
  exact::integer scaled = x.raw() < 0 ? -exact::integer{x.raw()} : exact::integer{x.raw()};
  for (int i = 0; i < Number::fraction_bits; ++i) scaled *= 5;
  std::string digits;
  for (int i = 0; i < Number::fraction_bits || scaled != 0 || i == Number::fraction_bits; ++i) {
    if (i == Number::fraction_bits) digits.insert(0, 1, '.');
    digits.insert(0, 1, static_cast<char>('0' + static_cast<int>(scaled % 10)));
    scaled /= 10;
  }
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  if (x.raw() < 0) digits.insert(0, 1, '-');
  return digits;
}

/// The number for `[-]digits[.digits]`, from integers of any size, or nothing if out of range.
template <class Number>
std::optional<Number> parsed(const std::string& text) {
  using raw = typename Number::raw_type;
  cpp_int numerator = 0;
  cpp_int denominator = 1;
  bool after_point = false;
  const bool negative = text.front() == '-';
  for (const char c : text) {
    if (c == '.') after_point = true;
    if (c < '0' || c > '9') continue;
    numerator = numerator * 10 + (c - '0');
    if (after_point) denominator *= 10;
  }
  numerator *= exact::one<Number>;
  const cpp_int low = numerator / denominator;
  const cpp_int rest = numerator % denominator;
  // The magnitude needs to know only whether to round away from zero.
  bool away = false;
  switch (Number::rules.multiply) {
    case rounding::floor:
      away = negative && rest != 0;
      break;
    case rounding::truncate:
      break;
    case rounding::half_up:
      away = negative ? 2 * rest > denominator : 2 * rest >= denominator;
      break;
    case rounding::half_away:
      away = 2 * rest >= denominator;
      break;
    case rounding::half_even:
      away = 2 * rest > denominator || (2 * rest == denominator && low % 2 != 0);
      break;
  }
  cpp_int result = low + (away ? 1 : 0);
  if (negative) result = -result;
  if (result < std::numeric_limits<raw>::min() || result > std::numeric_limits<raw>::max()) {
    return std::nullopt;
  }
  return Number::from_raw(result.convert_to<raw>());
}

template <class Number>
class NumberText : public testing::Test {};
TYPED_TEST_SUITE(NumberText, some_types);

TYPED_TEST(NumberText, IsExactAndComesBack) {
  const auto check = [](TypeParam x) {
    const std::string text = to_string(x);
    TypeParam back = x == TypeParam() ? TypeParam(1) : TypeParam();
    const auto [end, error] = from_chars(text.data(), text.data() + text.size(), back);
    std::ostringstream out;
    out << x;
    return text == expansion(x) && text.size() <= max_chars<TypeParam> && error == std::errc() &&
           end == text.data() + text.size() && back == x && out.str() == text;
  };
  for (const auto x : exact::edges<TypeParam>()) EXPECT_TRUE(check(x)) << x;
  EXPECT_TRUE(property::for_all<TypeParam>(check));
}

/// Whether `check` holds for decimal texts around the range of the format.
bool holds_for_texts(int fraction_bits, const std::function<bool(const std::string&)>& check) {
  return property::holds_for_parts([&](bool negative, std::uint16_t whole, std::uint64_t fraction) {
    const std::string digits = std::to_string(fraction);
    const std::string whole_digits = std::to_string(whole % (1 << (fraction_bits - 1)));
    const std::string sign = negative ? "-" : "";
    return check(sign + whole_digits + "." + digits) &&
           check(sign + whole_digits + ".0" + digits) &&
           check(sign + std::to_string(whole) + "." + digits);
  });
}

TYPED_TEST(NumberText, IsRoundedOnce) {
  const auto check = [](const std::string& text) {
    TypeParam value = TypeParam::from_raw(77);
    const auto [end, error] = from_chars(text.data(), text.data() + text.size(), value);
    const auto expected = parsed<TypeParam>(text);
    return end == text.data() + text.size() &&
           value == expected.value_or(TypeParam::from_raw(77)) &&
           error == (expected ? std::errc() : std::errc::result_out_of_range);
  };
  // Texts at half an ulp: the exact half, a half with a distant nonzero digit, and just below it.
  for (const auto x : exact::edges<TypeParam>()) {
    exact::integer scaled = x.raw() < 0 ? -exact::integer{x.raw()} : exact::integer{x.raw()};
    scaled = 2 * scaled + 1;
    for (int i = 0; i <= TypeParam::fraction_bits; ++i) scaled *= 5;
    std::string digits;
    for (int i = 0; i <= TypeParam::fraction_bits + 6; ++i) {
      digits.insert(0, 1, static_cast<char>('0' + static_cast<int>(scaled % 10)));
      scaled /= 10;
      if (i == TypeParam::fraction_bits) digits.insert(0, 1, '.');
    }
    for (const std::string sign : {"", "-"}) {
      EXPECT_TRUE(check(sign + digits)) << sign << digits;
      EXPECT_TRUE(check(sign + digits + std::string(300, '0'))) << sign << digits;
      EXPECT_TRUE(check(sign + digits + std::string(300, '0') + "1")) << sign << digits;
      std::string less = digits;
      less.back() = '4';
      EXPECT_TRUE(check(sign + less + std::string(300, '9'))) << sign << less;
    }
  }
  EXPECT_TRUE(holds_for_texts(TypeParam::fraction_bits, check));
}

TEST(TextEnds, RangeIsAfterRounding) {
  const auto expect = [](std::string text, std::errc error, std::int32_t raw) {
    q16_16 value = q16_16::from_raw(77);
    const auto result = from_chars(text.data(), text.data() + text.size(), value);
    EXPECT_EQ(result.ec, error) << text;
    EXPECT_EQ(result.ptr, text.data() + text.size()) << text;
    EXPECT_EQ(value.raw(), raw) << text;
  };
  expect("32767.99999237060546874999", std::errc(), 0x7fffffff);
  expect("32767.99999237060546875", std::errc::result_out_of_range, 77);
  expect("-32768.00000762939453125", std::errc(), -0x7fffffff - 1);
  expect("-32768.0000076293945312500001", std::errc::result_out_of_range, 77);
  expect("32768", std::errc::result_out_of_range, 77);
  expect("65536", std::errc::result_out_of_range, 77);
  expect("4294967296.5", std::errc::result_out_of_range, 77);
  expect("-0", std::errc(), 0);
  expect("+1.5", std::errc(), 0x18000);
  expect("000000000000000000000000000000001", std::errc(), 0x10000);
  expect(std::string(3'000'000, '9'), std::errc::result_out_of_range, 77);
  expect(std::string(3'000'000, '0') + "1." + std::string(3'000'000, '0') + "1", std::errc(),
         0x10000);
}

TEST(TextEnds, PrefixAndNothing) {
  const auto expect = [](std::string text, std::errc error, int taken, std::int32_t raw) {
    q16_16 value = q16_16::from_raw(77);
    const auto result = from_chars(text.data(), text.data() + text.size(), value);
    EXPECT_EQ(result.ec, error) << text;
    EXPECT_EQ(result.ptr - text.data(), taken) << text;
    EXPECT_EQ(value.raw(), raw) << text;
  };
  expect("1.5e3", std::errc(), 3, 0x18000);
  expect("1.", std::errc(), 1, 0x10000);
  expect("1..5", std::errc(), 1, 0x10000);
  expect("1.5.5", std::errc(), 3, 0x18000);
  expect("1 2", std::errc(), 1, 0x10000);
  for (const char* nothing : {"", "-", "+", ".", ".5", "-.5", "--1", "+-1", " 1", "e", "nan"}) {
    expect(nothing, std::errc::invalid_argument, 0, 77);
  }
}

TEST(TextEnds, ToCharsNeedsRoom) {
  std::array<char, 24> room{};
  const q16_16 x = q16_16::from_raw(-0x7fffffff);
  const std::string text = "-32767.9999847412109375";
  ASSERT_EQ(text.size(), max_chars<q16_16>);
  const auto fits = to_chars(room.data(), room.data() + text.size(), x);
  EXPECT_EQ(fits.ec, std::errc());
  EXPECT_EQ(std::string(room.data(), fits.ptr), text);
  room.fill('#');
  const auto small = to_chars(room.data(), room.data() + text.size() - 1, x);
  EXPECT_EQ(small.ec, std::errc::value_too_large);
  EXPECT_EQ(small.ptr, room.data() + text.size() - 1);
  EXPECT_EQ(room.front(), '#');
}

TEST(TextStreams, WriteInAField) {
  std::ostringstream out;
  out << std::setw(6) << std::setfill('*') << q8_8(-1.5) << '|' << std::left << std::setw(6)
      << q8_8(2) << '|' << q8_8(0.25);
  EXPECT_EQ(out.str(), "**-1.5|2*****|0.25");
}

TEST(TextStreams, ReadOneAfterAnother) {
  std::istringstream in(" 1.5\n-2 \t+3.25,4");
  q16_16 a, b, c, d;
  char comma = 0;
  in >> a >> b >> c >> comma >> d;
  EXPECT_FALSE(in.fail());
  EXPECT_TRUE(in.eof());
  EXPECT_EQ(a, q16_16(1.5));
  EXPECT_EQ(b, q16_16(-2));
  EXPECT_EQ(c, q16_16(3.25));
  EXPECT_EQ(comma, ',');
  EXPECT_EQ(d, q16_16(4));
}

TEST(TextStreams, FailAndLeaveTheValue) {
  for (const char* text : {"", "x", "-", "1.", "1.x", "40000", ".5"}) {
    std::istringstream in(text);
    q16_16 value(7);
    in >> value;
    EXPECT_TRUE(in.fail()) << text;
    EXPECT_FALSE(in.bad()) << text;
    EXPECT_EQ(value, q16_16(7)) << text;
  }
  std::istringstream failed("5");
  failed.setstate(std::ios::failbit);
  q16_16 value(7);
  failed >> value;
  EXPECT_EQ(value, q16_16(7));
  std::istringstream no_skip(" 5");
  no_skip >> std::noskipws >> value;
  EXPECT_TRUE(no_skip.fail());
}

}  // namespace
