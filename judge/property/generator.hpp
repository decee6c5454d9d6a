/// @file
/// RapidCheck generators for numbers.
#pragma once

#include <rapidcheck.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "fixed/number.hpp"
#include "fixed/text.hpp"

namespace fixproof::detail {

/// Raw values where fixed-point arithmetic tends to fail: 0, the ends of the range, one, a half,
/// and the carry out of the fraction, each with its neighbours and both signs.
template <class Raw, int FractionBits>
rc::Gen<Raw> edge_raw() {
  constexpr std::uint64_t one = FractionBits < 64 ? std::uint64_t{1} << (FractionBits % 64) : 0;
  constexpr std::uint64_t half = FractionBits == 0 ? 0 : std::uint64_t{1} << (FractionBits - 1);
  const std::vector<std::uint64_t> edges{
      0, half, one, static_cast<std::uint64_t>(std::numeric_limits<Raw>::max()),
      static_cast<std::uint64_t>(std::numeric_limits<Raw>::min())};
  return rc::gen::apply(
      [](std::uint64_t edge, int step, bool negate) {
        return static_cast<Raw>((negate ? 0 - edge : edge) + static_cast<std::uint64_t>(step));
      },
      rc::gen::elementOf(edges), rc::gen::inRange(-1, 2), rc::gen::arbitrary<bool>());
}

/// A power of two or a neighbour of one, with either sign.
template <class Raw>
rc::Gen<Raw> power_raw() {
  return rc::gen::apply(
      [](int bit, int step, bool negate) {
        const std::uint64_t power = std::uint64_t{1} << bit;
        return static_cast<Raw>((negate ? 0 - power : power) + static_cast<std::uint64_t>(step));
      },
      rc::gen::inRange(0, bits_of<Raw>), rc::gen::inRange(-1, 2), rc::gen::arbitrary<bool>());
}

/// Random bits, cut to a random length: uniform in value and in magnitude.
template <class Raw>
rc::Gen<Raw> uniform_raw(int min_dropped, int max_dropped) {
  return rc::gen::apply(
      [](Raw bits, int dropped) { return static_cast<Raw>(bits >> dropped); },
      rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<Raw>())),
      rc::gen::noShrink(rc::gen::inRange(min_dropped, max_dropped + 1)));
}

}  // namespace fixproof::detail

/// Generates numbers, many of them edge cases. They shrink toward zero: first to simpler whole
/// numbers, then in raw units.
template <class Raw, int FractionBits, fixproof::policy P>
struct rc::Arbitrary<fixproof::number<Raw, FractionBits, P>> {
  static Gen<fixproof::number<Raw, FractionBits, P>> arbitrary() {
    using number = fixproof::number<Raw, FractionBits, P>;
    constexpr int bits = std::numeric_limits<Raw>::digits;
    auto raws = gen::weightedOneOf<Raw>(
        {{2, gen::noShrink(fixproof::detail::edge_raw<Raw, FractionBits>())},
         {2, gen::noShrink(fixproof::detail::power_raw<Raw>())},
         {3, fixproof::detail::uniform_raw<Raw>(0, 0)},
         {3, fixproof::detail::uniform_raw<Raw>(0, bits)}});
    return gen::map(gen::shrink(raws, [](Raw value) { return shrink_raw(value); }),
                    [](Raw value) { return number::from_raw(value); });
  }

 private:
  static Seq<Raw> shrink_raw(Raw value) {
    Raw whole = 0;
    if constexpr (FractionBits < std::numeric_limits<Raw>::digits) {
      whole = static_cast<Raw>(value - value % (Raw{1} << FractionBits));
    }
    auto toward_zero = shrink::integral<Raw>(value);
    return whole == value ? toward_zero : seq::concat(seq::just(whole), toward_zero);
  }
};

namespace fixproof {

/// Prints a counterexample: the value and the stored integer.
template <class Raw, int FractionBits, policy P>
void showValue(number<Raw, FractionBits, P> value, std::ostream& out) {
  out << value << " (raw " << value.raw() << ')';
}

}  // namespace fixproof
