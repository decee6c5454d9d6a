/// Tests the operations of fixed/checked.hpp and fixed/wide.hpp, the remainder and the shifts
/// against exact integers in every format.
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fixed/fixed.hpp"
#include "tests/fixed/formats/reference.hpp"
#include "tests/fixed/formats/types.hpp"
#include "tests/support/test.hpp"

namespace checked_test {

using fixproof::overflow;
using reference::integer;
using reference::number_of;
using reference::Returned;
using reference::Type;
using reference::Word;
using reference::word_of;

/// The operands of one call.
struct Operands {
  Word a;
  Word b;
  Word c;
  int places;  ///< Of shifts.
};

/// The operations that have four forms, those on one number last.
enum class Op { add, subtract, multiply, mul_add, divide, negate, abs, shift_left };
const std::array<std::string, 8> names{"add",    "subtract", "multiply", "mul_add",
                                       "divide", "negate",   "abs",      "shift_left"};

/// The results of the four forms.
struct Forms {
  std::optional<Word> checked;
  Word flagged;
  bool overflow;
  Word saturating;
  Word wrapping;
};

template <class N>
std::optional<Word> word_of(const std::optional<N>& x) {
  return x ? std::optional(word_of(*x)) : std::nullopt;
}

template <class N>
Forms call(Op op, const Operands& of) {
  using namespace fixproof;  // NOLINT(google-build-using-namespace)
  const auto a = number_of<N>(of.a);
  const auto b = number_of<N>(of.b);
  const auto c = number_of<N>(of.c);
  const auto forms = [](const std::optional<N>& checked, const overflowing<N>& flagged,
                        N saturating, N wrapping) {
    return Forms{word_of(checked), word_of(flagged.value), flagged.overflow, word_of(saturating),
                 word_of(wrapping)};
  };
  if (op == Op::add) {
    return forms(checked_add(a, b), overflowing_add(a, b), saturating_add(a, b),
                 wrapping_add(a, b));
  }
  if (op == Op::subtract) {
    return forms(checked_subtract(a, b), overflowing_subtract(a, b), saturating_subtract(a, b),
                 wrapping_subtract(a, b));
  }
  if (op == Op::multiply) {
    return forms(checked_multiply(a, b), overflowing_multiply(a, b), saturating_multiply(a, b),
                 wrapping_multiply(a, b));
  }
  if (op == Op::mul_add) {
    return forms(checked_mul_add(a, b, c), overflowing_mul_add(a, b, c),
                 saturating_mul_add(a, b, c), wrapping_mul_add(a, b, c));
  }
  if (op == Op::negate) {
    return forms(checked_negate(a), overflowing_negate(a), saturating_negate(a),
                 wrapping_negate(a));
  }
  if (op == Op::abs) {
    return forms(checked_abs(a), overflowing_abs(a), saturating_abs(a), wrapping_abs(a));
  }
  if (op == Op::divide) {
    return forms(checked_divide(a, b), overflowing_divide(a, b), saturating_divide(a, b),
                 wrapping_divide(a, b));
  }
  return forms(checked_shift_left(a, of.places), overflowing_shift_left(a, of.places),
               saturating_shift_left(a, of.places), wrapping_shift_left(a, of.places));
}

/// The functions that return nothing for an error.
enum class Checked { remainder, sqrt };

template <class N>
std::optional<Word> call(Checked function, const Operands& of) {
  const auto a = number_of<N>(of.a);
  if (function == Checked::sqrt) return word_of(checked_sqrt(a));
  return word_of(checked_remainder(a, number_of<N>(of.b)));
}

/// The operations whose errors the policy decides.
enum class Plain { shift_left, shift_right, remainder, mul_div, accumulator };
/// Those on two and three numbers.
constexpr std::array policy_names{std::pair(Plain::remainder, "a % b"),
                                  std::pair(Plain::mul_div, "mul_div"),
                                  std::pair(Plain::accumulator, "accumulator")};

template <class N>
Word call(Plain op, const Operands& of) {
  const auto a = number_of<N>(of.a);
  if (op == Plain::shift_left) return word_of(a << of.places);
  if (op == Plain::shift_right) return word_of(a >> of.places);
  const auto b = number_of<N>(of.b);
  if (op == Plain::remainder) return word_of(a % b);
  const auto c = number_of<N>(of.c);
  if (op == Plain::mul_div) return word_of(mul_div(a, b, c));
  fixproof::accumulator<N> sum;
  sum.add_product(a, b).subtract_product(b, c).add(a).subtract(c).add_product(a, a);
  return word_of(sum.result());
}

/// The operations of one type.
struct Calls {
  Type type;
  Forms (*forms)(Op op, const Operands& of);
  std::optional<Word> (*checked)(Checked function, const Operands& of);
  Word (*plain)(Plain op, const Operands& of);

  template <class N>
  static Calls of() {
    return {Type::of<N>(), call<N>, call<N>, call<N>};
  }
};

/// x * 2^places, rounded down.
integer shifted(const integer& x, int places) {
  if (places >= 0) return x * reference::power(2, places);
  return reference::below(x, reference::power(2, -places));
}

/// What the four forms give.
struct Expected {
  Returned checked;
  integer wrapped;
  integer saturated;
};

Expected forms_of(const Type& type, const integer& exact) {
  if (type.fits(exact)) return {exact, exact, exact};
  return {std::nullopt, type.wrapped(exact), exact < 0 ? type.lowest : type.highest};
}

/// @param x, y, z  stored integers
Expected expected(Op op, const Type& type, const integer& x, const integer& y, const integer& z) {
  const auto forms = [&](const integer& exact) { return forms_of(type, exact); };
  const auto product = [&](const integer& n) {
    return forms(reference::round(n, type.one, type.rules.multiply));
  };
  if (op == Op::add) return forms(x + y);
  if (op == Op::subtract) return forms(x - y);
  if (op == Op::multiply) return product(x * y);
  if (op == Op::mul_add) return product(x * y + z * type.one);
  const Returned quotient = exact::unreduced_quotient<integer>(type, x, y, type.rules.divide);
  if (quotient) return forms(*quotient);
  const integer end = reference::quotient(type, x, y).raw;
  return {std::nullopt, end, end};
}

Returned root_of(const Type& type, const integer& x) {
  if (x < 0) return {};
  return in_range(type, reference::root(x * type.one), overflow::trap);
}

Returned expected(Plain op, const Type& type, const integer& x, const integer& y,
                  const integer& z) {
  if (op == Plain::remainder) {
    if (y != 0) return x % y;
    return type.rules.quotient_range() == overflow::trap ? Returned() : integer(0);
  }
  // a * b / c is a quotient whose numerator is in units of 2^-F already.
  if (op == Plain::mul_div) return returned_quotient(type, x * y, z * type.one);
  return returned_product(type, x * y - y * z + (x - z) * type.one + x * x);
}

/// The first of the four forms with a wrong result, or nothing.
std::string first_wrong(const Type& type, const std::string& name, const Forms& got,
                        const Expected& expected) {
  const auto wrong = [&](const char* form, const std::optional<Word>& result,
                         const Returned& right) {
    const std::string text = difference(type, result, right);
    return text.empty() ? text : form + name + " is " + text;
  };
  for (const std::string& text : {wrong("checked_", got.checked, expected.checked),
                                  wrong("overflowing_", got.flagged, expected.wrapped),
                                  wrong("saturating_", got.saturating, expected.saturated),
                                  wrong("wrapping_", got.wrapping, expected.wrapped)}) {
    if (!text.empty()) return text;
  }
  if (got.overflow == expected.checked.has_value()) return "overflow of overflowing_" + name;
  return {};
}

/// The first operation on one number with a wrong result, or nothing.
std::string first_wrong(const Calls& calls, Word a) {
  const Type& type = calls.type;
  const integer x = type.value(a);
  const auto wrong_form = [&](Op op, int places, const integer& exact) {
    const Forms got = calls.forms(op, {a, 0, 0, places});
    return first_wrong(type, names[static_cast<std::size_t>(op)], got, forms_of(type, exact));
  };
  const auto wrong_shift = [&](Plain op, int places, const Returned& right) {
    const auto got = reference::outcome([&] { return calls.plain(op, {a, 0, 0, places}); });
    return difference(type, got, right);
  };
  std::string text = wrong_form(Op::negate, 0, -x);
  if (text.empty()) text = wrong_form(Op::abs, 0, x < 0 ? -x : x);
  if (!text.empty()) return text;
  text = difference(type, calls.checked(Checked::sqrt, {a, 0, 0, 0}), root_of(type, x));
  if (!text.empty()) return "checked_sqrt is " + text;
  for (const int places : {0, 1, 7, 31, 63, 64, 300}) {
    for (const int by : {places, -places}) {
      const integer exact = shifted(x, by);
      const std::string at = ", " + std::to_string(by) + " places";
      text = wrong_form(Op::shift_left, by, exact);
      if (!text.empty()) return text + at;
      text = wrong_shift(Plain::shift_left, by, in_range(type, exact, type.rules.range));
      if (!text.empty()) return "a << places is " + text + at;
    }
    text = wrong_shift(Plain::shift_right, places, shifted(x, -places));
    if (!text.empty()) return "a >> places is " + text + ", " + std::to_string(places) + " places";
  }
  return {};
}

/// The same for two and three numbers.
std::string first_wrong(const Calls& calls, Word a, Word b, Word c) {
  const Type& type = calls.type;
  const integer x = type.value(a);
  const integer y = type.value(b);
  const integer z = type.value(c);
  const Operands of{a, b, c, 0};
  for (const Op op : {Op::add, Op::subtract, Op::multiply, Op::mul_add, Op::divide}) {
    std::string text = first_wrong(type, names[static_cast<std::size_t>(op)], calls.forms(op, of),
                                   expected(op, type, x, y, z));
    if (!text.empty()) return text;
  }
  Returned rest;
  if (y != 0) rest = x % y;  // truncated
  std::string text = difference(type, calls.checked(Checked::remainder, of), rest);
  if (!text.empty()) return "checked_remainder is " + text;
  for (const auto& [op, name] : policy_names) {
    const auto got = reference::outcome([&, op = op] { return calls.plain(op, of); });
    text = difference(type, got, expected(op, type, x, y, z));
    if (!text.empty()) return name + (" is " + text);
  }
  return {};
}

void edges_and_random_numbers(const Calls& calls) {
  const auto values = reference::operands(calls.type, 25);
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASSERT_EQ(first_wrong(calls, values[i]), "") << listed(calls.type, {values[i]});
    for (std::size_t k = 0; k < values.size(); ++k) {
      const Word c = values[(i * 7 + k * 3) % values.size()];
      ASSERT_EQ(first_wrong(calls, values[i], values[k], c), "")
          << listed(calls.type, {values[i], values[k], c});
    }
  }
}
[[maybe_unused]] const bool edges = each_type::add_each<formats::wide>(
    "CheckedFormats", "EdgesAndRandomNumbers", edges_and_random_numbers);

/// The operations of one type with integers.
struct IntegerCalls {
  Type type;
  Word (*ratio)(std::int64_t n, std::int64_t d);
  Word (*remainder)(Word x, std::int64_t d);

  template <class N>
  static IntegerCalls of() {
    return {Type::of<N>(),
            [](std::int64_t n, std::int64_t d) { return word_of(fixproof::ratio<N>(n, d)); },
            [](Word x, std::int64_t d) { return word_of(number_of<N>(x) % d); }};
  }
};

void ratios_and_remainders(const IntegerCalls& calls) {
  const Type& type = calls.type;
  const auto wrong = [&](const auto& call, const Returned& right) {
    return difference(type, reference::outcome(call), right);
  };
  const auto integers = reference::operands(Type::of<fixproof::number<std::int64_t, 0>>(), 20);
  for (const Word n_word : integers) {
    const auto n = static_cast<std::int64_t>(n_word);
    for (const Word d_word : integers) {
      const auto d = static_cast<std::int64_t>(d_word);
      ASSERT_EQ(wrong([&] { return calls.ratio(n, d); }, returned_quotient(type, n, d)), "")
          << n << " / " << d << ", " << type;
    }
    if (n == 0) continue;
    for (const Word x : reference::operands(type, 10)) {
      const integer rest = type.value(x) % (n * type.one);
      ASSERT_EQ(wrong([&] { return calls.remainder(x, n); }, rest), "")
          << listed(type, {x}) << " % " << n;
    }
  }
}
[[maybe_unused]] const bool ratios = each_type::add_each<formats::wide>(
    "CheckedFormats", "RatiosAndRemaindersOfIntegers", ratios_and_remainders);

TEST(StickyStatus, RemembersUntilItIsCleared) {
  using fixproof::q16_16;
  fixproof::sticky_status status;
  EXPECT_EQ(status.add(q16_16(1), q16_16(2)), 3);
  EXPECT_FALSE(status.overflow());
  EXPECT_EQ(status.subtract(q16_16(-32768), q16_16(1)), 32767);
  EXPECT_TRUE(status.overflow());
  EXPECT_EQ(status.multiply(q16_16(2), q16_16(3)), 6);
  EXPECT_TRUE(status.overflow());
  status.clear();
  EXPECT_FALSE(status.overflow());
  EXPECT_EQ(status.divide(q16_16(1), q16_16()), std::numeric_limits<q16_16>::max());
  EXPECT_TRUE(status.overflow());
}

// Only the zero divisor of a processor's divide is an error there.
TEST(MulDivAndRatio, HaveNoQuotientFault) {
  using fixproof::q16_16_i386_unrounded;
  using N = q16_16_i386_unrounded;
  EXPECT_THROW(static_cast<void>(N(30000) / N(0.25)), fixproof::divide_error);
  EXPECT_EQ(mul_div(N(30000), N(1), N(0.25)), N(120000 - 131072));
  EXPECT_EQ(fixproof::ratio<N>(120000, 1), N(120000 - 131072));
  EXPECT_THROW(static_cast<void>(mul_div(N(1), N(1), N(0))), fixproof::divide_error);
}

/// Expects the results of 5 / 2 and of -5 / 2.
template <fixproof::rounding R, class Raw = std::int32_t>
void expect_halves(std::int32_t positive, std::int32_t negative) {
  using N = fixproof::number<Raw, 0, fixproof::policy{.divide = R}>;
  EXPECT_EQ(mul_div(N(5), N(3), N(6)).raw(), positive);
  EXPECT_EQ(mul_div(N(-5), N(-3), N(6)).raw(), positive);
  EXPECT_EQ(mul_div(N(-5), N(3), N(6)).raw(), negative);
  EXPECT_EQ(mul_div(N(5), N(3), N(-6)).raw(), negative);
}

TEST(MulDivAndRatio, TiesFollowThePolicy) {
  using fixproof::rounding;
  expect_halves<rounding::half_up>(3, -2);
  expect_halves<rounding::half_away>(3, -3);
  expect_halves<rounding::half_even>(2, -2);
  expect_halves<rounding::truncate>(2, -2);
  expect_halves<rounding::floor>(2, -3);
  expect_halves<rounding::ceiling>(3, -2);
  expect_halves<rounding::half_away, std::int8_t>(3, -3);
}

TEST(MulDivAndRatio, HoldsTheLargestProducts) {
  const auto lowest = fixproof::q32_0::from_raw(std::numeric_limits<std::int32_t>::min());
  EXPECT_EQ(mul_div(lowest, lowest, lowest), lowest);
  const auto highest =
      fixproof::number<std::uint32_t, 0>::from_raw(std::numeric_limits<std::uint32_t>::max());
  EXPECT_EQ(mul_div(highest, highest, highest), highest);
}

TEST(Literals, AreExactOrRounded) {
  using namespace fixproof::literals;  // NOLINT(google-build-using-namespace)
  using namespace fixproof;            // NOLINT(google-build-using-namespace)
  static_assert(1.5_q16_16 == q16_16(1.5) && -0.25_q2_30 == q2_30(-0.25));
  static_assert((0.1_q16_16_rounded).raw() == 6554);
  static_assert(1'000_q24_8 == 1000 && 0_q16_16 == 0 && 10.50_q8_8 == q8_8(10.5));
  static_assert(.5_q8_8 == q8_8(0.5) && 2._q8_8 == 2 && 007_q8_8 == 7);
  static_assert((0.00001_q1_7_rounded).raw() == 0);
  // 1/512 is half an ulp of 8.8, and 3/512 three halves: ties go to the even neighbour.
  static_assert((0.001953125_q8_8_rounded).raw() == 0 && (0.005859375_q8_8_rounded).raw() == 2);
  static_assert((1.5_q32_0_rounded).raw() == 2 && (2.5_q8_0_rounded).raw() == 2);
  static_assert((-3.5_q8_0_rounded).raw() == -4);
  static_assert(0.0000000000000000000542101086242752217003726400434970855712890625_u0_64 ==
                fixproof::u0_64::from_raw(1));
  SUCCEED();
}

}  // namespace checked_test
