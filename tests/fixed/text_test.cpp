/// Tests exact decimal conversion in both directions, its single rounding, and invalid text.
#include <boost/multiprecision/cpp_int.hpp>
#include <charconv>
#include <iomanip>
#include <locale>

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
    case rounding::ceiling:
      away = !negative && rest != 0;
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
    case rounding::nearest:
      break;  // no rule of conversions
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

TEST(TextEnds, NoTextIsNoNumber) {
  const char* const nothing = nullptr;
  q16_16 value = q16_16::from_raw(77);
  const auto result = from_chars(nothing, nothing, value);
  EXPECT_EQ(result.ec, std::errc::invalid_argument);
  EXPECT_EQ(result.ptr, nothing);
  EXPECT_EQ(value.raw(), 77);
}

TEST(TextEnds, PrefixAndNothing) {
  const auto expect = [](std::string text, std::errc error, int taken, std::int32_t raw) {
    q16_16 value = q16_16::from_raw(77);
    const auto result = from_chars(text.data(), text.data() + text.size(), value);
    EXPECT_EQ(result.ec, error) << text;
    EXPECT_EQ(result.ptr - text.data(), taken) << text;
    EXPECT_EQ(value.raw(), raw) << text;
  };
  expect("1.5e3", std::errc(), 5, 1500 << 16);
  expect("25E-2x", std::errc(), 5, 0x4000);
  expect("-0.5e+1+", std::errc(), 7, -5 * 0x10000);
  expect("1.5e", std::errc(), 3, 0x18000);
  expect("1.5e+", std::errc(), 3, 0x18000);
  expect("1e-", std::errc(), 1, 0x10000);
  expect("1e+-2", std::errc(), 1, 0x10000);
  expect("1ee2", std::errc(), 1, 0x10000);
  expect("1e.5", std::errc(), 1, 0x10000);
  expect("1.e2", std::errc(), 4, 100 << 16);
  expect(".5e1", std::errc(), 4, 5 << 16);
  expect("-.5", std::errc(), 3, -0x8000);
  expect("1.e", std::errc(), 2, 0x10000);
  expect("1e1.5", std::errc(), 3, 10 << 16);
  expect("1e2e3", std::errc(), 3, 100 << 16);
  expect("1.", std::errc(), 2, 0x10000);
  expect("1..5", std::errc(), 2, 0x10000);
  expect("1.5.5", std::errc(), 3, 0x18000);
  expect("1 2", std::errc(), 1, 0x10000);
  for (const char* nothing : {"", "-", "+", ".", "..5", "-.", ".e5", "--1", "+-1", " 1", "e", "e5",
                              "-e5", "nan", "inf"}) {
    expect(nothing, std::errc::invalid_argument, 0, 77);
  }
}

#if defined(__cpp_lib_to_chars)
TEST(TextEnds, TheSamePrefixAsOfADouble) {
  // All texts of up to seven of these characters; <charconv> takes no leading +.
  constexpr std::string_view alphabet = "-.e+12";
  std::size_t texts = 0;
  for (std::size_t length = 1; length <= 7; ++length) {
    std::size_t all = 1;
    for (std::size_t i = 0; i < length; ++i) all *= alphabet.size();
    for (std::size_t i = 0; i < all; ++i, ++texts) {
      std::string text(length, ' ');
      for (std::size_t rest = i, at = 0; at < length; rest /= alphabet.size()) {
        text[at++] = alphabet[rest % alphabet.size()];
      }
      if (text[0] == '+') continue;
      number<std::int64_t, 8> read;
      double expected = 0;
      const char* const end = text.data() + length;
      const auto [at, error] = from_chars(text.data(), end, read);
      ASSERT_EQ(at, std::from_chars(text.data(), end, expected).ptr) << text;
      if (error == std::errc()) {
        ASSERT_LE(std::abs(expected - static_cast<double>(read)), 1.0 / 512) << text;
      }
    }
  }
  EXPECT_EQ(texts, 335'922U);
}
#endif

TEST(TextEnds, AnyExponent) {
  const auto expect = [](std::string text, std::errc error, std::int32_t raw) {
    q16_16 value = q16_16::from_raw(77);
    const auto result = from_chars(text.data(), text.data() + text.size(), value);
    EXPECT_EQ(result.ec, error) << text.substr(0, 50);
    EXPECT_EQ(result.ptr, text.data() + text.size()) << text.substr(0, 50);
    EXPECT_EQ(value.raw(), raw) << text.substr(0, 50);
  };
  const auto out = std::errc::result_out_of_range;
  const std::string zeros(1'000'000, '0');
  expect("1e4", std::errc(), 10000 << 16);
  expect("1e5", out, 77);
  expect("1e999999999", out, 77);
  expect("-1e" + std::string(1'000'000, '9'), out, 77);
  expect("0e" + std::string(1'000'000, '9'), std::errc(), 0);
  expect("1e-999999999", std::errc(), 0);
  expect("-1e-" + std::string(1'000'000, '9'), std::errc(), 0);
  expect("1e" + zeros + "2", std::errc(), 100 << 16);
  expect("1" + zeros + "e-1000000", std::errc(), 0x10000);
  expect("1" + zeros + "1e-1000001", std::errc(), 0x10000);
  expect("0." + zeros + "125e1000001", std::errc(), 0x14000);
  expect("0." + zeros + "125e1000000", std::errc(), 0x2000);
  expect("0." + zeros + "1e1000006", out, 77);
  // 1 + a tie, and one digit after a million zeros that decides it against -infinity.
  expect("-100000762939453125e-17", std::errc(), -0x10000);
  expect("-100000762939453125" + zeros + "1e-1000018", std::errc(), -0x10001);
  expect("3276799999237060546874999e-20", std::errc(), 0x7fffffff);
  expect("3276799999237060546875e-17", out, 77);
}

TEST(TextEnds, TinyNumbersFollowTheRule) {
  using down = number<std::int32_t, 16, policy{.multiply = rounding::floor}>;
  const std::string text = "-1e-999999999999999999999";
  down value(7);
  from_chars(text.data(), text.data() + text.size(), value);
  EXPECT_EQ(value.raw(), -1);
  q16_16 nearest(7);
  from_chars(text.data(), text.data() + text.size(), nearest);
  EXPECT_EQ(nearest.raw(), 0);
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

TEST(TextStreams, FlagsAndPrecision) {
  const auto written = [](auto... parts) {
    std::ostringstream out;
    (out << ... << parts);
    return out.str();
  };
  const q16_16 x(-1.5);
  EXPECT_EQ(written(std::setprecision(3), x, '|', std::fixed, x, '|', std::scientific, x),
            "-1.5|-1.500|-1.500e+00");
  EXPECT_EQ(written(std::fixed, q16_16(2.625), '|', std::setprecision(2), q16_16(2.625), '|',
                    std::setprecision(0), q16_16(2.5), '|', std::showpoint, q16_16(3.5)),
            "2.625000|2.62|2|4.");
  EXPECT_EQ(written(std::scientific, std::uppercase, std::setprecision(-1), q16_16(1234.5)),
            "1.234500E+03");
  EXPECT_EQ(written(std::showpos, q16_16(2.5), x, q16_16(), std::noshowpos, q16_16(2.5)),
            "+2.5-1.5+02.5");
  EXPECT_EQ(written(std::setfill('0'), std::internal, std::setw(8), x, '|', std::setw(8),
                    std::showpos, q16_16(2), '|', std::setw(3), x, '|', std::setw(5), -x),
            "-00001.5|+0000002|-1.5|+01.5");
  EXPECT_EQ(written(std::setw(8), std::fixed, std::setprecision(1), x, '|', std::left, std::setw(6),
                    x, '|'),
            "    -1.5|-1.5  |");
  EXPECT_EQ(written(std::hexfloat, x, '|', std::uppercase, q16_16(171.5), '|', std::showpoint, x),
            "-0x1.8p+0|0X1.57P+7|-0X1.8P+0");
  EXPECT_EQ(written(std::hexfloat, std::internal, std::setfill('*'), std::setw(11), x, '|',
                    std::setw(11), -x),
            "-**0x1.8p+0|0x***1.8p+0");
}

TEST(TextStreams, HexfloatAsForADouble) {
  const auto same = [](auto x) {
    for (const auto flags : {std::ios_base::fmtflags(), std::ios_base::showpos,
                             std::ios_base::uppercase | std::ios_base::showpoint}) {
      std::ostringstream number;
      std::ostringstream expected;
      number << std::hexfloat << std::setiosflags(flags) << x;
      expected << std::hexfloat << std::setiosflags(flags) << static_cast<double>(x);
      EXPECT_EQ(number.str(), expected.str());
    }
  };
  for (int word = -0x8000; word < 0x8000; ++word)
    same(q8_8::from_raw(static_cast<std::int16_t>(word)));
  using wide = number<std::int64_t, 62>;
  using whole = number<std::uint64_t, 0>;
  same(wide::from_raw(std::numeric_limits<std::int64_t>::min()));
  same(wide::from_raw(1));
  same(whole::from_raw(std::uint64_t{1} << 63U));
  same(number<std::uint64_t, 64>::from_raw(1));
  std::ostringstream all;
  all << std::hexfloat << whole::from_raw(~std::uint64_t{0});
  EXPECT_EQ(all.str(), "0x1.fffffffffffffffep+63");
}

/// Writes 1234567.5 as 12.34.567,5 if the groups are 3 and then 2.
class Punctuation : public std::numpunct<char> {
 public:
  explicit Punctuation(std::string groups) : groups_(std::move(groups)) {}

 private:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return groups_; }

  std::string groups_;
};

TEST(TextStreams, HonourTheLocale) {
  using wide = number<std::int64_t, 8>;
  const auto written = [](const std::string& groups, wide x) {
    std::ostringstream out;
    out.imbue(std::locale(std::locale::classic(), new Punctuation(groups)));
    out << std::setw(12) << x << '|' << std::scientific << x;
    return out.str();
  };
  const wide x(-1234567.5);
  EXPECT_EQ(written("", x), "  -1234567,5|-1,234568e+06");
  EXPECT_EQ(written("\3", x), "-1.234.567,5|-1,234568e+06");
  EXPECT_EQ(written("\3\2", x), "-12.34.567,5|-1,234568e+06");
  EXPECT_EQ(written(std::string("\3\0", 2), x), " -1234.567,5|-1,234568e+06");
  EXPECT_EQ(written(std::string("\2\177", 2), x), " -12345.67,5|-1,234568e+06");
  EXPECT_EQ(written("\3", wide(123)), "         123|1,230000e+02");
  EXPECT_EQ(written("\3", wide(123456)), "     123.456|1,234560e+05");

  std::istringstream in("1,5 -2,25e1 3.5");
  in.imbue(std::locale(std::locale::classic(), new Punctuation("")));
  q16_16 a, b, c;
  in >> a >> b >> c;
  EXPECT_EQ(a, q16_16(1.5));
  EXPECT_EQ(b, q16_16(-22.5));
  EXPECT_EQ(c, q16_16(3));
  EXPECT_EQ(in.get(), '.');
}

TEST(TextStreams, ReadOneAfterAnother) {
  std::istringstream in(" 1.5\n-2 \t+325e-2,4");
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
  for (const char* text :
       {"", "x", "-", ".", "-.", "..5", "1e", "1ex", "1.5e+", "1e+x", "40000", "4e4"}) {
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
