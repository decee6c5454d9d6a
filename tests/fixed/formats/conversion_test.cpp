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

namespace conversion_test {

using reference::integer;
using reference::number_of;
using reference::Returned;
using reference::Type;
using reference::Word;
using reference::word_of;

/// The conversions of one type.
struct Calls {
  Type type;
  Word (*from_double)(double x);
  Word (*from_float)(float x);
  double (*to_double)(Word x);
  float (*to_float)(Word x);
  std::string (*to_text)(Word x);
  std::from_chars_result (*from_text)(const std::string& text, Word& x);
  std::size_t max_chars;

  template <class N>
  static Calls of() {
    return {Type::of<N>(),
            [](double x) { return word_of(N(x)); },
            [](float x) { return word_of(N(x)); },
            [](Word x) { return static_cast<double>(number_of<N>(x)); },
            [](Word x) { return static_cast<float>(number_of<N>(x)); },
            [](Word x) { return to_string(number_of<N>(x)); },
            [](const std::string& text, Word& x) {
              N number;
              const auto read =
                  fixproof::from_chars(text.data(), text.data() + text.size(), number);
              x = word_of(number);
              return read;
            },
            fixproof::max_chars<N>};
  }
};

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

Returned rounded(const Type& type, const Parts& value) {
  const int scale = value.e + type.fraction_bits;
  const integer n = scale > 0 ? value.m * reference::power(2, scale) : value.m;
  const integer d = scale < 0 ? reference::power(2, -scale) : integer(1);
  return in_range(type, reference::round(n, d, type.rules.multiply), type.rules.range);
}

/// Whether y is the double or float nearest to the number, ties to even.
template <class Float>
bool is_nearest(Float y, const Type& type, Word x) {
  const integer scale = reference::power(2, 200);
  const integer value = type.value(x) * scale / type.one;  // exact
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

template <class Test>
bool conversions(const char* test, void (*body)(const Test&), int line = __builtin_LINE()) {
  return each_type::add_each<formats::wide>("FormatConversions", test, body, __FILE__, line);
}

std::vector<double> doubles(const Calls& calls) {
  std::mt19937_64 random(7);
  std::vector<double> values{0, -0.0, 0.5, -0.5, 1, -1, 0x1p63, -0x1p63, 0x1p64, 0x1p-65, -0x1p-66};
  for (const Word x : reference::operands(calls.type, 40)) values.push_back(calls.to_double(x));
  for (int i = 0; i < 300; ++i) {
    const auto m = static_cast<double>(static_cast<std::int64_t>(random()) >> (random() % 64));
    values.push_back(std::ldexp(m, static_cast<int>(random() % 80) - 75));
  }
  return values;
}

[[maybe_unused]] const bool from_double = conversions<Calls>("FromDouble", [](const Calls& calls) {
  const Type& type = calls.type;
  for (const double value : doubles(calls)) {
    const auto got = reference::outcome([&] { return calls.from_double(value); });
    ASSERT_EQ(difference(type, got, rounded(type, parts_of(value))), "") << value << ", " << type;
    const auto single = static_cast<float>(value);
    const auto of_single = reference::outcome([&] { return calls.from_float(single); });
    const Returned expected = rounded(type, parts_of(static_cast<double>(single)));
    ASSERT_EQ(difference(type, of_single, expected), "") << single << ", " << type;
  }
});

[[maybe_unused]] const bool to_floats =
    conversions<Calls>("ToDoubleAndFloat", [](const Calls& calls) {
      for (const Word x : reference::operands(calls.type, 100)) {
        ASSERT_TRUE(is_nearest(calls.to_double(x), calls.type, x)) << listed(calls.type, {x});
        ASSERT_TRUE(is_nearest(calls.to_float(x), calls.type, x)) << listed(calls.type, {x});
      }
    });

[[maybe_unused]] const bool to_text = conversions<Calls>("ToText", [](const Calls& calls) {
  const Type& type = calls.type;
  for (const Word x : reference::operands(type, 60)) {
    const std::string text = calls.to_text(x);
    const Fraction value = fraction_of(text);
    ASSERT_EQ(value.n * type.one, type.value(x) * value.d) << text;
    ASSERT_TRUE(text.find('.') == std::string::npos || text.back() != '0') << text;
    ASSERT_LE(text.size(), calls.max_chars) << text;
    Word back = 0;
    ASSERT_EQ(calls.from_text(text, back).ec, std::errc());
    ASSERT_EQ(back, x) << text;
  }
});

/// Ties of the type with texts beside them, and random ones.
std::vector<std::string> texts(const Type& type) {
  std::mt19937_64 random(8);
  std::vector<std::string> texts;
  for (const Word x : reference::operands(type, 60)) {
    // A tie: the exact text of the number in a format with one more bit, then its neighbours.
    const integer twice = 2 * type.value(x) + 1;
    const integer magnitude = twice < 0 ? -twice : twice;
    const int places = type.fraction_bits + 1;
    const integer digits = magnitude * reference::power(5, places);
    std::string text = (twice < 0 ? "-" : "") + reference::with_point(digits.str(), places);
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
  return texts;
}

[[maybe_unused]] const bool from_text = conversions<Calls>("FromText", [](const Calls& calls) {
  const Type& type = calls.type;
  for (const std::string& text : texts(type)) {
    const Fraction value = fraction_of(text);
    const integer expected = reference::round(value.n * type.one, value.d, type.rules.multiply);
    const bool fits = type.fits(expected);
    Word x = 0;
    const auto read = calls.from_text(text, x);
    ASSERT_EQ(read.ec, fits ? std::errc() : std::errc::result_out_of_range) << text;
    if (fits) {
      ASSERT_EQ(type.value(x), expected) << text;
    }
  }
});

/// Arithmetic between two types.
enum class Op { add, subtract, multiply, divide };
constexpr std::array names{"add", "subtract", "multiply", "divide"};

template <class To, class A, class B>
Word call(Op op, Word x, Word y) {
  const auto a = number_of<A>(x);
  const auto b = number_of<B>(y);
  if (op == Op::add) return word_of(fixproof::add<To>(a, b));
  if (op == Op::subtract) return word_of(fixproof::subtract<To>(a, b));
  if (op == Op::multiply) return word_of(fixproof::multiply<To>(a, b));
  return word_of(fixproof::divide<To>(a, b));
}

/// Conversion of an A to a third type and arithmetic of an A and a B as a number of that type.
struct MixedCalls {
  Type to;
  Type a;
  Type b;
  Word (*converted)(Word x);
  Word (*call)(Op op, Word x, Word y);

  template <class To, class A, class B>
  static MixedCalls of() {
    return {Type::of<To>(), Type::of<A>(), Type::of<B>(),
            [](Word x) { return word_of(To(number_of<A>(x))); }, conversion_test::call<To, A, B>};
  }
};

/// Two operands in the same units.
struct Exact {
  integer a;
  integer b;
  integer one;
  integer product;  ///< Of the operands, in the same units.
};

Returned expected(Op op, const Type& to, const Exact& of) {
  const auto rounded = [&](const integer& n, fixproof::overflow rule) {
    return in_range(to, reference::round(n * to.one, of.one, to.rules.multiply), rule);
  };
  if (op == Op::add) return rounded(of.a + of.b, to.rules.range);
  if (op == Op::subtract) return rounded(of.a - of.b, to.rules.range);
  if (op == Op::multiply) return rounded(of.product, to.rules.product_range());
  return returned_quotient(to, of.a, of.b);
}

/// The first operation with a wrong result, or nothing.
std::string first_wrong(const MixedCalls& calls, Word x, Word y) {
  const integer m = calls.a.value(x);
  const integer n = calls.b.value(y);
  const Exact exact{m * calls.b.one, n * calls.a.one, calls.a.one * calls.b.one, m * n};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto op = static_cast<Op>(i);
    const auto got = reference::outcome([&] { return calls.call(op, x, y); });
    const std::string wrong = difference(calls.to, got, expected(op, calls.to, exact));
    if (!wrong.empty()) return names[i] + (" is " + wrong);
  }
  return {};
}

void expect_all_right(const MixedCalls& calls) {
  const auto ys = reference::distinct_operands(calls.b, 30);
  for (const Word x : reference::distinct_operands(calls.a, 30)) {
    const integer n = calls.a.value(x) * calls.to.one;
    const auto got = reference::outcome([&] { return calls.converted(x); });
    const Returned expected = in_range(
        calls.to, reference::round(n, calls.a.one, calls.to.rules.multiply), calls.to.rules.range);
    ASSERT_EQ(difference(calls.to, got, expected), "")
        << listed(calls.a, {x}) << " as " << calls.to;
    for (const Word y : ys) {
      ASSERT_EQ(first_wrong(calls, x, y), "")
          << listed(calls.a, {x}) << ", " << listed(calls.b, {y}) << " as " << calls.to;
    }
  }
}

/// One type among others.
struct BetweenCalls {
  std::array<MixedCalls, 4> mixed;

  template <class N>
  static BetweenCalls of() {
    using fixproof::number;
    return {{MixedCalls::of<N, number<std::int16_t, 8>, number<std::int32_t, 30>>(),
             MixedCalls::of<N, number<std::uint64_t, 64>, number<std::int64_t, 0>>(),
             MixedCalls::of<N, number<std::int32_t, 16>, number<std::uint32_t, 32>>(),
             MixedCalls::of<fixproof::q16_16, N, number<std::int64_t, 64>>()}};
  }
};

[[maybe_unused]] const bool between_formats =
    conversions<BetweenCalls>("BetweenFormats", [](const BetweenCalls& calls) {
      for (const MixedCalls& mixed : calls.mixed) expect_all_right(mixed);
    });

}  // namespace conversion_test
