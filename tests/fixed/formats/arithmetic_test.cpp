/// Tests every operator and function of every format against exact integers: all pairs of 8-bit
/// numbers, edges and random numbers of the others.
#include <array>
#include <cstdint>
#include <limits>
#include <set>
#include <string>

#include "fixed/fixed.hpp"
#include "tests/fixed/formats/reference.hpp"
#include "tests/fixed/formats/types.hpp"
#include "tests/support/test.hpp"

namespace arithmetic_test {

using fixproof::rounding;
using reference::integer;
using reference::number_of;
using reference::Returned;
using reference::Type;
using reference::Word;
using reference::word_of;

const Type int64 = Type::of<fixproof::number<std::int64_t, 0>>();

/// The operations on three numbers.
enum class Op { add, subtract, multiply, divide, less, equal, mul_add, lerp, dot };
constexpr std::array names{"a + b",  "a - b",   "a * b", "a / b", "a < b",
                           "a == b", "mul_add", "lerp",  "dot"};

template <class N>
Word call(Op op, Word x, Word y, Word z) {
  const auto a = number_of<N>(x);
  const auto b = number_of<N>(y);
  const auto c = number_of<N>(z);
  if (op == Op::add) return word_of(a + b);
  if (op == Op::subtract) return word_of(a - b);
  if (op == Op::multiply) return word_of(a * b);
  if (op == Op::divide) return word_of(a / b);
  if (op == Op::less) return a < b;
  if (op == Op::equal) return a == b;
  if (op == Op::mul_add) return word_of(mul_add(a, b, c));
  if (op == Op::lerp) return word_of(lerp(a, b, c));
  const std::array<N, 3> left{a, b, c};
  const std::array<N, 3> right{c, a, c};
  return word_of(dot(left, right));
}

Returned expected(Op op, const Type& type, const integer& x, const integer& y, const integer& z) {
  const auto sum = [&](const integer& value) { return in_range(type, value, type.rules.range); };
  if (op == Op::add) return sum(x + y);
  if (op == Op::subtract) return sum(x - y);
  if (op == Op::multiply) return returned_product(type, x * y);
  if (op == Op::divide) return returned_quotient(type, x, y);
  if (op == Op::less) return integer(x < y ? 1 : 0);
  if (op == Op::equal) return integer(x == y ? 1 : 0);
  if (op == Op::mul_add) return returned_product(type, x * y + z * type.one);
  if (op == Op::lerp) {
    return sum(reference::round(x * type.one + (y - x) * z, type.one, type.rules.multiply));
  }
  return returned_product(type, x * z + y * x + z * z);
}

/// The functions of one number.
enum class Function { negate, floor, trunc, round, ceil, abs, sqrt, to_int64 };
constexpr std::array function_names{"-a",   "floor", "trunc", "round",
                                    "ceil", "abs",   "sqrt",  "operator int64_t"};

template <class N>
Word call(Function function, Word x) {
  const auto a = number_of<N>(x);
  if (function == Function::negate) return word_of(-a);
  if (function == Function::floor) return word_of(floor(a));
  if (function == Function::trunc) return word_of(trunc(a));
  if (function == Function::round) return word_of(fixproof::round(a));
  if (function == Function::ceil) return word_of(ceil(a));
  if (function == Function::abs) return word_of(fixproof::abs(a));
  if (function == Function::sqrt) return word_of(sqrt(a));
  return static_cast<Word>(static_cast<std::int64_t>(a));
}

Returned expected(Function function, const Type& type, const integer& x) {
  const fixproof::policy& rules = type.rules;
  const auto in_type = [&](const integer& value) { return in_range(type, value, rules.range); };
  const auto whole = [&](rounding rule) {
    return in_type(reference::round(x, type.one, rule) * type.one);
  };
  const bool to_nearest = rules.multiply != rounding::floor &&
                          rules.multiply != rounding::truncate &&
                          rules.multiply != rounding::ceiling;
  if (function == Function::negate) return in_type(-x);
  if (function == Function::floor) return whole(rounding::floor);
  if (function == Function::trunc) return whole(rounding::truncate);
  if (function == Function::round) return whole(to_nearest ? rules.multiply : rounding::half_up);
  if (function == Function::ceil) return in_type(-reference::below(-x, type.one) * type.one);
  if (function == Function::abs) return in_type(x < 0 ? -x : x);
  if (function == Function::sqrt) {
    const bool traps = rules.range == fixproof::overflow::trap;
    if (x < 0) return traps ? Returned() : integer(0);
    // Roots saturate under policies that wrap.
    return in_range(type, reference::root(x * type.one),
                    traps ? fixproof::overflow::trap : fixproof::overflow::saturate);
  }
  return in_range(int64, reference::round(x, type.one, rounding::truncate),
                  fixproof::overflow::wrap);
}

/// The operations of one type.
struct Calls {
  Type type;
  Word (*on_three)(Op op, Word a, Word b, Word c);
  Word (*on_one)(Function function, Word a);

  template <class N>
  static Calls of() {
    return {Type::of<N>(), call<N>, call<N>};
  }
};

/// The first operation on a, b and c with a wrong result, or nothing.
std::string first_wrong(const Calls& calls, Word a, Word b, Word c) {
  const Type& type = calls.type;
  const integer x = type.value(a);
  const integer y = type.value(b);
  const integer z = type.value(c);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto op = static_cast<Op>(i);
    const auto got = reference::outcome([&] { return calls.on_three(op, a, b, c); });
    const std::string wrong = difference(type, got, expected(op, type, x, y, z));
    if (!wrong.empty()) return names[i] + (" is " + wrong);
  }
  return {};
}

/// The same for functions of one number.
std::string first_wrong(const Calls& calls, Word a) {
  const integer x = calls.type.value(a);
  for (std::size_t i = 0; i < function_names.size(); ++i) {
    const auto function = static_cast<Function>(i);
    const Type& type = function == Function::to_int64 ? int64 : calls.type;
    const auto got = reference::outcome([&] { return calls.on_one(function, a); });
    const std::string wrong = difference(type, got, expected(function, calls.type, x));
    if (!wrong.empty()) return function_names[i] + (" is " + wrong);
  }
  return {};
}

/// The operations of a number and an integer.
enum class Mixed { add, subtract, subtract_from, multiply, divide, less, equal, more };
constexpr std::array mixed_names{"a + i", "a - i", "i - a",  "i * a",
                                 "a / i", "a < i", "a == i", "i < a"};

template <class N, class Int>
Word call(Mixed op, Word x, Word y) {
  const auto a = number_of<N>(x);
  const auto i = static_cast<Int>(y);
  if (op == Mixed::add) return word_of(a + i);
  if (op == Mixed::subtract) return word_of(a - i);
  if (op == Mixed::subtract_from) return word_of(i - a);
  if (op == Mixed::multiply) return word_of(i * a);
  if (op == Mixed::divide) return word_of(a / i);
  if (op == Mixed::less) return a < i;
  if (op == Mixed::equal) return a == i;
  return i < a;
}

Returned expected(Mixed op, const Type& type, const integer& x, const integer& i) {
  const integer y = i * type.one;
  const auto sum = [&](const integer& value) { return in_range(type, value, type.rules.range); };
  if (op == Mixed::add) return sum(x + y);
  if (op == Mixed::subtract) return sum(x - y);
  if (op == Mixed::subtract_from) return sum(y - x);
  if (op == Mixed::multiply) return in_range(type, x * i, type.rules.product_range());
  if (op == Mixed::divide) return returned_quotient(type, x, y);
  if (op == Mixed::less) return integer(x < y ? 1 : 0);
  if (op == Mixed::equal) return integer(x == y ? 1 : 0);
  return integer(y < x ? 1 : 0);
}

/// The operations of one type with integers of another.
struct MixedCalls {
  Type integers;
  Word (*call)(Mixed op, Word a, Word i);
  Word (*converted)(Word i);

  template <class N, class Int>
  static MixedCalls of() {
    return {Type::of<fixproof::number<Int, 0>>(), arithmetic_test::call<N, Int>,
            [](Word i) { return word_of(N(static_cast<Int>(i))); }};
  }
};

/// Those of one type with each type of integers.
struct IntegerCalls {
  Type type;
  std::array<MixedCalls, 3> with;

  template <class N>
  static IntegerCalls of() {
    return {Type::of<N>(),
            {MixedCalls::of<N, std::int64_t>(), MixedCalls::of<N, std::uint64_t>(),
             MixedCalls::of<N, std::int16_t>()}};
  }
};

/// The same for a number and an integer.
std::string first_wrong(const Type& type, const MixedCalls& calls, Word a, Word i) {
  const integer x = type.value(a);
  const integer y = calls.integers.value(i);
  for (std::size_t k = 0; k < mixed_names.size(); ++k) {
    const auto op = static_cast<Mixed>(k);
    const auto got = reference::outcome([&] { return calls.call(op, a, i); });
    const std::string wrong = difference(type, got, expected(op, type, x, y));
    if (!wrong.empty()) return mixed_names[k] + (" is " + wrong + ", i = " + y.str());
  }
  return {};
}

void every_pair(const Calls& calls) {
  const Type& type = calls.type;
  const auto lowest = static_cast<int>(type.lowest);
  const auto highest = static_cast<int>(type.highest);
  const auto word = [&](int value) { return type.word(static_cast<Word>(value)); };
  for (int i = lowest; i <= highest; ++i) {
    const Word a = word(i);
    ASSERT_EQ(first_wrong(calls, a), "") << listed(type, {a});
    for (int k = lowest; k <= highest; ++k) {
      const Word b = word(k);
      const Word c = word(i * 7 + k * 3);
      ASSERT_EQ(first_wrong(calls, a, b, c), "") << listed(type, {a, b, c});
    }
  }
}
[[maybe_unused]] const bool narrow_pairs =
    each_type::add_each<formats::narrow>("NarrowFormats", "EveryPair", every_pair);

void edges_and_random_numbers(const Calls& calls) {
  const auto values = reference::operands(calls.type, 60);
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASSERT_EQ(first_wrong(calls, values[i]), "") << listed(calls.type, {values[i]});
    for (std::size_t k = 0; k < values.size(); ++k) {
      const Word c = values[(i * 7 + k * 3) % values.size()];
      ASSERT_EQ(first_wrong(calls, values[i], values[k], c), "")
          << listed(calls.type, {values[i], values[k], c});
    }
  }
}
[[maybe_unused]] const bool wide_edges = each_type::add_each<formats::wide>(
    "WideFormats", "EdgesAndRandomNumbers", edges_and_random_numbers);

void every_triple_of_ends(const Calls& calls) {
  const Type& type = calls.type;
  const Word lowest = type.stored(type.lowest);
  const Word highest = type.stored(type.highest);
  const std::array ends{Word{1}, lowest, highest, Word{0}, lowest + 1, highest - 1};
  for (const Word a : ends) {
    ASSERT_EQ(first_wrong(calls, a), "") << listed(type, {a});
    for (const Word b : ends) {
      for (const Word c : ends) {
        ASSERT_EQ(first_wrong(calls, a, b, c), "") << listed(type, {a, b, c});
      }
    }
  }
}
[[maybe_unused]] const bool wide_ends =
    each_type::add_each<formats::wide>("WideFormats", "EveryTripleOfEnds", every_triple_of_ends);

void integers(const IntegerCalls& calls) {
  const Type& type = calls.type;
  const auto some_integers = reference::operands(int64, 30);
  for (const MixedCalls& with : calls.with) {
    // Many are equal as short integers.
    std::set<Word> distinct;
    for (const Word i : some_integers) distinct.insert(with.integers.word(i));
    for (const Word i : distinct) {
      const auto got = reference::outcome([&] { return with.converted(i); });
      const integer y = with.integers.value(i);
      ASSERT_EQ(difference(type, got, in_range(type, y * type.one, type.rules.range)), "")
          << "of the integer " << y << " as a number of " << type;
    }
    for (const Word a : reference::distinct_operands(type, 30)) {
      for (const Word i : distinct) {
        ASSERT_EQ(first_wrong(type, with, a, i), "") << listed(type, {a});
      }
    }
  }
}
[[maybe_unused]] const bool wide_integers =
    each_type::add_each<formats::wide>("WideFormats", "Integers", integers);

// The policy of products decides whether mul_add throws.
constexpr fixproof::policy products_throw{.products = fixproof::overflow::trap};
template <class N>
constexpr bool mul_add_throws = !noexcept(mul_add(N(), N(), N()));
static_assert(mul_add_throws<fixproof::with_policy<fixproof::q16_16, products_throw>>);
static_assert(!mul_add_throws<fixproof::number<std::int32_t, 16, formats::mixed>>);

// The first products and quotients of other libraries that are not representable.
TEST(Formats, KnownValues) {
  using fixproof::number;
  using q2_30 = number<std::int32_t, 30>;
  EXPECT_EQ((q2_30(1.5) * q2_30(-1.25)).raw(), -2013265920);
  using u0_64 = number<std::uint64_t, 64>;
  EXPECT_EQ((u0_64(0.5) * u0_64(0.5)).raw(), std::uint64_t{1} << 62);
  EXPECT_EQ((u0_64(0.25) / u0_64(0.5)).raw(), std::uint64_t{1} << 63);
  EXPECT_EQ(to_string(u0_64::from_raw(1)),
            "0.0000000000000000000542101086242752217003726400434970855712890625");
  using q32_32 = number<std::int64_t, 32>;
  EXPECT_EQ(sqrt(q32_32(2)).raw(), 6074001000);  // 6074000999.95
  // The roots of 1/4 and more are out of range without a whole bit.
  using q0_32 = number<std::int32_t, 32>;
  EXPECT_EQ(sqrt(q0_32::from_raw(0x40000000)).raw(), 0x7FFFFFFF);
  EXPECT_EQ(sqrt(q0_32::from_raw(0x3FFFFFFE)).raw(),
            0x7FFFFFFE);  // 2^31 (1 - 2^-29)^(1/2) = 2^31 - 2
  EXPECT_EQ(sqrt(number<std::int64_t, 64>::from_raw(std::int64_t{1} << 62)).raw(),
            std::numeric_limits<std::int64_t>::max());
}

// The root of a double needs its correction there: at squares, and halfway between two.
TEST(Formats, RootsOfWordsBesideSquaresAndHalves) {
  const auto check = [](std::uint64_t n) {
    const integer expected = reference::root(integer(n));
    ASSERT_EQ(integer(fixproof::detail::nearest_sqrt_of_word(n)), expected) << n;
  };
  std::mt19937_64 random(64);
  for (int i = 0; i < 60'000; ++i) {
    // Every bit length, and often the greatest roots.
    const std::uint64_t r =
        i % 3 == 0 ? 0xFFFFFFFF - random() % 1000 : (random() >> 32) >> random() % 32;
    for (const std::uint64_t n : {r * r, r * r + r}) {
      check(n - 1);
      check(n);
      check(n + 1);
    }
  }
  check(0);
  check(~std::uint64_t{0});
}

}  // namespace arithmetic_test
