/// Tests what generic code sees of every format: traits, common types, atomics, limits, hashes,
/// durations.
#include "fixed/traits.hpp"

#include <atomic>
#include <chrono>
#include <unordered_map>

#include "fixed/fixed.hpp"
#include "tests/fixed/formats/types.hpp"
#include "tests/support/test.hpp"

namespace traits_test {

using namespace fixproof;

static_assert(is_number_v<q16_16> && is_number_v<u0_64> && is_number_v<q8_8_trapping>);
static_assert(is_number_v<const q4_4> && is_number_v<volatile q4_4>);
static_assert(!is_number_v<q16_16&> && !is_number_v<int> && !is_number_v<double>);
static_assert(!is_number_v<std::array<q16_16, 2>> && !is_number_v<sin_and_cos<q16_16>>);
static_assert(any_number<u8_8> && !any_number<unsigned> && !any_number<void>);

template <class... T>
concept have_common_type = requires {
  typename std::common_type<T...>::type;
};

template <class Number>
constexpr bool absorbs_integers() {
  const auto is = []<class... T>(std::type_identity<Number>, std::type_identity<T>...) {
    return (std::same_as<std::common_type_t<Number, T>, Number> && ...) &&
           (std::same_as<std::common_type_t<T, Number>, Number> && ...);
  };
  return is(std::type_identity<Number>(), std::type_identity<Number>(),
            std::type_identity<signed char>(), std::type_identity<unsigned char>(),
            std::type_identity<short>(), std::type_identity<unsigned short>(),
            std::type_identity<int>(), std::type_identity<unsigned>(), std::type_identity<long>(),
            std::type_identity<unsigned long>(), std::type_identity<long long>(),
            std::type_identity<unsigned long long>());
}
static_assert(absorbs_integers<q16_16>() && absorbs_integers<q8_0>() && absorbs_integers<u0_64>());
static_assert(absorbs_integers<q16_16_trapping>() && absorbs_integers<q8_8>());
static_assert(std::same_as<std::common_type_t<const q16_16&, int&&>, q16_16>);
static_assert(std::same_as<std::common_type_t<const q16_16, const int>, q16_16>);
static_assert(std::same_as<std::common_type_t<int, q16_16, long, q16_16>, q16_16>);

template <class Number, class... T>
constexpr bool has_none = (!have_common_type<Number, T> && ...) &&
                          (!have_common_type<T, Number> && ...);
static_assert(has_none<q16_16, q8_8, u16_16, q16_16_saturating, q32_32, q2_30>);
static_assert(has_none<q8_0, q32_0, u0_8>);
static_assert(has_none<q16_16, bool, char, wchar_t, char8_t, char16_t, char32_t, float, double>);
static_assert(has_none<q16_16, std::string, void*, std::nullptr_t>);
static_assert(!have_common_type<q16_16, int, q8_8> && !have_common_type<q16_16, int, double>);

/// What the common type is for: generic code that computes with two types.
template <class A, class B>
std::common_type_t<A, B> average(A a, B b) {
  using result = std::common_type_t<A, B>;
  return (static_cast<result>(a) + static_cast<result>(b)) / 2;
}

TEST(CommonType, ServesGenericCode) {
  EXPECT_EQ(average(q16_16(1.5), 4), q16_16(2.75));
  EXPECT_EQ(average(7, q8_8(0.5)), q8_8(3.75));
}

TEST(CommonType, ServesDurations) {
  using seconds = std::chrono::duration<q32_32>;
  using ticks = std::chrono::duration<q32_32, std::ratio<1, 60>>;
  const seconds second(q32_32(1.5));
  EXPECT_EQ((second + seconds(q32_32(0.25))).count(), q32_32(1.75));
  EXPECT_EQ(std::chrono::duration_cast<ticks>(second).count(), q32_32(90));
  EXPECT_EQ(std::chrono::duration_cast<seconds>(ticks(q32_32(15))).count(), q32_32(0.25));
  EXPECT_LT(ticks(q32_32(89)), second);
}

template <class N>
class Uses : public testing::Test {};
using uses = testing::Types<q8_0, q4_4, u0_8, q8_8, q8_8_trapping, u8_8, q16_16, q16_16_saturating,
                            q2_30, u0_32, q32_32, q48_16, q1_63, u0_64>;
TYPED_TEST_SUITE(Uses, uses);

TYPED_TEST(Uses, Atomics) {
  using N = TypeParam;
  static_assert(std::is_trivially_copyable_v<N> && sizeof(N) == sizeof(typename N::raw_type));
  static_assert(std::atomic<N>::is_always_lock_free);
  std::atomic<N> shared(N::from_raw(5));
  EXPECT_EQ(shared.load().raw(), 5);
  EXPECT_EQ(shared.exchange(N::from_raw(7)).raw(), 5);
  N expected = N::from_raw(5);
  EXPECT_FALSE(shared.compare_exchange_strong(expected, N::from_raw(9)));
  EXPECT_EQ(expected.raw(), 7);
  EXPECT_TRUE(shared.compare_exchange_strong(expected, N::from_raw(9)));
  while (!shared.compare_exchange_weak(expected, N::from_raw(11))) {
  }
  EXPECT_EQ(shared.load().raw(), 11);
}

TYPED_TEST(Uses, Limits) {
  using N = TypeParam;
  using raw = std::numeric_limits<typename N::raw_type>;
  using limits = std::numeric_limits<N>;
  static_assert(limits::is_specialized && limits::is_exact && limits::is_bounded);
  static_assert(limits::is_signed == raw::is_signed && limits::digits == raw::digits);
  static_assert(limits::is_integer == (N::fraction_bits == 0));
  EXPECT_EQ(limits::max().raw(), raw::max());
  EXPECT_EQ(limits::lowest().raw(), raw::min());
  EXPECT_EQ(limits::min().raw(), 1);
  EXPECT_EQ(std::numeric_limits<const N>::max(), limits::max());
}

TYPED_TEST(Uses, HashedAsKeys) {
  using N = TypeParam;
  using raw = typename N::raw_type;
  std::unordered_map<N, int> names;
  for (int i = 0; i < 100; ++i) names[N::from_raw(static_cast<raw>(i))] = i;
  for (int i = 0; i < 100; ++i) names[N::from_raw(static_cast<raw>(i))] += 1000;
  ASSERT_EQ(names.size(), 100U);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(names.at(N::from_raw(static_cast<raw>(i))), 1000 + i);
  EXPECT_FALSE(names.contains(N::from_raw(static_cast<raw>(100))));
  const auto lowest = std::numeric_limits<N>::lowest();
  EXPECT_EQ(std::hash<N>()(lowest), std::hash<N>()(N::from_raw(lowest.raw())));
}

// Whether x op y compiles, to a concept.
template <class A, class B>
concept adds = requires(A a, B b) {
  a + b;
};
template <class A, class B>
concept compares = requires(A a, B b) {
  a < b;
}
|| requires(A a, B b) { a == b; };
template <class A, class B>
concept masks = requires(A a, B b) {
  a& b;
}
|| requires(A a, B b) { a | b; };
template <class A>
concept indexes = requires(A a, int* p) {
  p[a];
}
|| requires(A a) { !a; }
|| requires(A a) { ~a; };
template <class A>
concept has_sine = requires(A a) {
  sin(a);
};
template <class A>
concept has_exponential = requires(A a) {
  fixproof::exp(a);
};
template <class A>
concept makes_raw = requires(A a) {
  q16_16::from_raw(a);
};

TEST(Refused, DoesNotCompileToConcepts) {
  static_assert(adds<q16_16, q16_16> && adds<q16_16, int> && adds<long, q16_16>);
  static_assert(!adds<q16_16, q8_8> && !adds<q16_16, double> && !adds<float, q16_16>);
  static_assert(!adds<q16_16, bool> && !adds<char, q16_16> && !adds<q16_16, q16_16_saturating>);
  static_assert(compares<q16_16, int> && !compares<q16_16, q8_8> && !compares<double, q16_16>);
  static_assert(!masks<q16_16, int> && !masks<q16_16, q16_16> && !indexes<q16_16>);
  static_assert(has_sine<q16_16> && has_sine<q2_30> && has_exponential<q16_16> &&
                !has_exponential<double>);
  static_assert(makes_raw<int> && !makes_raw<double> && !makes_raw<q8_8>);
  static_assert(std::is_constructible_v<q16_16, int> && std::is_constructible_v<q16_16, q8_8>);
  static_assert(!std::is_constructible_v<q16_16, bool> &&
                !std::is_constructible_v<q16_16, const char*>);
  static_assert(!std::is_convertible_v<int, q16_16> && !std::is_convertible_v<double, q16_16>);
  static_assert(!std::is_convertible_v<q8_8, q16_16> && !std::is_convertible_v<q16_16, double>);
  static_assert(!std::is_convertible_v<q16_16, int> && !std::is_constructible_v<bool, q16_16>);
  static_assert(std::is_constructible_v<double, q16_16> && std::is_constructible_v<int, q16_16>);
  static_assert(!std::is_assignable_v<q16_16&, int> && !std::is_assignable_v<q16_16&, q8_8>);
}

}  // namespace traits_test
