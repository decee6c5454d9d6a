/// Tests every operator and function of every format against exact integers: all pairs of 8-bit
/// numbers, edges and random numbers of the others.
#include <array>
#include <cstdint>
#include <limits>
#include <string>

#include "fixed/fixed.hpp"
#include "tests/fixed/formats/reference.hpp"
#include "tests/fixed/formats/types.hpp"
#include "tests/support/test.hpp"

namespace {

using fixproof::rounding;
using reference::integer;

/// The name of the first operation on a, b and c with a wrong result, or nothing.
template <class N>
std::string first_wrong(N a, N b, N c) {
  using namespace reference;  // NOLINT(google-build-using-namespace)
  const integer x = raw(a);
  const integer y = raw(b);
  const integer z = raw(c);
  constexpr fixproof::policy rules = N::rules;
  const auto sum = [&](const integer& value) { return in_range<N>(value, rules.range); };
  const auto product = [&](const integer& value) {
    return in_range<N>(round(value, one<N>(), rules.multiply), rules.product_range());
  };
  if (outcome([&] { return a + b; }) != sum(x + y)) return "a + b";
  if (outcome([&] { return a - b; }) != sum(x - y)) return "a - b";
  if (outcome([&] { return -a; }) != sum(-x)) return "-a";
  if (outcome([&] { return a * b; }) != product(x * y)) return "a * b";
  if (outcome([&] { return a / b; }) != quotient<N>(x, y)) return "a / b";
  if ((a < b) != (x < y) || (a == b) != (x == y)) return "a <=> b";
  if (outcome([&] { return mul_add(a, b, c); }) != product(x * y + z * one<N>())) return "mul_add";
  const auto blend =
      in_range<N>(round(x * one<N>() + (y - x) * z, one<N>(), rules.multiply), rules.range);
  if (outcome([&] { return lerp(a, b, c); }) != blend) return "lerp";
  const std::array<N, 3> left{a, b, c};
  const std::array<N, 3> right{c, a, c};
  if (outcome([&] { return dot(left, right); }) != product(x * z + y * x + z * z)) return "dot";
  return {};
}

/// The same for functions of one number.
template <class N>
std::string first_wrong(N a) {
  using namespace reference;  // NOLINT(google-build-using-namespace)
  constexpr fixproof::policy rules = N::rules;
  const integer x = raw(a);
  const auto whole = [&](rounding rule) {
    return in_range<N>(round(x, one<N>(), rule) * one<N>(), rules.range);
  };
  const bool to_nearest = rules.multiply != rounding::floor && rules.multiply != rounding::truncate;
  if (outcome([&] { return floor(a); }) != whole(rounding::floor)) return "floor";
  if (outcome([&] { return trunc(a); }) != whole(rounding::truncate)) return "trunc";
  if (outcome([&] { return fixproof::round(a); }) !=
      whole(to_nearest ? rules.multiply : rounding::half_up))
    return "round";
  const auto ceiling = in_range<N>(-below(-x, one<N>()) * one<N>(), rules.range);
  if (outcome([&] { return ceil(a); }) != ceiling) return "ceil";
  const integer magnitude = x < 0 ? -x : x;
  if (outcome([&] { return fixproof::abs(a); }) != in_range<N>(magnitude, rules.range))
    return "abs";
  std::optional<integer> expected = integer(0);
  // Roots saturate under policies that wrap.
  const bool traps = rules.range == fixproof::overflow::trap;
  if (x >= 0) {
    expected = in_range<N>(root(x * one<N>()),
                           traps ? fixproof::overflow::trap : fixproof::overflow::saturate);
  }
  if (x < 0 && traps) expected = std::nullopt;
  if (outcome([&] { return sqrt(a); }) != expected) return "sqrt";
  if (integer(static_cast<std::int64_t>(a)) !=
      integer(static_cast<std::int64_t>(static_cast<std::uint64_t>(
          in_range<fixproof::number<std::uint64_t, 0>>(round(x, one<N>(), rounding::truncate),
                                                       fixproof::overflow::wrap)
              .value()))))
    return "operator int64_t";
  return {};
}

/// The same for a number and an integer.
template <class N, class Int>
std::string first_wrong_with(N a, Int i) {
  using namespace reference;  // NOLINT(google-build-using-namespace)
  constexpr fixproof::policy rules = N::rules;
  const integer x = raw(a);
  const integer y = integer(i) * one<N>();
  const auto sum = [&](const integer& value) { return in_range<N>(value, rules.range); };
  if (outcome([&] { return N(i); }) != sum(y)) return "conversion";
  if (outcome([&] { return a + i; }) != sum(x + y)) return "a + i";
  if (outcome([&] { return a - i; }) != sum(x - y)) return "a - i";
  if (outcome([&] { return i - a; }) != sum(y - x)) return "i - a";
  if (outcome([&] { return i * a; }) != in_range<N>(x * integer(i), rules.product_range()))
    return "i * a";
  if (outcome([&] { return a / i; }) != quotient<N>(x, y)) return "a / i";
  if ((a < i) != (x < y) || (a == i) != (x == y) || (i < a) != (y < x)) return "a <=> i";
  return {};
}

template <class N>
class NarrowFormats : public testing::Test {};
TYPED_TEST_SUITE(NarrowFormats, formats::narrow);

TYPED_TEST(NarrowFormats, EveryPair) {
  using N = TypeParam;
  using limits = std::numeric_limits<typename N::raw_type>;
  for (int i = limits::min(); i <= limits::max(); ++i) {
    const N a = N::from_raw(static_cast<typename N::raw_type>(i));
    ASSERT_EQ(first_wrong(a), "") << a;
    for (int k = limits::min(); k <= limits::max(); ++k) {
      const N b = N::from_raw(static_cast<typename N::raw_type>(k));
      const N c = N::from_raw(static_cast<typename N::raw_type>(i * 7 + k * 3));
      ASSERT_EQ(first_wrong(a, b, c), "") << a << ", " << b << ", " << c;
    }
  }
}

template <class N>
class WideFormats : public testing::Test {};
TYPED_TEST_SUITE(WideFormats, formats::wide);

TYPED_TEST(WideFormats, EdgesAndRandomNumbers) {
  const auto values = reference::operands<TypeParam>(60);
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASSERT_EQ(first_wrong(values[i]), "") << values[i];
    for (std::size_t k = 0; k < values.size(); ++k) {
      const TypeParam c = values[(i * 7 + k * 3) % values.size()];
      ASSERT_EQ(first_wrong(values[i], values[k], c), "")
          << values[i] << ", " << values[k] << ", " << c;
    }
  }
}

TYPED_TEST(WideFormats, EveryTripleOfEnds) {
  using limits = std::numeric_limits<TypeParam>;
  const std::array ends{(limits::min)(),
                        limits::lowest(),
                        (limits::max)(),
                        TypeParam(),
                        TypeParam::from_raw(limits::lowest().raw() + 1),
                        TypeParam::from_raw((limits::max)().raw() - 1)};
  for (const TypeParam a : ends) {
    for (const TypeParam b : ends) {
      for (const TypeParam c : ends) {
        ASSERT_EQ(first_wrong(a, b, c), "") << a << ", " << b << ", " << c;
      }
    }
  }
}

TYPED_TEST(WideFormats, Integers) {
  const auto some_integers = reference::operands<fixproof::number<std::int64_t, 0>>(30);
  for (const TypeParam a : reference::operands<TypeParam>(30)) {
    for (const auto i : some_integers) {
      ASSERT_EQ(first_wrong_with(a, i.raw()), "") << a << ", " << i;
      ASSERT_EQ(first_wrong_with(a, static_cast<std::uint64_t>(i.raw())), "") << a << ", " << i;
      ASSERT_EQ(first_wrong_with(a, static_cast<std::int16_t>(i.raw())), "") << a << ", " << i;
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
