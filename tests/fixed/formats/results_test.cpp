/// Tests the functions whose result has a format of its own against exact integers: a set of
/// formats for the results with each of the same formats for the operands, and each rule of a
/// policy.
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "fixed/fixed.hpp"
#include "tests/fixed/formats/reference.hpp"
#include "tests/fixed/formats/types.hpp"
#include "tests/support/test.hpp"

namespace results_test {

using fixproof::number;
using fixproof::overflow;
using fixproof::rounding;
using reference::integer;
using reference::number_of;
using reference::Returned;
using reference::Type;
using reference::Word;
using reference::word_of;

/// The functions, of x and z in one format and y in another.
enum class Function { sqrt, hypot, hypot3, dot, accumulator };
constexpr std::array names{"sqrt<To>(x)", "hypot<To>(x, y)", "hypot<To>(x, y, z)",
                           "dot<To>({x, z}, {y, y})", "accumulator::result<To>()"};

/// The function with a result in To, of operands in A and B.
template <class To, class A, class B>
Word call(Function function, Word x, Word y, Word z) {
  const auto a = number_of<A>(x);
  const auto b = number_of<B>(y);
  const auto c = number_of<A>(z);
  if (function == Function::sqrt) return word_of(sqrt<To>(a));
  if (function == Function::hypot) return word_of(hypot<To>(a, b));
  if (function == Function::hypot3) return word_of(hypot<To>(a, b, c));
  if (function == Function::dot) {
    return word_of(dot<To>(std::array<A, 2>{a, c}, std::array<B, 3>{b, b, b}));
  }
  fixproof::accumulator<A> sum;
  sum.add(a).add_product(a, c).subtract(c).subtract_product(c, c);
  return word_of(sum.template result<To>());
}

/// What is known of the formats at run time.
struct Calls {
  Type to;
  Type a;
  Type b;
  Word (*call)(Function function, Word x, Word y, Word z);

  template <class To, class A, class B>
  static Calls of() {
    return {Type::of<To>(), Type::of<A>(), Type::of<B>(), results_test::call<To, A, B>};
  }
};

/// The root of n / 2^places in units of the type, to nearest.
Returned nearest_root(const Type& to, const integer& n, int places) {
  const integer numerator = n * to.one * to.one;
  const integer denominator = reference::power(2, places);
  const integer floor = floor_root(numerator / denominator);
  const integer twice = 2 * floor + 1;
  const integer half = twice * twice * denominator;
  const integer exact = 4 * numerator;
  const bool goes_up =
      half < exact ||
      (half == exact && (to.rules.multiply != rounding::half_even || floor % 2 != 0));
  const bool traps = to.rules.range == overflow::trap;
  return in_range(to, goes_up ? floor + 1 : floor, traps ? overflow::trap : overflow::saturate);
}

/// The sum / 2^places in units of the type.
Returned rounded_sum(const Type& to, const integer& sum, int places) {
  const integer denominator = reference::power(2, places);
  return in_range(to, reference::round(sum * to.one, denominator, to.rules.multiply),
                  to.rules.product_range());
}

Returned expected(Function function, const Calls& calls, const integer& x, const integer& y,
                  const integer& z) {
  const int a = calls.a.fraction_bits;
  const int b = calls.b.fraction_bits;
  if (function == Function::sqrt) {
    if (x >= 0) return nearest_root(calls.to, x, a);
    return calls.to.rules.range == overflow::trap ? Returned() : integer(0);
  }
  if (function == Function::dot) return rounded_sum(calls.to, x * y + z * y, a + b);
  if (function == Function::accumulator) {
    return rounded_sum(calls.to, (x - z) * calls.a.one + x * z - z * z, 2 * a);
  }
  // In units of 2^-(a + b).
  integer sum = x * x * calls.b.one * calls.b.one + y * y * calls.a.one * calls.a.one;
  if (function == Function::hypot3) sum += z * z * calls.b.one * calls.b.one;
  return nearest_root(calls.to, sum, 2 * (a + b));
}

/// The words of x, y and z.
using Words = std::array<Word, 3>;

/// The whole multiple of 2^exponent in each format, if the formats have all of them.
void add_multiple(std::vector<Words>& words, const Calls& calls, const std::array<int, 3>& of,
                  int exponent) {
  Words scaled{};
  for (std::size_t i = 0; i < of.size(); ++i) {
    const Type& type = i == 1 ? calls.b : calls.a;
    const integer numerator = of[i] * type.one * reference::power(2, exponent + 128);
    const integer unit = reference::power(2, 128);
    if (numerator % unit != 0 || !type.fits(numerator / unit)) return;
    scaled[i] = type.stored(numerator / unit);
  }
  words.push_back(scaled);
}

/// Edges, random operands, and roots that are ties.
std::vector<Words> operands(const Calls& calls) {
  std::vector<Words> words;
  const auto x = reference::operands(calls.a, 30);
  const auto y = reference::operands(calls.b, 30);
  const auto ends = [](const Type& type) {
    return std::array{type.stored(type.lowest), Word{0}, type.stored(type.highest)};
  };
  for (const Word a : ends(calls.a)) {
    for (const Word b : ends(calls.b)) words.push_back({a, b, a});
  }
  std::mt19937_64 random(71);
  for (int i = 0; i < 400; ++i) {
    words.push_back({x[random() % x.size()], y[random() % y.size()], x[random() % x.size()]});
  }
  // Lengths of 5, 15, 13 and 39 units, and roots of 1 to 7 units: a half of each is a tie.
  for (int exponent = -66; exponent < 64; ++exponent) {
    add_multiple(words, calls, {3, 4, 12}, exponent);
    add_multiple(words, calls, {9, 12, 36}, exponent);
    for (const int square : {1, 9, 25, 49}) add_multiple(words, calls, {square, 0, 0}, exponent);
  }
  return words;
}

/// The first function of x, y and z with a wrong result, or nothing.
std::string first_wrong(const Calls& calls, const Words& words) {
  const integer x = calls.a.value(words[0]);
  const integer y = calls.b.value(words[1]);
  const integer z = calls.a.value(words[2]);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto function = static_cast<Function>(i);
    const auto got =
        reference::outcome([&] { return calls.call(function, words[0], words[1], words[2]); });
    const std::string wrong = difference(calls.to, got, expected(function, calls, x, y, z));
    if (!wrong.empty()) return names[i] + (" is " + wrong);
  }
  return {};
}

void expect_exact(const std::vector<Calls>& all) {
  for (const Calls& calls : all) {
    for (const Words& words : operands(calls)) {
      ASSERT_EQ(first_wrong(calls, words), "")
          << calls.to << "; x and z: " << listed(calls.a, {words[0], words[2]})
          << "; y: " << listed(calls.b, {words[1]});
    }
  }
}

using Formats = std::tuple<
    number<std::int8_t, 0, formats::even_saturate>, number<std::int8_t, 8>,
    number<std::uint8_t, 4, formats::away_trap>,
    number<std::int16_t, 15, formats::truncate_saturate>, number<std::uint16_t, 16, formats::mixed>,
    number<std::int32_t, 16, formats::even_saturate>, number<std::int32_t, 30>,
    number<std::uint32_t, 32, formats::even_saturate>, number<std::int64_t, 0, formats::away_trap>,
    number<std::int64_t, 63, formats::floor_wrap>,
    number<std::uint64_t, 64, formats::even_saturate>>;
constexpr std::size_t count = std::tuple_size_v<Formats>;
template <std::size_t I>
using Format = std::tuple_element_t<I % count, Formats>;

/// One format of the results with each format of x. The format of y differs from row to row.
template <std::size_t To, std::size_t... A>
std::vector<Calls> row(std::index_sequence<A...> /*of*/) {
  return {Calls::of<Format<To>, Format<A>, Format<A + To>>()...};
}
template <std::size_t... To>
std::vector<std::vector<Calls>> rows(std::index_sequence<To...> of) {
  return {row<To>(of)...};
}

TEST(ResultsInOtherFormats, OfEachFormatFromEach) {
  for (const auto& calls : rows(std::make_index_sequence<count>())) expect_exact(calls);
}

TEST(ResultsInOtherFormats, UnderEachPolicy) {
  using namespace fixproof::policies;
  using q2_30 = number<std::int32_t, 30>;
  using u0_64 = number<std::uint64_t, 64>;
  const auto under = []<fixproof::policy... P>() {
    return std::vector{Calls::of<number<std::int16_t, 8, P>, q2_30, u0_64>()...};
  };
  expect_exact(under.operator()<wrapping, saturating, trapping, i386_rounded, i386_unrounded,
                                i8088_mul_rounded, i8088_unrounded, formats::even_saturate,
                                formats::away_trap, formats::truncate_saturate, formats::floor_wrap,
                                formats::mixed>());
}

using fixproof::accumulator;
using fixproof::q16_16;
using fixproof::q16_16_trapping;
using fixproof::q1_31;
using fixproof::q2_30;
using fixproof::q8_8;

// Worked by hand. hypot of q1_31 itself saturates.
static_assert(hypot<q2_30>(q1_31(-1), q1_31(-1)).raw() == 1518500250);  // 1518500249.99
static_assert(hypot(q1_31(-1), q1_31(-1)) == std::numeric_limits<q1_31>::max());
static_assert(sqrt<q16_16>(fixproof::q48_16(std::int64_t{1} << 40)) ==
              std::numeric_limits<q16_16>::max());
// 3/2 and 5/2 units of 8.8.
using q8_8_even = fixproof::with_policy<q8_8, formats::even_saturate>;
static_assert(hypot<q8_8>(q16_16::from_raw(384), q16_16()).raw() == 2 &&
              hypot<q8_8>(q16_16::from_raw(640), q16_16()).raw() == 3);
static_assert(hypot<q8_8_even>(q16_16::from_raw(384), q16_16()).raw() == 2 &&
              hypot<q8_8_even>(q16_16::from_raw(640), q16_16()).raw() == 2);
static_assert(hypot<q8_8_even>(q16_16::from_raw(640), q16_16::from_raw(1)).raw() == 3);

// The policy of the result decides whether a call throws.
template <class To>
constexpr bool throws_out_of_range =
    !noexcept(sqrt<To>(q8_8())) && !noexcept(hypot<To>(q8_8(), q8_8())) &&
    !noexcept(hypot<To>(q8_8(), q8_8(), q8_8()));
template <class To>
constexpr bool throws_for_products =
    !noexcept(dot<To>(std::array<q8_8, 1>(), std::array<q8_8, 1>())) &&
    !noexcept(accumulator<q8_8>().result<To>());
using products_wrap = number<std::int32_t, 16, formats::mixed>;
static_assert(throws_out_of_range<q16_16_trapping> && throws_for_products<q16_16_trapping>);
static_assert(throws_out_of_range<products_wrap> && !throws_for_products<products_wrap>);
static_assert(!throws_out_of_range<q16_16> && !throws_for_products<q16_16>);

// The name of a result is a number type, and operands of other types stay refused.
template <class To, class... Operands>
constexpr bool has_hypot = requires(Operands... of) {
  fixproof::hypot<To>(of...);
};
static_assert(has_hypot<q16_16, q8_8, q8_8> && has_hypot<q16_16, q16_16, q8_8, q2_30>);
static_assert(!has_hypot<int, q8_8, q8_8> && !has_hypot<q16_16, q8_8, int>);
template <class... Operands>
constexpr bool has_plain_hypot = requires(Operands... of) {
  fixproof::hypot(of...);
};
static_assert(has_plain_hypot<q8_8, q8_8> && !has_plain_hypot<q8_8, q16_16>);

TEST(ResultsInOtherFormats, ErrorsNameTheOperands) {
  const auto text = [](const auto& call) {
    try {
      call();
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  using To = number<std::int8_t, 4, fixproof::policies::trapping>;
  EXPECT_EQ(text([] { return hypot<To>(q16_16(9), q8_8(-12.5)); }),
            "fixed-point overflow: hypot(9, -12.5)");
  EXPECT_EQ(text([] { return hypot<To>(q16_16(9), q8_8(-12.5), q2_30(1)); }),
            "fixed-point overflow: hypot(9, -12.5, 1)");
  EXPECT_EQ(text([] { return sqrt<To>(q16_16(64)); }), "fixed-point overflow: sqrt(64)");
  EXPECT_EQ(text([] { return sqrt<To>(q16_16(-0.5)); }), "fixed-point domain error: sqrt(-0.5)");
  EXPECT_EQ(text([] {
              return dot<To>(std::array{q16_16(3), q16_16(1)}, std::array{q8_8(4)});
            }),
            "fixed-point overflow: dot(1 terms)");
  EXPECT_EQ(text([] { return accumulator<q8_8>().add(q8_8(8)).result<To>(); }),
            "fixed-point overflow: accumulator::result");
}

}  // namespace results_test
