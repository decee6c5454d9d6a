/// Tests every operator between a number and an integer against exact fractions: edges of the type
/// with edges of the integer, and shifts by the integer, for integers of 8 to 64 bits.
#include <cstdint>
#include <limits>
#include <vector>

#include "fixed/fixed.hpp"
#include "tests/fixed/exact.hpp"
#include "tests/fixed/types.hpp"
#include "tests/support/test.hpp"

namespace {

using exact::integer;

template <class Number>
class Integers : public testing::Test {};
TYPED_TEST_SUITE(Integers, fixproof::all_types);

template <class Int>
std::vector<Int> edges() {
  using limits = std::numeric_limits<Int>;
  std::vector<Int> values{0, 1, 2, 3, 7, 100};
  for (int bit = 3; bit < limits::digits; ++bit) {
    for (const int step : {-1, 0, 1}) {
      values.push_back(static_cast<Int>((Int{1} << bit) + static_cast<Int>(step)));
    }
  }
  values.insert(values.end(), {limits::max(), limits::min(), static_cast<Int>(limits::max() - 1)});
  if constexpr (limits::is_signed) {
    const std::vector<Int> positive = values;
    for (const Int value : positive) values.push_back(static_cast<Int>(-integer{value} - 1));
  }
  return values;
}

/// The quotient by the policy. Only 0 and -1 can leave the range.
template <class Number, class Int>
exact::outcome<Number> quotient(Number n, Int d) {
  if (d == 0) return exact::quotient(n, Number());
  if (integer{d} == -1) return exact::quotient(n, Number(-1));
  return exact::in_range<Number>(
      exact::round(exact::ratio(integer{n.raw()}, integer{d}), Number::rules.divide));
}

/// x * 2^places toward -infinity.
integer shifted(const integer& x, const integer& places) {
  const integer most = 64;  // which shifts all bits of x out of the range
  if (places >= 0) return x * (integer{1} << static_cast<int>(places < most ? places : most));
  const integer divisor = integer{1} << static_cast<int>(-places < most ? -places : most);
  return exact::round(exact::ratio(x, divisor), fixproof::rounding::floor);
}

/// Returns the first operation with a wrong result, or null.
template <class Number, class Int>
[[gnu::noinline]] const char* first_wrong(Number a, Int b) {
  const auto differs = [](exact::outcome<Number> expected, const auto& call) {
    return !(exact::run<Number>(call) == expected);
  };
  const integer x = a.raw();
  const integer n = b;
  const integer y = n * exact::one<Number>;
  if (differs(exact::in_range<Number>(x + y), [&] { return a + b; })) return "a + b";
  if (differs(exact::in_range<Number>(x + y), [&] { return b + a; })) return "b + a";
  if (differs(exact::in_range<Number>(x - y), [&] { return a - b; })) return "a - b";
  if (differs(exact::in_range<Number>(y - x), [&] { return b - a; })) return "b - a";
  if (differs(exact::in_range<Number>(x * n), [&] { return a * b; })) return "a * b";
  if (differs(exact::in_range<Number>(x * n), [&] { return b * a; })) return "b * a";
  if (differs(quotient(a, b), [&] { return a / b; })) return "a / b";
  if (differs(exact::in_range<Number>(shifted(x, n)), [&] { return a << b; })) return "a << b";
  if (differs(exact::in_range<Number>(shifted(x, -n)), [&] { return a >> b; })) return "a >> b";
  if ((a == b) != (x == y) || (b == a) != (x == y) || (a != b) != (x != y)) return "a == b";
  if ((a < b) != (x < y) || (a <= b) != (x <= y) || (a > b) != (x > y)) return "a <=> b";
  if ((b < a) != (y < x) || (b >= a) != (y >= x)) return "b <=> a";
  return nullptr;
}

template <class Number, class Int>
void check_all() {
  const std::vector<Int> integers = edges<Int>();
  for (const Number a : exact::edges<Number>()) {
    for (const Int b : integers) {
      const char* operation = first_wrong(a, b);
      ASSERT_EQ(operation, nullptr) << operation << " at a = " << a << ", b = " << +b;
    }
  }
}

TYPED_TEST(Integers, OfEveryWidthCountExactly) {
  check_all<TypeParam, std::int8_t>();
  check_all<TypeParam, std::uint8_t>();
  check_all<TypeParam, std::int16_t>();
  check_all<TypeParam, std::uint16_t>();
  check_all<TypeParam, std::int32_t>();
  check_all<TypeParam, std::uint32_t>();
  check_all<TypeParam, std::int64_t>();
  check_all<TypeParam, std::uint64_t>();
}

TYPED_TEST(Integers, AssignAndCount) {
  TypeParam x(2.5);
  x *= 4;
  x += 1;
  x -= 3;
  x /= 2;
  EXPECT_EQ(x, 4);
  EXPECT_EQ(x++, 4);
  EXPECT_EQ(++x, 6);
  EXPECT_EQ(x--, 6);
  EXPECT_EQ(--x, 4);
  x = std::numeric_limits<TypeParam>::max();
  const TypeParam before = x;
  const auto expected = exact::in_range<TypeParam>(integer{x.raw()} + exact::one<TypeParam>);
  EXPECT_EQ(exact::run<TypeParam>([&] { return ++x; }), expected);
  if (expected.throws) {
    EXPECT_EQ(x, before);
  }
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
