/// Tests sums, products and quotients of every type against exact fractions, for every pair of edge
/// values and for random operands.
#include "fixed/fixed.hpp"
#include "tests/fixed/exact.hpp"
#include "tests/fixed/property.hpp"
#include "tests/fixed/types.hpp"
#include "tests/support/test.hpp"

namespace {

template <class Number>
class Arithmetic : public testing::Test {};
TYPED_TEST_SUITE(Arithmetic, fixproof::all_types);

/// Returns the name of the first operation on a and b with a wrong result, or null.
template <class Number>
[[gnu::noinline]] const char* first_wrong(Number a, Number b) {
  using exact::integer;
  const auto differs = [](exact::outcome<Number> expected, const auto& call) {
    return !(exact::run<Number>(call) == expected);
  };
  const integer x = a.raw();
  const integer y = b.raw();
  const integer unit = exact::one<Number>;
  if (differs(exact::in_range<Number>(x + y), [&] { return a + b; })) return "a + b";
  if (differs(exact::in_range<Number>(x - y), [&] { return a - b; })) return "a - b";
  if (differs(exact::in_range<Number>(-x), [&] { return -a; })) return "-a";
  if (differs(exact::result<Number>({x * y, unit}), [&] { return a * b; })) return "a * b";
  const auto quotient = exact::quotient(a, b);
  if (differs(quotient, [&] { return a / b; })) return "a / b";
  const auto tried = fixproof::try_divide(a, b);
  if (tried.has_value() != !(quotient.throws || exact::no_quotient(a, b))) return "try_divide";
  if (tried && tried->raw() != quotient.raw) return "*try_divide";
  if ((a < b) != (x < y) || (a == b) != (x == y) || (a >= b) != (x >= y)) return "a <=> b";
  return nullptr;
}

TYPED_TEST(Arithmetic, EveryPairOfEdges) {
  const auto edges = exact::edges<TypeParam>();
  for (const auto a : edges) {
    for (const auto b : edges) {
      const char* operation = first_wrong(a, b);
      ASSERT_EQ(operation, nullptr) << operation << " at a = " << a << ", b = " << b;
    }
  }
}

TYPED_TEST(Arithmetic, Properties) {
  std::string operation;
  EXPECT_TRUE(property::for_all<TypeParam>([&](TypeParam a, TypeParam b) {
    const char* wrong = first_wrong(a, b);
    if (wrong != nullptr) operation = wrong;
    return wrong == nullptr;
  })) << operation;
}

template <class Number>
class Assignment : public testing::Test {};
TYPED_TEST_SUITE(Assignment, fixproof::some_types);

TYPED_TEST(Assignment, IsTheOperator) {
  EXPECT_TRUE(property::for_all<TypeParam>([](TypeParam a, TypeParam b) {
    const auto same = [&](const auto& plain, const auto& assign) {
      return exact::run<TypeParam>(plain) == exact::run<TypeParam>([&] {
               TypeParam x = a;
               return assign(x);
             });
    };
    return same([&] { return a + b; }, [&](TypeParam& x) { return x += b; }) &&
           same([&] { return a - b; }, [&](TypeParam& x) { return x -= b; }) &&
           same([&] { return a * b; }, [&](TypeParam& x) { return x *= b; }) &&
           same([&] { return a / b; }, [&](TypeParam& x) { return x /= b; });
  }));
}

/// Tests all 8.8 numbers against operands that reach every rule.
template <class Number>
class Exhaustive : public testing::Test {};
using half_width = testing::Types<fixproof::q8_8, fixproof::q8_8_saturating, fixproof::q8_8_i386,
                                  fixproof::q8_8_i386_unrounded, fixproof::q8_8_i8088,
                                  fixproof::q8_8_i8088_unrounded>;
TYPED_TEST_SUITE(Exhaustive, half_width);

TYPED_TEST(Exhaustive, EveryOperandAgainstEdges) {
  using raw = typename TypeParam::raw_type;
  for (const int other : {0, 1, -1, 2, -3, 0x7f, 0x80, -0x80, 0xff, 0x100, -0x100, 0x101, 0x17f,
                          -0x180, 0x1234, 0x7fff, -0x7fff, -0x8000}) {
    const auto b = TypeParam::from_raw(static_cast<raw>(other));
    for (int value = std::numeric_limits<raw>::min(); value <= std::numeric_limits<raw>::max();
         ++value) {
      const auto a = TypeParam::from_raw(static_cast<raw>(value));
      const char* operation = first_wrong(a, b);
      ASSERT_EQ(operation, nullptr) << operation << " at a = " << a << ", b = " << b;
      operation = first_wrong(b, a);
      ASSERT_EQ(operation, nullptr) << operation << " at a = " << b << ", b = " << a;
    }
  }
}

}  // namespace
