/// Tests sums, products and quotients of every type against exact fractions, for every pair of edge
/// values and for random operands.
#include "fixed/fixed.hpp"
#include "tests/fixed/exact.hpp"
#include "tests/fixed/property.hpp"
#include "tests/fixed/types.hpp"
#include "tests/support/each_type.hpp"
#include "tests/support/test.hpp"

namespace arithmetic {
namespace {

using exact::integer;

/// The operators of two numbers a and b.
enum class Operator { plus, minus, negate, times, divide, compare };

/// The results of the comparisons that the others follow from, one bit each.
template <class T>
int compared(const T& a, const T& b) {
  return (a < b) | (a == b) << 1 | (a >= b) << 2;
}

template <class Number>
Number number_of(std::int64_t raw) {
  return property::number_of<Number>(raw);
}

/// The result on stored integers. One function for all operators compiles faster than one for each.
template <class Number>
std::int64_t computed(Operator operation, std::int64_t first, std::int64_t second) {
  const auto a = number_of<Number>(first);
  const auto b = number_of<Number>(second);
  switch (operation) {
    case Operator::plus:
      return (a + b).raw();
    case Operator::minus:
      return (a - b).raw();
    case Operator::negate:
      return (-a).raw();
    case Operator::times:
      return (a * b).raw();
    case Operator::divide:
      return (a / b).raw();
    case Operator::compare:
      return compared(a, b);
  }
  return 0;
}

template <class Number>
std::optional<std::int64_t> quotient_tried(std::int64_t a, std::int64_t b) {
  const auto quotient = fixproof::try_divide(number_of<Number>(a), number_of<Number>(b));
  return quotient ? std::optional<std::int64_t>(quotient->raw()) : std::nullopt;
}

/// A number type, and what its operators compute.
struct Computing {
  exact::Type number;
  std::int64_t (*compute)(Operator operation, std::int64_t a, std::int64_t b);
  std::optional<std::int64_t> (*try_divide)(std::int64_t a, std::int64_t b);

  template <class Number>
  static Computing of() {
    return {exact::Type::of<Number>(), computed<Number>, quotient_tried<Number>};
  }
};

/// Returns the name of the first operation on a and b with a wrong result, or null.
const char* first_wrong(const Computing& by, std::int64_t a, std::int64_t b) {
  const exact::Type& type = by.number;
  const auto differs = [&](Operator operation, const exact::Outcome& expected) {
    return !(exact::outcome_of([&] { return by.compute(operation, a, b); }) == expected);
  };
  const integer x = a;
  const integer y = b;
  if (differs(Operator::plus, exact::in_range(type, x + y))) return "a + b";
  if (differs(Operator::minus, exact::in_range(type, x - y))) return "a - b";
  if (differs(Operator::negate, exact::in_range(type, -x))) return "-a";
  if (differs(Operator::times, exact::result(type, {x * y, type.one}))) return "a * b";
  const auto divided = exact::policy_quotient(type, x, y);
  const auto quotient = exact::outcome_of_quotient(type, divided);
  if (differs(Operator::divide, quotient)) return "a / b";
  const auto tried = by.try_divide(a, b);
  const bool fails = quotient.throws || divided.fault == exact::Fault::divide_error;
  if (tried.has_value() == fails) return "try_divide";
  if (tried && *tried != quotient.raw) return "*try_divide";
  if (by.compute(Operator::compare, a, b) != compared(x, y)) return "a <=> b";
  return nullptr;
}

bool is_right(const Computing& by, std::int64_t a, std::int64_t b) {
  const char* operation = first_wrong(by, a, b);
  EXPECT_EQ(operation, nullptr) << operation << " at a = " << exact::text(by.number, a)
                                << ", b = " << exact::text(by.number, b);
  return operation == nullptr;
}

const auto all_types = each_type::all<Computing>(fixproof::all_types());

TEST_OF_EACH(Arithmetic, EveryPairOfEdges, Computing, all_types) {
  const auto edges = exact::edges(type.number);
  for (const std::int64_t a : edges) {
    for (const std::int64_t b : edges) {
      if (!is_right(type, a, b)) return;
    }
  }
}

TEST_OF_EACH(Arithmetic, Properties, Computing, all_types) {
  std::string operation;
  EXPECT_TRUE(property::holds(type.number.fraction_bits, 2, [&](const property::Raws& operands) {
    const char* wrong = first_wrong(type, operands[0], operands[1]);
    if (wrong != nullptr) operation = wrong;
    return wrong == nullptr;
  })) << operation;
}

/// The same by the operators that assign.
template <class Number>
std::int64_t assigned(Operator operation, std::int64_t first, std::int64_t second) {
  auto x = number_of<Number>(first);
  const auto y = number_of<Number>(second);
  switch (operation) {
    case Operator::plus:
      return (x += y).raw();
    case Operator::minus:
      return (x -= y).raw();
    case Operator::times:
      return (x *= y).raw();
    case Operator::divide:
      return (x /= y).raw();
    default:
      throw std::invalid_argument("no such assignment");
  }
}

struct Assigning {
  int fraction_bits;
  std::int64_t (*compute)(Operator operation, std::int64_t a, std::int64_t b);
  std::int64_t (*assign)(Operator operation, std::int64_t a, std::int64_t b);

  template <class Number>
  static Assigning of() {
    return {Number::fraction_bits, computed<Number>, assigned<Number>};
  }
};
const auto some_types = each_type::all<Assigning>(fixproof::some_types());

TEST_OF_EACH(Assignment, IsTheOperator, Assigning, some_types) {
  EXPECT_TRUE(property::holds(type.fraction_bits, 2, [&](const property::Raws& operands) {
    const std::int64_t a = operands[0];
    const std::int64_t b = operands[1];
    const auto is_same = [&](Operator operation) {
      return exact::outcome_of([&] { return type.compute(operation, a, b); }) ==
             exact::outcome_of([&] { return type.assign(operation, a, b); });
    };
    return is_same(Operator::plus) && is_same(Operator::minus) && is_same(Operator::times) &&
           is_same(Operator::divide);
  }));
}

/// All 8.8 numbers against operands that reach every rule.
using half_width = testing::Types<fixproof::q8_8, fixproof::q8_8_saturating, fixproof::q8_8_i386,
                                  fixproof::q8_8_i386_unrounded, fixproof::q8_8_i8088,
                                  fixproof::q8_8_i8088_unrounded>;
const auto half_width_types = each_type::all<Computing>(half_width());

TEST_OF_EACH(Exhaustive, EveryOperandAgainstEdges, Computing, half_width_types) {
  for (const int b : {0, 1, -1, 2, -3, 0x7f, 0x80, -0x80, 0xff, 0x100, -0x100, 0x101, 0x17f, -0x180,
                      0x1234, 0x7fff, -0x7fff, -0x8000}) {
    for (int a = -0x8000; a <= 0x7fff; ++a) {
      if (!is_right(type, a, b) || !is_right(type, b, a)) return;
    }
  }
}

}  // namespace
}  // namespace arithmetic
