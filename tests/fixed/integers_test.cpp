/// Tests every operator between a number and an integer against exact fractions: edges of the type
/// with edges of the integer, and shifts by the integer, for integers of 8 to 64 bits.
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "fixed/fixed.hpp"
#include "tests/fixed/exact.hpp"
#include "tests/fixed/types.hpp"
#include "tests/support/each_type.hpp"
#include "tests/support/test.hpp"

namespace {

using exact::integer;
using exact::Outcome;

/// The operators between a number a and an integer b.
enum class Operator { plus, plus_a, minus, minus_a, times, times_a, divide, left, right, compare };

/// The results of all comparisons, one bit each.
template <class A, class B>
int compared(const A& a, const B& b) {
  return (a == b) | (b == a) << 1 | (a != b) << 2 | (a < b) << 3 | (a <= b) << 4 | (a > b) << 5 |
         (b < a) << 6 | (b >= a) << 7;
}
constexpr std::array comparisons{"a == b", "b == a", "a != b", "a < b",
                                 "a <= b", "a > b",  "b < a",  "b >= a"};

/// The result on stored integers. One function for all operators compiles faster than one for each.
template <class Number, class Int>
std::int64_t computed(Operator operation, std::int64_t first, std::int64_t second) {
  const auto a = Number::from_raw(static_cast<typename Number::raw_type>(first));
  const auto b = static_cast<Int>(second);
  switch (operation) {
    case Operator::plus:
      return (a + b).raw();
    case Operator::plus_a:
      return (b + a).raw();
    case Operator::minus:
      return (a - b).raw();
    case Operator::minus_a:
      return (b - a).raw();
    case Operator::times:
      return (a * b).raw();
    case Operator::times_a:
      return (b * a).raw();
    case Operator::divide:
      return (a / b).raw();
    case Operator::left:
      return (a << b).raw();
    case Operator::right:
      return (a >> b).raw();
    case Operator::compare:
      return compared(a, b);
  }
  return 0;
}

/// An integer type, and what its operators with a number type compute.
struct IntegerType {
  int digits;
  bool is_signed;
  std::int64_t (*compute)(Operator operation, std::int64_t a, std::int64_t b);
};

/// What counting computes: from 2.5 by assignments and by one, and up from the highest number.
struct Counts {
  std::array<std::int64_t, 5> values;
  Outcome beyond_highest;
  std::int64_t then;
};

template <class Number>
Counts counted() {
  Counts counts;
  Number x(2.5);
  x *= 4;
  x += 1;
  x -= 3;
  x /= 2;
  const Number assigned = x;
  const Number before = x++;
  const Number up = ++x;
  const Number before_down = x--;
  counts.values = {assigned.raw(), before.raw(), up.raw(), before_down.raw(), (--x).raw()};
  x = std::numeric_limits<Number>::max();
  try {
    counts.beyond_highest.raw = (++x).raw();
  } catch (const fixproof::overflow_error&) {
    counts.beyond_highest.throws = true;
  }
  counts.then = x.raw();
  return counts;
}

/// A number type, with integers of every width.
struct Mixed {
  exact::Type number;
  std::array<IntegerType, 8> integers;
  Counts (*count)();

  template <class Number>
  static Mixed of() {
    return {
        exact::Type::of<Number>(),
        {with<Number, std::int8_t>(), with<Number, std::uint8_t>(), with<Number, std::int16_t>(),
         with<Number, std::uint16_t>(), with<Number, std::int32_t>(), with<Number, std::uint32_t>(),
         with<Number, std::int64_t>(), with<Number, std::uint64_t>()},
        counted<Number>};
  }
  template <class Number, class Int>
  static constexpr IntegerType with() {
    using limits = std::numeric_limits<Int>;
    return {limits::digits, limits::is_signed, computed<Number, Int>};
  }
};
const auto mixed_types = each_type::all<Mixed>(fixproof::all_types());

std::vector<integer> edges(const IntegerType& type) {
  const integer max = (integer{1} << type.digits) - 1;
  std::vector<integer> values{0, 1, 2, 3, 7, 100};
  for (int bit = 3; bit < type.digits; ++bit) {
    for (const int step : {-1, 0, 1}) values.push_back((integer{1} << bit) + step);
  }
  values.insert(values.end(), {max, type.is_signed ? -max - 1 : integer{0}, max - 1});
  if (type.is_signed) {
    const std::vector<integer> positive = values;
    for (const integer& value : positive) values.push_back(-value - 1);
  }
  return values;
}

/// x * 2^places toward -infinity.
integer shifted(const integer& x, const integer& places) {
  const integer most = 64;  // which shifts all bits of x out of the range
  if (places >= 0) return x * (integer{1} << static_cast<int>(places < most ? places : most));
  const integer divisor = integer{1} << static_cast<int>(-places < most ? -places : most);
  return exact::round(exact::ratio(x, divisor), fixproof::rounding::floor);
}

/// Returns the first operation with a wrong result, or null.
const char* first_wrong(const exact::Type& type, const IntegerType& with, std::int64_t a,
                        const integer& b) {
  const std::int64_t word = exact::low_word(b);
  const auto differs = [&](Operator operation, const Outcome& expected) {
    return !(exact::outcome_of([&] { return with.compute(operation, a, word); }) == expected);
  };
  const integer x = a;
  const integer y = b * type.one;
  const Outcome sum = exact::in_range(type, x + y);
  if (differs(Operator::plus, sum)) return "a + b";
  if (differs(Operator::plus_a, sum)) return "b + a";
  if (differs(Operator::minus, exact::in_range(type, x - y))) return "a - b";
  if (differs(Operator::minus_a, exact::in_range(type, y - x))) return "b - a";
  const Outcome product = exact::in_range(type, x * b);
  if (differs(Operator::times, product)) return "a * b";
  if (differs(Operator::times_a, product)) return "b * a";
  if (differs(Operator::divide, exact::quotient(type, x, y))) return "a / b";
  if (differs(Operator::left, exact::in_range(type, shifted(x, b)))) return "a << b";
  if (differs(Operator::right, exact::in_range(type, shifted(x, -b)))) return "a >> b";
  const auto wrong =
      static_cast<unsigned>(with.compute(Operator::compare, a, word) ^ compared(x, y));
  return wrong == 0 ? nullptr : comparisons[static_cast<std::size_t>(std::countr_zero(wrong))];
}

TEST_OF_EACH(Integers, OfEveryWidthCountExactly, Mixed, mixed_types) {
  const auto numbers = exact::edges(type.number);
  for (const IntegerType& with : type.integers) {
    const auto integers = edges(with);
    for (const std::int64_t a : numbers) {
      for (const integer& b : integers) {
        const char* operation = first_wrong(type.number, with, a, b);
        ASSERT_EQ(operation, nullptr)
            << operation << " at a = " << exact::text(type.number, a)
            << ", b = " << (b < 0 ? "-" : "") << static_cast<std::uint64_t>(b < 0 ? -b : b)
            << ", which has " << with.digits << " bits" << (with.is_signed ? " and a sign" : "");
      }
    }
  }
}

TEST_OF_EACH(Integers, AssignAndCount, Mixed, mixed_types) {
  const Counts counts = type.count();
  const std::int64_t one = std::int64_t{1} << type.number.fraction_bits;
  EXPECT_EQ(counts.values, (std::array{4 * one, 4 * one, 6 * one, 6 * one, 4 * one}));
  const std::int64_t highest = exact::low_word(type.number.highest);
  const Outcome expected = exact::in_range(type.number, highest + type.number.one);
  EXPECT_EQ(counts.beyond_highest, expected);
  EXPECT_EQ(counts.then, expected.throws ? highest : expected.raw);
}

template <class T>
concept from = requires(T value) {
  fixproof::q16_16(value);
};
template <class T>
concept multiplies = requires(T value) {
  value* fixproof::q16_16();
};

static_assert(from<int> && from<signed char> && from<unsigned char> && from<std::uint64_t>);
static_assert(!from<bool> && !from<char> && !from<wchar_t> && !from<char8_t> && !from<char16_t> &&
              !from<char32_t>);
static_assert(multiplies<int> && multiplies<long long> && !multiplies<bool> && !multiplies<char> &&
              !multiplies<double>);
static_assert(!std::is_convertible_v<int, fixproof::q16_16>);

template <class T>
concept shifts_by = requires(fixproof::q16_16 x, T places) {
  x << places;
  x >> places;
  x <<= places;
  x >>= places;
};
enum Places : unsigned char { three = 3 };
static_assert(shifts_by<int> && shifts_by<unsigned> && shifts_by<std::size_t> && shifts_by<Places>);
static_assert(!shifts_by<double> && !shifts_by<float> && !shifts_by<fixproof::q16_16> &&
              !shifts_by<fixproof::q8_8>);
static_assert((fixproof::q16_16(1) << three) == 8 && (fixproof::q16_16(8) >> three) == 1);
static_assert([] {
  fixproof::q16_16 x(3);
  x <<= 4U;
  x >>= std::uint64_t{3};
  x <<= three;
  return x >>= 1;
}() == 24);

// Beyond every range, an integer still counts modulo the range where the policy wraps.
static_assert(fixproof::q8_8(0.5) * 200 == 100 && fixproof::q16_16(1) * 65537 == 1);
static_assert(fixproof::q16_16_saturating(1) * (std::int64_t{1} << 40) > 32767);

TEST(Integers, ErrorsNameTheIntegerAsItIs) {
  try {
    static_cast<void>(fixproof::q16_16_trapping(1.5) * 40000);
    FAIL() << "no error";
  } catch (const fixproof::overflow_error& error) {
    EXPECT_STREQ(error.what(), "fixed-point overflow: operator*(1.5, 40000)");
  }
  try {
    static_cast<void>(-40000 - fixproof::q16_16_trapping(1.5));
    FAIL() << "no error";
  } catch (const fixproof::overflow_error& error) {
    EXPECT_STREQ(error.what(), "fixed-point overflow: operator-(-40000, 1.5)");
  }
}

}  // namespace
