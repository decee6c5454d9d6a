/// Tests conversions of every format: to and from double, float, decimal text and other formats,
/// and arithmetic between formats.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include "fixed/fixed.hpp"
#include "tests/fixed/formats/reference.hpp"
#include "tests/fixed/formats/types.hpp"
#include "tests/support/test.hpp"

namespace {

using reference::integer;

/// m * 2^e for a finite x.
struct Parts {
  integer m;
  int e;
};

Parts parts_of(double x) {
  int e = 0;
  const double m = std::frexp(x, &e);
  return {integer(static_cast<std::int64_t>(std::ldexp(m, 53))), e - 53};
}

template <class N>
std::optional<integer> rounded(const integer& m, int e) {
  const int scale = e + N::fraction_bits;
  const integer n = scale > 0 ? integer(m * reference::power(2, scale)) : m;
  const integer d = scale < 0 ? reference::power(2, -scale) : integer(1);
  return reference::in_range<N>(reference::round(n, d, N::rules.multiply), N::rules.range);
}

/// Whether y is the double or float nearest to x, ties to even.
template <class Float, class N>
bool is_nearest(Float y, N x) {
  const integer scale = reference::power(2, 200);
  const integer value = reference::raw(x) * scale / reference::one<N>();  // exact
  const auto distance = [&](Float to) {
    const Parts p = parts_of(static_cast<double>(to));
    const integer other = p.m * reference::power(2, 200 + p.e);
    return other < value ? value - other : other - value;
  };
  if (y == 0) return value == 0;
  const integer here = distance(y);
  for (const Float toward :
       {-std::numeric_limits<Float>::max(), std::numeric_limits<Float>::max()}) {
    const integer there = distance(std::nextafter(y, toward));
    const bool even = sizeof(Float) == 4
                          ? std::bit_cast<std::uint32_t>(static_cast<float>(y)) % 2 == 0
                          : std::bit_cast<std::uint64_t>(static_cast<double>(y)) % 2 == 0;
    if (there < here || (there == here && !even)) return false;
  }
  return true;
}

/// A decimal text as a fraction.
struct Fraction {
  integer n = 0;
  integer d = 1;
};

Fraction fraction_of(const std::string& text) {
  Fraction result;
  bool after_point = false;
  for (const char c : text) {
    if (c == '.') after_point = true;
    if (c < '0' || c > '9') continue;
    result.n = result.n * 10 + (c - '0');
    if (after_point) result.d *= 10;
  }
  if (text.front() == '-') result.n = -result.n;
  return result;
}

template <class N>
class FormatConversions : public testing::Test {};
TYPED_TEST_SUITE(FormatConversions, formats::wide);

TYPED_TEST(FormatConversions, FromDouble) {
  using N = TypeParam;
  std::mt19937_64 random(7);
  std::vector<double> values{0, -0.0, 0.5, -0.5, 1, -1, 0x1p63, -0x1p63, 0x1p64, 0x1p-65, -0x1p-66};
  for (const N x : reference::operands<N>(40)) values.push_back(static_cast<double>(x));
  for (int i = 0; i < 300; ++i) {
    const auto m = static_cast<double>(static_cast<std::int64_t>(random()) >> (random() % 64));
    values.push_back(std::ldexp(m, static_cast<int>(random() % 80) - 75));
  }
  for (const double value : values) {
    const Parts p = parts_of(value);
    ASSERT_EQ(reference::outcome([&] { return N(value); }), rounded<N>(p.m, p.e)) << value;
    const auto single = static_cast<float>(value);
    const Parts q = parts_of(static_cast<double>(single));
    ASSERT_EQ(reference::outcome([&] { return N(single); }), rounded<N>(q.m, q.e)) << single;
  }
}

TYPED_TEST(FormatConversions, ToDoubleAndFloat) {
  for (const TypeParam x : reference::operands<TypeParam>(100)) {
    ASSERT_TRUE(is_nearest(static_cast<double>(x), x)) << x;
    ASSERT_TRUE(is_nearest(static_cast<float>(x), x)) << x;
  }
}

TYPED_TEST(FormatConversions, ToText) {
  for (const TypeParam x : reference::operands<TypeParam>(60)) {
    const std::string text = to_string(x);
    const Fraction value = fraction_of(text);
    ASSERT_EQ(value.n * reference::one<TypeParam>(), reference::raw(x) * value.d) << text;
    ASSERT_TRUE(text.find('.') == std::string::npos || text.back() != '0') << text;
    ASSERT_LE(text.size(), fixproof::max_chars<TypeParam>) << text;
    TypeParam back;
    ASSERT_EQ(fixproof::from_chars(text.data(), text.data() + text.size(), back).ec, std::errc());
    ASSERT_EQ(back, x) << text;
  }
}

TYPED_TEST(FormatConversions, FromText) {
  using N = TypeParam;
  std::mt19937_64 random(8);
  std::vector<std::string> texts;
  for (const N x : reference::operands<N>(60)) {
    // A tie: the exact text of the number in a format with one more bit, then its neighbours.
    const integer twice = 2 * reference::raw(x) + 1;
    const integer magnitude = twice < 0 ? -twice : twice;
    const integer digits = magnitude * reference::power(5, N::fraction_bits + 1);
    std::string text = digits.str();
    const auto places = static_cast<std::size_t>(N::fraction_bits + 1);
    if (text.size() <= places) text.insert(0, places + 1 - text.size(), '0');
    text.insert(text.size() - places, ".");
    if (twice < 0) text.insert(0, "-");
    texts.push_back(text);
    texts.push_back(text + "0000000000000000000000001");
    text.back() = static_cast<char>(text.back() - 1);  // the last digit of a tie is 5
    texts.push_back(text + "99999999999999999999999");
  }
  for (int i = 0; i < 200; ++i) {
    std::string text = random() % 2 == 0 ? "-" : "";
    for (auto k = random() % 22 + 1; k > 0; --k) text += static_cast<char>('0' + random() % 10);
    text += '.';
    for (auto k = random() % 80 + 1; k > 0; --k) text += static_cast<char>('0' + random() % 10);
    texts.push_back(text);
  }
  using limits = std::numeric_limits<typename N::raw_type>;
  for (const std::string& text : texts) {
    const Fraction value = fraction_of(text);
    const integer expected =
        reference::round(value.n * reference::one<N>(), value.d, N::rules.multiply);
    const bool fits = expected >= limits::min() && expected <= limits::max();
    N x;
    const auto read = fixproof::from_chars(text.data(), text.data() + text.size(), x);
    ASSERT_EQ(read.ec, fits ? std::errc() : std::errc::result_out_of_range) << text;
    if (fits) {
      ASSERT_EQ(reference::raw(x), expected) << text;
    }
  }
}

/// Conversion of x to To and arithmetic of x and y as a To.
template <class To, class A, class B>
std::string first_wrong(A x, B y) {
  using namespace reference;  // NOLINT(google-build-using-namespace)
  constexpr fixproof::policy rules = To::rules;
  const integer a = raw(x) * one<B>();  // both in units of 2^-(FA + FB)
  const integer b = raw(y) * one<A>();
  const integer unit = one<A>() * one<B>();
  const auto rounded = [&](const integer& n, const integer& d) {
    return round(n * one<To>(), d, rules.multiply);
  };
  if (outcome([&] { return To(x); }) != in_range<To>(rounded(raw(x), one<A>()), rules.range))
    return "conversion";
  if (outcome([&] { return fixproof::add<To>(x, y); }) !=
      in_range<To>(rounded(a + b, unit), rules.range))
    return "add";
  if (outcome([&] { return fixproof::subtract<To>(x, y); }) !=
      in_range<To>(rounded(a - b, unit), rules.range))
    return "subtract";
  if (outcome([&] { return fixproof::multiply<To>(x, y); }) !=
      in_range<To>(rounded(raw(x) * raw(y), unit), rules.product_range()))
    return "multiply";
  if (outcome([&] { return fixproof::divide<To>(x, y); }) != quotient<To>(a, b)) return "divide";
  return {};
}

template <class To, class A, class B>
void expect_all_right() {
  for (const A x : reference::operands<A>(30)) {
    for (const B y : reference::operands<B>(30)) {
      ASSERT_EQ((first_wrong<To>(x, y)), "") << x << ", " << y;
    }
  }
}

TYPED_TEST(FormatConversions, BetweenFormats) {
  using fixproof::number;
  expect_all_right<TypeParam, number<std::int16_t, 8>, number<std::int32_t, 30>>();
  expect_all_right<TypeParam, number<std::uint64_t, 64>, number<std::int64_t, 0>>();
  expect_all_right<TypeParam, number<std::int32_t, 16>, number<std::uint32_t, 32>>();
  expect_all_right<fixproof::q16_16, TypeParam, number<std::int64_t, 64>>();
}

}  // namespace
