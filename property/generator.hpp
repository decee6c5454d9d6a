/// \file
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
template <class Raw>
rc::Gen<Raw> edge_raw() {
  constexpr int fraction_bits = std::numeric_limits<Raw>::digits / 2 + 1;
  constexpr std::int64_t one = std::int64_t{1} << fraction_bits;
  const std::vector<std::int64_t> edges{0, one / 2, one, std::numeric_limits<Raw>::max(),
                                        std::numeric_limits<Raw>::min()};
  return rc::gen::apply(
      [](std::int64_t edge, int step, bool negate) {
        return static_cast<Raw>((negate ? -edge : edge) + step);
      },
      rc::gen::elementOf(edges), rc::gen::inRange(-1, 2), rc::gen::arbitrary<bool>());
}

/// A power of two or a neighbour of one, with either sign.
template <class Raw>
rc::Gen<Raw> power_raw() {
  return rc::gen::apply(
      [](int bit, int step, bool negate) {
        const std::int64_t power = std::int64_t{1} << bit;
        return static_cast<Raw>((negate ? -power : power) + step);
      },
      rc::gen::inRange(0, std::numeric_limits<Raw>::digits + 1), rc::gen::inRange(-1, 2),
      rc::gen::arbitrary<bool>());
}

/// Random bits, cut to a random length: uniform in value and in magnitude.
template <class Raw>
rc::Gen<Raw> uniform_raw(int min_dropped, int max_dropped) {
  constexpr std::int64_t lowest = std::numeric_limits<Raw>::min();
  constexpr std::int64_t beyond = std::int64_t{std::numeric_limits<Raw>::max()} + 1;
  return rc::gen::apply(
      [](std::int64_t bits, int dropped) { return static_cast<Raw>(bits >> dropped); },
      rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(lowest, beyond))),
      rc::gen::noShrink(rc::gen::inRange(min_dropped, max_dropped + 1)));
}

}  // namespace fixproof::detail

/// Generates numbers, many of them edge cases. They shrink toward zero: first to simpler whole
/// numbers, then in raw units.
template <int FractionBits, fixproof::policy P>
struct rc::Arbitrary<fixproof::number<FractionBits, P>> {
  static Gen<fixproof::number<FractionBits, P>> arbitrary() {
    using number = fixproof::number<FractionBits, P>;
    using raw = typename number::raw_type;
    constexpr int bits = std::numeric_limits<raw>::digits;
    auto raws = gen::weightedOneOf<raw>({{2, gen::noShrink(fixproof::detail::edge_raw<raw>())},
                                         {2, gen::noShrink(fixproof::detail::power_raw<raw>())},
                                         {3, fixproof::detail::uniform_raw<raw>(0, 0)},
                                         {3, fixproof::detail::uniform_raw<raw>(0, bits)}});
    return gen::map(gen::shrink(raws, [](raw value) { return shrink_raw(value); }),
                    [](raw value) { return number::from_raw(value); });
  }

 private:
  template <class Raw>
  static Seq<Raw> shrink_raw(Raw value) {
    const auto whole = static_cast<Raw>(value - value % (1 << FractionBits));
    auto toward_zero = shrink::integral<Raw>(value);
    return whole == value ? toward_zero : seq::concat(seq::just(whole), toward_zero);
  }
};

namespace fixproof {

/// Prints a counterexample: the value and the stored integer.
template <int FractionBits, policy P>
void showValue(number<FractionBits, P> value, std::ostream& out) {
  out << value << " (raw " << value.raw() << ')';
}

}  // namespace fixproof
