/// Tests every operator and function of every format against exact integers: all pairs of 8-bit
/// numbers, edges and random numbers of the others.
#include <array>
#include <cstdint>
#include <limits>
#include <string>

#include "fixed/fixed.hpp"
#include "tests/fixed/formats/reference.hpp"
#include "tests/fixed/formats/types.hpp"
#include "tests/support/each_type.hpp"

namespace {

using fixproof::overflow;
using fixproof::rounding;
using reference::integer;
using reference::Type;
using reference::word;

enum class Operation {
  plus,
  minus,
  negate,
  times,
  divide,
  compare,
  mul_add,
  lerp,
  dot,
  floor,
  trunc,
  round,
  ceil,
  abs,
  sqrt,
  to_integer,
};

/// The stored integer of a result, as a word. One function for all operations compiles faster than
/// one for each.
template <class N>
std::uint64_t computed(Operation operation, const std::array<std::uint64_t, 3>& words) {
  const N a = reference::number<N>(words[0]);
  const N b = reference::number<N>(words[1]);
  const N c = reference::number<N>(words[2]);
  switch (operation) {
    case Operation::plus:
      return word(a + b);
    case Operation::minus:
      return word(a - b);
    case Operation::negate:
      return word(-a);
    case Operation::times:
      return word(a * b);
    case Operation::divide:
      return word(a / b);
    case Operation::compare:
      return static_cast<std::uint64_t>((a < b) + 2 * (a == b));
    case Operation::mul_add:
      return word(mul_add(a, b, c));
    case Operation::lerp:
      return word(lerp(a, b, c));
    case Operation::dot:
      return word(dot(std::array{a, b, c}, std::array{c, a, c}));
    case Operation::floor:
      return word(floor(a));
    case Operation::trunc:
      return word(trunc(a));
    case Operation::round:
      return word(fixproof::round(a));
    case Operation::ceil:
      return word(ceil(a));
    case Operation::abs:
      return word(fixproof::abs(a));
    case Operation::sqrt:
      return word(sqrt(a));
    case Operation::to_integer:
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(a));
  }
  return 0;
}

enum class WithInteger { conversion, plus, minus, minus_a, times_a, divide, compare };

/// The same for a number and an integer.
template <class N, class Int>
std::uint64_t computed_with(WithInteger operation, std::uint64_t number, std::uint64_t word_of_i) {
  const N a = reference::number<N>(number);
  const auto i = static_cast<Int>(word_of_i);
  switch (operation) {
    case WithInteger::conversion:
      return word(N(i));
    case WithInteger::plus:
      return word(a + i);
    case WithInteger::minus:
      return word(a - i);
    case WithInteger::minus_a:
      return word(i - a);
    case WithInteger::times_a:
      return word(i * a);
    case WithInteger::divide:
      return word(a / i);
    case WithInteger::compare:
      return static_cast<std::uint64_t>((a < i) + 2 * (a == i) + 4 * (i < a));
  }
  return 0;
}

/// An integer type, and what its operators with a number type compute.
struct IntegerType {
  Type type;
  std::uint64_t (*compute)(WithInteger operation, std::uint64_t number, std::uint64_t integer);
};

/// A number type with its operations.
struct Format {
  Type type;
  std::uint64_t (*compute)(Operation operation, const std::array<std::uint64_t, 3>& words);
  std::array<IntegerType, 3> integers;

  template <class N>
  static Format of() {
    return {Type::of<N>(),
            computed<N>,
            {with<N, std::int64_t>(), with<N, std::uint64_t>(), with<N, std::int16_t>()}};
  }
  template <class N, class Int>
  static IntegerType with() {
    return {Type::of<fixproof::number<Int, 0>>(), computed_with<N, Int>};
  }
};

/// Whether an operation has another outcome.
bool differs(const Format& format, Operation operation, const std::array<std::uint64_t, 3>& words,
             const reference::result& expected) {
  return reference::outcome_of([&] { return format.type.raw(format.compute(operation, words)); }) !=
         expected;
}

/// The name of the first operation on three numbers with a wrong result, or nothing.
std::string first_wrong(const Format& format, const std::array<std::uint64_t, 3>& words) {
  const Type& type = format.type;
  const fixproof::policy& rules = type.rules;
  const integer one = type.one();
  const integer x = type.raw(words[0]);
  const integer y = type.raw(words[1]);
  const integer z = type.raw(words[2]);
  const auto sum = [&](const integer& value) { return in_range(type, value, rules.range); };
  const auto product = [&](const integer& value) {
    return in_range(type, reference::round(value, one, rules.multiply), rules.product_range());
  };
  const auto wrong = [&](Operation operation, const reference::result& expected) {
    return differs(format, operation, words, expected);
  };
  if (wrong(Operation::plus, sum(x + y))) return "a + b";
  if (wrong(Operation::minus, sum(x - y))) return "a - b";
  if (wrong(Operation::negate, sum(-x))) return "-a";
  if (wrong(Operation::times, product(x * y))) return "a * b";
  if (wrong(Operation::divide, quotient(type, x, y))) return "a / b";
  if (wrong(Operation::compare, integer((x < y) + 2 * (x == y)))) return "a <=> b";
  if (wrong(Operation::mul_add, product(x * y + z * one))) return "mul_add";
  const integer blend = reference::round(x * one + (y - x) * z, one, rules.multiply);
  if (wrong(Operation::lerp, sum(blend))) return "lerp";
  if (wrong(Operation::dot, product(x * z + y * x + z * z))) return "dot";
  return {};
}

/// The same for functions of one number.
std::string first_wrong(const Format& format, std::uint64_t word) {
  const Type& type = format.type;
  const fixproof::policy& rules = type.rules;
  const integer one = type.one();
  const integer x = type.raw(word);
  const auto whole = [&](rounding rule) {
    return in_range(type, reference::round(x, one, rule) * one, rules.range);
  };
  const auto wrong = [&](Operation operation, const reference::result& expected) {
    return differs(format, operation, {word, 0, 0}, expected);
  };
  const bool to_nearest = rules.multiply != rounding::floor && rules.multiply != rounding::truncate;
  if (wrong(Operation::floor, whole(rounding::floor))) return "floor";
  if (wrong(Operation::trunc, whole(rounding::truncate))) return "trunc";
  if (wrong(Operation::round, whole(to_nearest ? rules.multiply : rounding::half_up)))
    return "round";
  const auto ceiling = in_range(type, -reference::below(-x, one) * one, rules.range);
  if (wrong(Operation::ceil, ceiling)) return "ceil";
  if (wrong(Operation::abs, in_range(type, x < 0 ? -x : x, rules.range))) return "abs";
  reference::result expected = integer(0);
  // Roots saturate under policies that wrap.
  const bool traps = rules.range == overflow::trap;
  if (x >= 0) {
    expected =
        in_range(type, reference::root(x * one), traps ? overflow::trap : overflow::saturate);
  }
  if (x < 0 && traps) expected = std::nullopt;
  if (wrong(Operation::sqrt, expected)) return "sqrt";
  const std::uint64_t to_integer = format.compute(Operation::to_integer, {word, 0, 0});
  const Type words = Type::of<fixproof::number<std::uint64_t, 0>>();
  if (integer(to_integer) != words.wrapped(reference::round(x, one, rounding::truncate)))
    return "operator int64_t";
  return {};
}

/// The same for a number and an integer.
std::string first_wrong(const Format& format, const IntegerType& with, std::uint64_t number,
                        std::uint64_t word) {
  const Type& type = format.type;
  const fixproof::policy& rules = type.rules;
  const integer x = type.raw(number);
  // Low bits, as a conversion to the integer type leaves them.
  const integer i = with.type.wrapped(integer(word));
  const integer y = i * type.one();
  const auto sum = [&](const integer& value) { return in_range(type, value, rules.range); };
  const auto wrong = [&](WithInteger operation, const reference::result& expected) {
    return reference::outcome_of([&] { return type.raw(with.compute(operation, number, word)); }) !=
           expected;
  };
  if (wrong(WithInteger::conversion, sum(y))) return "conversion";
  if (wrong(WithInteger::plus, sum(x + y))) return "a + i";
  if (wrong(WithInteger::minus, sum(x - y))) return "a - i";
  if (wrong(WithInteger::minus_a, sum(y - x))) return "i - a";
  if (wrong(WithInteger::times_a, in_range(type, x * i, rules.product_range()))) return "i * a";
  if (wrong(WithInteger::divide, quotient(type, x, y))) return "a / i";
  if (wrong(WithInteger::compare, integer((x < y) + 2 * (x == y) + 4 * (y < x)))) return "a <=> i";
  return {};
}

/// A number for messages.
std::string text(const Format& format, std::uint64_t word) {
  return "raw " + format.type.raw(word).str();
}
std::string text(const Format& format, const std::array<std::uint64_t, 3>& words) {
  return text(format, words[0]) + ", " + text(format, words[1]) + ", " + text(format, words[2]);
}

const auto narrow = each_type::all<Format>(formats::narrow());
const auto wide = each_type::all<Format>(formats::wide());

TEST_OF_EACH(NarrowFormats, EveryPair, Format, narrow) {
  for (std::uint64_t i = 0; i < 256; ++i) {
    const std::uint64_t a = type.type.extended(i);
    ASSERT_EQ(first_wrong(type, a), "") << text(type, a);
    for (std::uint64_t k = 0; k < 256; ++k) {
      const std::array words{a, type.type.extended(k), type.type.extended(i * 7 + k * 3)};
      ASSERT_EQ(first_wrong(type, words), "") << text(type, words);
    }
  }
}

/// Words whose bits above the type's are those of its sign.
std::vector<std::uint64_t> operands(const Type& type, int random_count) {
  std::vector<std::uint64_t> all = reference::words(type.bits(), random_count);
  for (std::uint64_t& word : all) word = type.extended(word);
  return all;
}

TEST_OF_EACH(WideFormats, EdgesAndRandomNumbers, Format, wide) {
  const auto values = operands(type.type, 60);
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASSERT_EQ(first_wrong(type, values[i]), "") << text(type, values[i]);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const std::array words{values[i], values[k], values[(i * 7 + k * 3) % values.size()]};
      ASSERT_EQ(first_wrong(type, words), "") << text(type, words);
    }
  }
}

TEST_OF_EACH(WideFormats, EveryTripleOfEnds, Format, wide) {
  const std::uint64_t top = std::uint64_t{1} << (type.type.bits() - 1);
  const std::uint64_t lowest = type.type.is_signed ? type.type.extended(top) : 0;
  const std::uint64_t highest = type.type.is_signed ? top - 1 : top - 1 + top;
  const std::array ends{lowest, highest, std::uint64_t{0}, lowest + 1, highest - 1};
  for (const std::uint64_t a : ends) {
    for (const std::uint64_t b : ends) {
      for (const std::uint64_t c : ends) {
        const std::array words{a, b, c};
        ASSERT_EQ(first_wrong(type, words), "") << text(type, words);
      }
    }
  }
}

TEST_OF_EACH(WideFormats, Integers, Format, wide) {
  const auto some_integers = reference::words(64, 30);
  for (const std::uint64_t a : operands(type.type, 30)) {
    for (const std::uint64_t i : some_integers) {
      for (const IntegerType& with : type.integers) {
        ASSERT_EQ(first_wrong(type, with, a, i), "")
            << text(type, a) << ", " << with.type.wrapped(integer(i));
      }
    }
  }
}

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

}  // namespace
