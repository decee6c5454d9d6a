// The freestanding part of the number type, without a library: `freestanding` counts what is wrong.
// Operands are volatile, so that the work is left to run time.
#include <array>

#include "fixed/fixed.hpp"

#if __STDC_HOSTED__
#error "to be compiled with -ffreestanding"
#endif

namespace {

using namespace fixproof;

/// Counts what is wrong.
class expectation {
 public:
  void operator()(bool right) { wrong_ += right ? 0 : 1; }
  [[nodiscard]] int wrong() const { return wrong_; }

 private:
  int wrong_ = 0;
};

template <class Number>
Number opaque(Number value) {
  const volatile typename Number::raw_type raw = value.raw();
  return Number::from_raw(raw);
}

template <class Number>
void arithmetic(expectation& expect) {
  const Number six = opaque(Number(6));
  const Number two = opaque(Number(-2));
  expect(six + two == Number(4));
  expect(six - two == Number(8));
  expect(six * two == Number(-12));
  expect(six / two == Number(-3));
  expect(-six == Number(-6) && abs(two) == Number(2) && two < six);
  expect(!try_divide(six, opaque(Number())));
  expect(*try_divide(six, two) == Number(-3));
  expect(sqrt(opaque(Number(9))) == Number(3));
  expect(mul_add(six, two, six) == Number(-6));
  expect(lerp(two, six, opaque(Number(1))) == six);
  const std::array<Number, 2> terms{six, two};
  expect(dot(terms, terms) == Number(40));
  const volatile int angle = 2700;
  expect(sin_of_tenths<Number>(angle) == Number(-1) && cos_of_tenths<Number>(angle) == Number());
  expect(floor(two) == two && ceil(six) == six && round(six) == six && trunc(two) == two);
  expect(static_cast<int>(six) == 6 && to_integer<rounding::floor>(two) == -2);
}

}  // namespace

extern "C" int freestanding() {
  expectation expect;
  arithmetic<q16_16>(expect);
  arithmetic<q16_16_saturating>(expect);
  arithmetic<q16_16_trapping>(expect);
  arithmetic<q16_16_i386>(expect);
  arithmetic<q16_16_i386_mul_rounded>(expect);
  arithmetic<q16_16_i386_div_rounded>(expect);
  arithmetic<q16_16_i386_unrounded>(expect);
  arithmetic<q16_16_i8088>(expect);
  arithmetic<q16_16_i8088_mul_rounded>(expect);
  arithmetic<q16_16_i8088_div_rounded>(expect);
  arithmetic<q16_16_i8088_unrounded>(expect);
  arithmetic<q8_8>(expect);
  arithmetic<q8_8_trapping>(expect);
  arithmetic<q8_8_i386>(expect);
  // Worked out by hand: -2/3 is -43690.67 units; the halves of the two units are 0.5 and -0.5.
  expect((opaque(q16_16(-2)) / opaque(q16_16(3))).raw() == -43691);
  expect((opaque(q16_16::from_raw(1)) * opaque(q16_16(0.5))).raw() == 1);
  expect((opaque(q16_16::from_raw(-1)) * opaque(q16_16(0.5))).raw() == 0);
  expect(opaque(q16_16(-1)) / opaque(q16_16()) == std::numeric_limits<q16_16>::lowest());
  expect(std::hash<q16_16>{}(opaque(q16_16(1))) == std::hash<q16_16>{}(q16_16(1)));
  return expect.wrong();
}
