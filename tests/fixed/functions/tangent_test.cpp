/// Tests tangents next to their poles, in every format of 32 bits and some of 8 and 16, and under
/// every rule for results out of range in some of them.
#include <utility>

#include "fixed/formats.hpp"
#include "fixed/trigonometry.hpp"
#include "oracle/function.hpp"
#include "tests/support/each_type.hpp"
#include "tests/support/thrown.hpp"

namespace tangent_test {

using namespace fixproof;
using oracle::Function;
using oracle::Integer;

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

template <class N>
std::int64_t tangent_of(Function tangent, std::int64_t word) {
  const N x = N::from_raw(static_cast<typename N::raw_type>(word));
  return (tangent == Function::tan              ? tan(x)
          : tangent == Function::tan_of_degrees ? tan_of_degrees(x)
                                                : tan_of_turns(x))
      .raw();
}

/// A format, and what computes tangents of its stored integers under each rule for results out of
/// range. Formats that stand for no other have only the first.
struct Format {
  using Compute = std::int64_t (*)(Function tangent, std::int64_t word);

  std::int64_t lowest;
  std::int64_t highest;
  int fraction_bits;
  Compute wrapping;
  Compute saturating = nullptr;
  Compute trapping = nullptr;
};

/// The results under the rules for results out of range: all of them in formats that stand for
/// others.
void expect_nearest(const Format& format, Function tangent, std::int64_t word) {
  const auto exact =
      oracle::nearest(tangent, word, 0, format.fraction_bits, oracle::Rounding::half_up);
  const std::int64_t in_range = exact && *exact < format.lowest ? format.lowest
                                : !exact || *exact > format.highest
                                    ? format.highest
                                    : static_cast<std::int64_t>(*exact);
  ASSERT_EQ(format.wrapping(tangent, word), in_range);
  if (format.saturating == nullptr) return;
  ASSERT_EQ(format.saturating(tangent, word), in_range);
  std::int64_t result = 0;
  const Thrown thrown = thrown_by([&] { result = format.trapping(tangent, word); });
  ASSERT_EQ(thrown, !exact               ? Thrown::domain_error
                    : *exact != in_range ? Thrown::overflow_error
                                         : Thrown::nothing);
  if (thrown == Thrown::nothing) {
    ASSERT_EQ(result, in_range);
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
void expect_nearest_at_poles(const Format& format, Function tangent) {
  for (const int sign : {1, -1}) {
    const Integer end = sign < 0 ? -Integer(format.lowest) : Integer(format.highest);
    for (const Integer& place :
         words_at_poles(quarter_turn(tangent) << format.fraction_bits, end)) {
      for (int off = -1; off <= 2; ++off) {
        const Integer word = sign * (place + off);
        if (word < format.lowest || word > format.highest) continue;
        ASSERT_NO_FATAL_FAILURE(expect_nearest(format, tangent, static_cast<std::int64_t>(word)))
            << "function " << static_cast<int>(tangent) << " of " << word << " with "
            << format.fraction_bits << " fraction bits";
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
void add_format(std::vector<Format>& formats) {
  using limits = std::numeric_limits<Raw>;
  if constexpr (stands_for_others<Raw, F>()) {
    formats.push_back({limits::min(), limits::max(), F, tangent_of<wrapping<Raw, F>>,
                       tangent_of<saturating<Raw, F>>, tangent_of<trapping<Raw, F>>});
  } else if constexpr (has_all_formats<Raw>) {
    formats.push_back({limits::min(), limits::max(), F, tangent_of<wrapping<Raw, F>>});
  }
}

/// The formats with one type of stored integers.
struct Formats {
  std::vector<Format> formats;

  template <class Raw>
  static Formats of() {
    return with<Raw>(std::make_integer_sequence<int, 8 * sizeof(Raw) + 1>());
  }
  template <class Raw, int... F>
  static Formats with(std::integer_sequence<int, F...> /*fraction_bits*/) {
    Formats all;
    (add_format<Raw, F>(all.formats), ...);
    return all;
  }
};
const auto every_format =
    each_type::all<Formats>(testing::Types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t,
                                           std::int32_t, std::uint32_t>());

TEST_OF_EACH(NextToPoles, TangentsAreNearest, Formats, every_format) {
  for (const Format& format : type.formats) {
    for (const Function tangent :
         {Function::tan, Function::tan_of_degrees, Function::tan_of_turns}) {
      expect_nearest_at_poles(format, tangent);
    }
  }
}

}  // namespace tangent_test
