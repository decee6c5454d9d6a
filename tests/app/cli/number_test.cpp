// Tests how numbers that a person types are read. The values are worked out by hand.
#include "app/input/number.hpp"

#include <ostream>

#include "oracle/integer.hpp"
#include "tests/support/test.hpp"

namespace {

using fixproof::cases::Format;
using fixproof::cases::q16_16;
using fixproof::input::Bare;
using fixproof::input::number_of;

constexpr Format q4_4{.word_bits = 8, .fraction_bits = 4};

/// Expects the number n / 65536.
void expect_units(std::string_view text, std::int64_t n, Bare bare = Bare::word,
                  const Format& format = q16_16) {
  const auto number = number_of(text, format, bare);
  EXPECT_EQ(number.error, "") << text;
  EXPECT_TRUE(number.exact.numerator * 65536 == number.exact.denominator * n)
      << text << " is " << number.exact.numerator << " / " << number.exact.denominator;
}

void expect_error(std::string_view text, std::string_view part, Bare bare = Bare::word) {
  const auto number = number_of(text, q16_16, bare);
  EXPECT_NE(number.error.find(part), std::string::npos) << text << ": " << number.error;
}

TEST(TypedNumber, IsDecimalInAnyUsualForm) {
  for (const Bare bare : {Bare::word, Bare::decimal}) {
    expect_units("1.5", 98304, bare);
    expect_units("  -1.5\t", -98304, bare);
    expect_units("\u22121.5", -98304, bare);
    expect_units("+.5", 32768, bare);
    expect_units("2", 131072, bare);
    expect_units("1e3", 65536000, bare);
    expect_units("15E-1", 98304, bare);
    expect_units("-0.25e+1", -163840, bare);
    expect_units("1_000", 65536000, bare);
    expect_units("1_0.2_5", 671744, bare);
    expect_units("0", 0, bare);
    expect_units("0.5", 32768, bare);
    expect_units("0e5", 0, bare);
  }
  EXPECT_EQ(number_of("\u22121_000e-1", q16_16, Bare::word).decimal, "-1000e-1");
}

TEST(TypedNumber, IsAWordAfterItsPrefix) {
  for (const Bare bare : {Bare::word, Bare::decimal}) {
    expect_units("0x18000", 98304, bare);
    expect_units("0X0001_8000", 98304, bare);
    expect_units("0b11", 3, bare);
    expect_units("0xFFFFffff", -1, bare);
    // After a sign, the digits are a magnitude.
    expect_units("-0x8000", -32768, bare);
    expect_units("\u22120x80000000", -2147483648, bare);
    expect_units("+0x80000000", 2147483648, bare);
    EXPECT_TRUE(number_of("0x1", q16_16, bare).is_word);
    EXPECT_FALSE(number_of("1", q16_16, bare).is_word);
  }
}

TEST(TypedNumber, IsAWordWithoutPrefixOnlyWithAllItsDigitsInTheCommand) {
  expect_units("00018000", 98304);
  expect_units("FFFF8000", -32768);
  expect_units("12345678", 0x12345678);
  expect_units("1e500000", 0x1e500000);
  expect_units("0b000001", 0x0b000001);
  expect_units("12345678", 12345678 * std::int64_t{65536}, Bare::decimal);
  expect_units("00018000", 18000 * std::int64_t{65536}, Bare::decimal);
  // One and ten sixteenths, and ten.
  expect_units("1a", 106496, Bare::word, q4_4);
  expect_units("10", 65536, Bare::word, q4_4);
  expect_units("10.0", 655360, Bare::word, q4_4);
  expect_units("+10", 655360, Bare::word, q4_4);
}

TEST(TypedNumber, SaysWhatIsWrong) {
  for (const Bare bare : {Bare::word, Bare::decimal}) {
    expect_error("", "no number", bare);
    for (const char* text : {"x", ".", "-", "--1", "-+1", "1.5.5", "1__0", "_1", "1_", "1e", "1e+",
                             "1e-+1", "1 5", "1,5", "nan", "1.5f", "e", "-e5"}) {
      expect_error(text, "not a number", bare);
    }
    expect_error("0x", "not a word of 32 bits", bare);
    expect_error("0x123456789", "up to 8 hexadecimal digits", bare);
    expect_error("0x-1", "not a word", bare);
    expect_error("0b12", "not a word", bare);
    expect_error("1e101", "exponent is not from -100 to 100", bare);
    expect_error("1e-99999999999", "exponent is not from -100 to 100", bare);
    expect_error(std::string(101, '1'), "longer than 100 characters", bare);
  }
  expect_error("1800a", "a word has 8 hexadecimal digits, or fewer after 0x");
  // Such a number may be a word that lost a digit.
  expect_error("0018000", "a decimal number has no 0 in front");
  expect_error("0001_8000", "a decimal number has no 0 in front");
  expect_error("1800a", "not a number", Bare::decimal);
}

TEST(TypedNumber, SplitsALineAtAnySpacing) {
  EXPECT_EQ(fixproof::input::parts_of(" 1  2,3;\t4 "),
            (std::vector<std::string_view>{"1", "2", "3", "4"}));
  EXPECT_TRUE(fixproof::input::parts_of(" , ").empty());
}

}  // namespace
