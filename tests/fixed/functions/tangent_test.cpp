/// Tests tangents next to their poles, in every format of 32 bits and some of 8 and 16, and under
/// every rule for results out of range in some of them.
#include <utility>

#include "tests/fixed/functions/functions.hpp"
#include "tests/support/ending.hpp"

namespace {

using namespace fixproof;
using functions::Function;
using functions::Integer;

template <class Raw, int F>
using wrapping = number<Raw, F, policies::wrapping>;
template <class Raw, int F>
using saturating = number<Raw, F, policies::saturating>;
template <class Raw, int F>
using trapping = number<Raw, F, policies::trapping>;

/// The tangent of a word as a word.
template <class N>
constexpr std::int64_t word_of_tangent(std::int64_t word) {
  return tan(N::from_raw(static_cast<typename N::raw_type>(word))).raw();
}

constexpr std::int64_t highest = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t lowest = std::numeric_limits<std::int32_t>::min();
constexpr std::int64_t all_ones = std::numeric_limits<std::uint32_t>::max();

// The words next to pi/2 = 0x6487ed51.1 * 2^-30. The first is so near that its tangent is above
// 2^33, which is 2^63 of these units.
static_assert(word_of_tangent<q2_30>(0x6487ed51) == highest);
static_assert(word_of_tangent<q2_30>(0x6487ed52) == lowest);
static_assert(word_of_tangent<q2_30>(-0x6487ed51) == lowest);
static_assert(word_of_tangent<q2_30>(-0x6487ed52) == highest);
static_assert(word_of_tangent<saturating<std::int32_t, 30>>(0x6487ed51) == highest);
static_assert(word_of_tangent<saturating<std::int32_t, 30>>(-0x6487ed51) == lowest);
static_assert(word_of_tangent<wrapping<std::uint32_t, 30>>(0x6487ed51) == all_ones);
static_assert(word_of_tangent<wrapping<std::uint32_t, 30>>(0x6487ed52) == 0);
static_assert(word_of_tangent<u1_31>(0xc90fdaa2) == all_ones);
static_assert(word_of_tangent<u1_31>(0xc90fdaa3) == 0);
static_assert(word_of_tangent<saturating<std::uint32_t, 31>>(0xc90fdaa2) == all_ones);

/// pi/2, 90 degrees or 1/4 turn in units of 2^-64.
const Integer& quarter_turn(Function tangent) {
  static const Integer radians("0x1921fb54442d18469");
  static const Integer degrees = Integer(90) << 64;
  static const Integer turns = Integer(1) << 62;
  return tangent == Function::tan ? radians : tangent == Function::tan_of_degrees ? degrees : turns;
}

/// Whether formats with F fraction bits stand for the others of their width.
template <class Raw, int F>
constexpr bool stands_for_others() {
  constexpr int bits = 8 * sizeof(Raw);
  return F == 0 || F == bits / 2 || F >= bits - 2;
}

/// The results under the rules for results out of range: all of them in formats that stand for
/// others. \param compute the tangent, of any format
template <class Raw, int F, class Compute>
void expect_nearest(Function tangent, Raw word, const Compute& compute) {
  using limits = std::numeric_limits<Raw>;
  const auto exact = oracle::nearest(tangent, word, 0, F, oracle::Rounding::half_up);
  const Raw in_range = exact && *exact < limits::min()    ? limits::min()
                       : !exact || *exact > limits::max() ? limits::max()
                                                          : static_cast<Raw>(*exact);
  ASSERT_EQ(compute(wrapping<Raw, F>::from_raw(word)).raw(), in_range);
  if constexpr (stands_for_others<Raw, F>()) {
    ASSERT_EQ(compute(saturating<Raw, F>::from_raw(word)).raw(), in_range);
    trapping<Raw, F> result;
    const Ending ending = ending_of([&] { result = compute(trapping<Raw, F>::from_raw(word)); });
    ASSERT_EQ(ending, !exact               ? Ending::domain_error
                      : *exact != in_range ? Ending::overflow_error
                                           : Ending::value);
    if (ending == Ending::value) {
      ASSERT_EQ(result.raw(), in_range);
    }
  }
}

/// The words below `end` that may be next to a pole. Where there are many poles, these are the
/// first and the last, and those that are nearest to a word.
std::vector<Integer> words_at_poles(const Integer& quarter_ulps, const Integer& end) {
  constexpr int many = 40;
  std::vector<Integer> words;
  const Integer count = ((end << 64) / quarter_ulps + 1) / 2;
  for (Integer i = 0; i < count; ++i) {
    if (i == many && count > 2 * many) i = count - many;
    words.push_back((2 * i + 1) * quarter_ulps >> 64);
  }
  // The numerators of the convergents of a quarter turn in ulps
  Integer a = quarter_ulps;
  Integer b = Integer(1) << 64;
  Integer before = 0;
  for (Integer word = 1; word < end && b != 0;) {
    words.push_back(word);
    const Integer next = a / b * word + before;
    const Integer rest = a % b;
    before = word;
    word = next;
    a = b;
    b = rest;
  }
  return words;
}

/// Words next to the poles of both signs.
template <class Raw, int F, class Compute>
void expect_nearest_at_poles(Function tangent, const Compute& compute) {
  using limits = std::numeric_limits<Raw>;
  for (const int sign : {1, -1}) {
    const Integer end = sign < 0 ? -Integer(limits::min()) : Integer(limits::max());
    for (const Integer& place : words_at_poles(quarter_turn(tangent) << F, end)) {
      for (int off = -1; off <= 2; ++off) {
        const Integer word = sign * (place + off);
        if (word < limits::min() || word > limits::max()) continue;
        ASSERT_NO_FATAL_FAILURE((expect_nearest<Raw, F>(tangent, static_cast<Raw>(word), compute)))
            << "function " << static_cast<int>(tangent) << " of " << word << " with " << F
            << " fraction bits";
      }
    }
  }
}

#ifdef FIXPROOF_FEW_TYPES
// The fraction bits decide what can be out of range, the flags of this program how it is computed.
template <class Raw>
constexpr bool has_all_formats = false;
#else
template <class Raw>
constexpr bool has_all_formats = sizeof(Raw) == 4;
#endif

template <class Raw, int F>
void expect_nearest_at_all_poles() {
  if constexpr (has_all_formats<Raw> || stands_for_others<Raw, F>()) {
    expect_nearest_at_poles<Raw, F>(Function::tan, [](auto x) { return tan(x); });
    expect_nearest_at_poles<Raw, F>(Function::tan_of_degrees,
                                    [](auto x) { return tan_of_degrees(x); });
    expect_nearest_at_poles<Raw, F>(Function::tan_of_turns, [](auto x) { return tan_of_turns(x); });
  }
}

template <class Raw, int... F>
void expect_nearest_in_every_format(std::integer_sequence<int, F...> /*fraction_bits*/) {
  (expect_nearest_at_all_poles<Raw, F>(), ...);
}

template <class Raw>
class NextToPoles : public testing::Test {};
using Words = testing::Types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t,
                             std::uint32_t>;
TYPED_TEST_SUITE(NextToPoles, Words);

TYPED_TEST(NextToPoles, TangentsAreNearest) {
  constexpr int bits = 8 * sizeof(TypeParam);
  expect_nearest_in_every_format<TypeParam>(std::make_integer_sequence<int, bits + 1>());
}

}  // namespace
