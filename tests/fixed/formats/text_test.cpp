/// Tests the text of numbers of every format against integers of 1,024 bits: digits after the
/// point, scientific, hexadecimal and binary output, and input with and without an exponent.
#include <iomanip>

#include "fixed/fixed.hpp"
#include "tests/fixed/formats/reference.hpp"
#include "tests/fixed/formats/types.hpp"
#include "tests/support/test.hpp"
// The order matters: the test needs fmt after fixed, so do not sort the includes.
#include <fmt/format.h>

#include "fixed/format.hpp"

namespace {

using fixproof::rounding;
using reference::integer;
using reference::power;

template <class N>
integer magnitude(N x) {
  return x.raw() < 0 ? integer(-reference::raw(x)) : reference::raw(x);
}

template <class N>
std::string sign_of(N x) {
  return x.raw() < 0 ? "-" : "";
}

/// The digits with a point before the last `places` of them.
std::string with_point(std::string digits, int places) {
  if (places == 0) return digits;
  const auto count = static_cast<std::size_t>(places);
  if (digits.size() <= count) digits.insert(0, count + 1 - digits.size(), '0');
  return digits.insert(digits.size() - count, ".");
}

template <class N>
std::string fixed_text(N x, int precision) {
  const integer scaled = magnitude(x) * power(10, precision);
  const integer digits = reference::round(scaled, reference::one<N>(), rounding::half_even);
  return sign_of(x) + with_point(digits.str(), precision);
}

template <class N>
std::string scientific_text(N x, int precision) {
  int exponent = 0;
  integer n = magnitude(x);
  integer d = reference::one<N>();
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
  return sign_of(x) + with_point(digits.str(), precision) + (exponent < 0 ? "e-" : "e+") +
         (size.size() < 2 ? "0" : "") + size;
}

/// The text in a base of 2^bits_per_digit.
template <class N>
std::string binary_text(N x, int bits_per_digit) {
  const int places = (N::fraction_bits + bits_per_digit - 1) / bits_per_digit;
  integer units = magnitude(x) * power(2, places * bits_per_digit - N::fraction_bits);
  std::string digits;
  for (; units != 0; units /= power(2, bits_per_digit)) {
    const auto digit = static_cast<int>(units % power(2, bits_per_digit));
    digits.insert(0, 1, "0123456789abcdef"[digit]);
  }
  if (digits.empty()) digits = "0";
  digits = with_point(digits, places);
  if (places > 0) digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return sign_of(x) + digits;
}

template <class N>
std::string streamed(N x, std::ios_base& (*form)(std::ios_base&), int precision) {
  std::ostringstream out;
  out << form << std::setprecision(precision) << x;
  return out.str();
}

template <class... More, class... T>
testing::Types<T..., More...> with(testing::Types<T...> formats);

/// The reader of text changes its method at 18 and at 60 fraction bits.
using TextFormats =
    decltype(with<fixproof::number<std::int32_t, 17>, fixproof::number<std::int32_t, 18>,
                  fixproof::number<std::int64_t, 59, formats::even_saturate>,
                  fixproof::number<std::uint64_t, 60>>(formats::wide()));

template <class N>
class FormatText : public testing::Test {};
TYPED_TEST_SUITE(FormatText, TextFormats);

TYPED_TEST(FormatText, RoundsToAnyPrecision) {
  for (const TypeParam x : reference::operands<TypeParam>(10)) {
    for (int precision = 0; precision <= 70; precision += precision < 24 ? 1 : 5) {
      const std::string decimal = fixed_text(x, precision);
      ASSERT_EQ(fmt::format(fmt::runtime(fmt::format("{{:.{}f}}", precision)), x), decimal);
      ASSERT_EQ(streamed(x, std::fixed, precision), decimal);
      const std::string scientific = scientific_text(x, precision);
      ASSERT_EQ(fmt::format(fmt::runtime(fmt::format("{{:.{}e}}", precision)), x), scientific) << x;
      ASSERT_EQ(streamed(x, std::scientific, precision), scientific) << x;
    }
  }
}

/// Where long double holds every number exactly, printf must agree.
TYPED_TEST(FormatText, AgreesWithPrintf) {
  if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "long double is too short";
  std::array<char, 200> text{};
  for (const TypeParam x : reference::operands<TypeParam>(100)) {
    const long double value =
        std::ldexp(static_cast<long double>(x.raw()), -TypeParam::fraction_bits);
    for (const int precision : {0, 1, 2, 6, 17, 70}) {
      std::snprintf(text.data(), text.size(), "%.*Lf", precision, value);
      ASSERT_EQ(streamed(x, std::fixed, precision), text.data());
      std::snprintf(text.data(), text.size(), "%.*Le", precision, value);
      ASSERT_EQ(streamed(x, std::scientific, precision), text.data());
    }
  }
}

TYPED_TEST(FormatText, HexadecimalAndBinary) {
  for (const TypeParam x : reference::operands<TypeParam>(60)) {
    ASSERT_EQ(fmt::format("{:x}", x), binary_text(x, 4)) << x;
    ASSERT_EQ(fmt::format("{:b}", x), binary_text(x, 1)) << x;
  }
}

/// digits * 10^exponent, as a text of either form.
struct Decimal {
  bool negative = false;
  integer digits = 0;
  int exponent = 0;
};

template <class N>
std::string first_wrong(const Decimal& decimal) {
  const integer n = (decimal.negative ? -decimal.digits : decimal.digits) * reference::one<N>() *
                    power(10, (std::max)(decimal.exponent, 0));
  const integer expected =
      reference::round(n, power(10, (std::max)(-decimal.exponent, 0)), N::rules.multiply);
  using limits = std::numeric_limits<typename N::raw_type>;
  const bool fits = expected >= limits::min() && expected <= limits::max();
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
    const N before = N::from_raw(77);
    N read = before;
    const auto result = fixproof::from_chars(all.data(), all.data() + all.size(), read);
    const auto error = fits ? std::errc() : std::errc::result_out_of_range;
    const bool right = fits ? reference::raw(read) == expected : read == before;
    if (result.ec != error || result.ptr != all.data() + all.size() || !right) return all;
    std::istringstream in(all);
    N streamed = before;
    in >> streamed;
    if (in.fail() == fits || streamed != read) return "stream: " + all;
  }
  return {};
}

TYPED_TEST(FormatText, ReadsScientific) {
  using N = TypeParam;
  constexpr int places = N::fraction_bits + 1;
  std::vector<Decimal> decimals;
  for (const N x : reference::operands<N>(10)) {
    // A tie, the numbers beside it at any distance, and the number itself.
    const integer tie = (2 * magnitude(x) + 1) * power(5, places);
    for (const bool negative : {false, true}) {
      decimals.push_back({negative, magnitude(x) * power(5, N::fraction_bits), -N::fraction_bits});
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
  for (const Decimal& decimal : decimals) ASSERT_EQ(first_wrong<N>(decimal), "");
}

TYPED_TEST(FormatText, ReadsExponentsOfAnySize) {
  using N = TypeParam;
  using limits = std::numeric_limits<typename N::raw_type>;
  const std::string nines(100'000, '9');
  for (const std::string& exponent : {std::string("999999999"), nines}) {
    for (const std::string sign : {"", "-"}) {
      N value = N::from_raw(77);
      const std::string huge = sign + "0.001e" + exponent;
      auto read = fixproof::from_chars(huge.data(), huge.data() + huge.size(), value);
      ASSERT_EQ(read.ec, std::errc::result_out_of_range);
      ASSERT_EQ(read.ptr, huge.data() + huge.size());
      ASSERT_EQ(value, N::from_raw(77));
      const std::string tiny = sign + "1000e-" + exponent;
      const integer expected = reference::round(sign.empty() ? integer(1) : integer(-1),
                                                power(10, 200), N::rules.multiply);
      read = fixproof::from_chars(tiny.data(), tiny.data() + tiny.size(), value);
      ASSERT_EQ(read.ptr, tiny.data() + tiny.size());
      if (expected < limits::min()) {
        ASSERT_EQ(read.ec, std::errc::result_out_of_range);
      } else {
        ASSERT_EQ(read.ec, std::errc());
        ASSERT_EQ(reference::raw(value), expected);
      }
    }
  }
}

}  // namespace
