// Tests that types follow the rules of programs, as docs/ports.md says.
#include "fixed/fixed.hpp"
#include "judge/check/ports.hpp"
#include "tests/judge/check/port_cases.hpp"
#include "tests/support/test.hpp"

namespace port_presets_test {

using namespace fixproof;
using cases::Operation;
using check::Said;
using port_cases::Pair;
using port_cases::Pairs;

constexpr int cases_of_each = 1'000'000;

template <class Number>
Said word(Number x) {
  return static_cast<std::uint32_t>(x.raw());
}
template <class Number>
Said word(std::optional<Number> x) {
  return x ? word(*x) : Said();
}

/// Compares a rule with a type's operation. `operate` gets three numbers and may ignore the third.
template <class Number, class Operate>
void expect_same(std::string_view name, Operation operation, const Operate& operate) {
  for (const check::PortRule& rule : check::port_rules()) {
    if (rule.name != name || rule.operation != operation) continue;
    Pairs pairs;
    int wrong = 0;
    for (int i = 0; i < cases_of_each && wrong < 3; ++i) {
      const Pair pair = pairs.next();
      const std::int32_t third = pairs.next().b;
      const Said right =
          rule.result(std::array<std::int64_t, 3>{pair.a, pair.b, third}, Number::fraction_bits);
      const Said said =
          operate(Number::from_raw(pair.a), Number::from_raw(pair.b), Number::from_raw(third));
      if (said == right) continue;
      ++wrong;
      ADD_FAILURE() << name << ' ' << Number::fraction_bits << ": " << pair.a << ' ' << pair.b
                    << ' ' << third;
    }
    return;
  }
  FAIL() << name;
}

constexpr auto multiplied = [](auto a, auto b, auto) { return word(a * b); };
constexpr auto divided = [](auto a, auto b, auto) { return word(try_divide(a, b)); };
constexpr auto scaled = [](auto a, auto b, auto c) {
  try {
    return word(mul_div(a, b, c));
  } catch (const std::exception&) {
    return Said();
  }
};

template <int F>
void expect_build() {
  using fixed = number<std::int32_t, F, policies::i386_unrounded>;
  expect_same<fixed>("build", Operation::mul, multiplied);
  expect_same<fixed>("build", Operation::div, divided);
}

TEST(PortPresets, Build) {
  expect_build<1>();
  expect_build<8>();
  expect_build<14>();
  expect_build<16>();
  expect_build<28>();
  expect_build<31>();
  expect_build<32>();
}

TEST(PortPresets, ProductsOverADivisor) {
  constexpr policy faults{
      .multiply = rounding::floor, .divide = rounding::truncate, .quotients = overflow::trap};
  expect_same<with_policy<q16_16, faults>>("build", Operation::mul_div, scaled);
}

TEST(PortPresets, RiseOfTheTriad) {
  expect_same<q16_16_i386_mul_rounded>("rott", Operation::mul, multiplied);
  expect_same<q16_16_i386_mul_rounded>("rott", Operation::div, divided);
}

TEST(PortPresets, Descent) {
  expect_same<q16_16_i386_unrounded>("descent", Operation::mul, multiplied);
  expect_same<q16_16_i386_unrounded>("descent", Operation::div, divided);
}

/// FixedDiv of docs/ports.md; empty for a divide error.
template <class Number>
Said guarded_quotient(Number a, Number b, Number) {
  using limits = std::numeric_limits<Number>;
  if ((abs(a) >> 14) >= abs(b)) {
    return word((a < 0) != (b < 0) ? limits::lowest() : limits::max());
  }
  return word(try_divide(a, b));
}

TEST(PortPresets, Doom) {
  expect_same<q16_16_i386_unrounded>("doom", Operation::mul, multiplied);
  expect_same<q16_16_i386_unrounded>("doom", Operation::div,
                                     guarded_quotient<q16_16_i386_unrounded>);
  constexpr policy wraps{.multiply = rounding::floor, .divide = rounding::truncate};
  using fixed = with_policy<q16_16, wraps>;
  expect_same<fixed>("chocolate-doom", Operation::mul, multiplied);
  expect_same<fixed>("chocolate-doom", Operation::div, guarded_quotient<fixed>);
}

TEST(PortPresets, AllegroInC) {
  constexpr policy saturates{.multiply = rounding::floor, .range = overflow::saturate};
  expect_same<with_policy<q16_16, saturates>>("allegro-c", Operation::mul, multiplied);
}

TEST(PortPresets, Wolfenstein) {
  constexpr policy truncates{.multiply = rounding::truncate};
  using fixed = with_policy<q16_16, truncates>;
  expect_same<fixed>("wolf3d", Operation::mul, [](fixed a, fixed b, fixed) {
    const fixed size = fixed::from_raw(b.raw() & 0xffff);
    return word(a * (b < 0 ? -size : size));
  });
}

// dmulscale and tmulscale of Build, and vm_vec_rotate of Descent: 64-bit sums of products, shifted
// once.
TEST(PortPresets, SumsOfProductsAreShiftedOnce) {
  using fixed = q16_16_i386_unrounded;
  Pairs pairs;
  for (int i = 0; i < cases_of_each; ++i) {
    std::array<fixed, 3> a;
    std::array<fixed, 3> b;
    std::uint64_t sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Pair pair = pairs.next();
      a.at(k) = fixed::from_raw(pair.a);
      b.at(k) = fixed::from_raw(pair.b);
      sum += static_cast<std::uint64_t>(std::int64_t{pair.a} * pair.b);
    }
    ASSERT_EQ(word(dot(a, b)), Said(static_cast<std::uint32_t>(sum >> 16U)));
  }
}

}  // namespace port_presets_test
