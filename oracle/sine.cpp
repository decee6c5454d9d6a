#include "oracle/exact.hpp"
#include "oracle/real.hpp"
#include "oracle/unbounded.hpp"

namespace oracle {
namespace {

/// Far more than the 33 that separate all 2^32 results from ties.
constexpr int kDigits = 60;

Word angle_in_16_16(Word angle, int fraction_bits) {
  return wrap(ulps(angle, fraction_bits) * one(16) / one(fraction_bits), 32);
}

/// Rounds a result in ulps of 16.16 times 2^kDigits to nearest.
Word nearest(const Integer& scaled, int fraction_bits) {
  const Integer ulp = Integer(1) << (16 - fraction_bits + kDigits);
  return wrap(rounded(scaled, ulp, Rounding::half_up), word_bits(fraction_bits));
}

}  // namespace

Word sin(Word angle, int fraction_bits) {
  const Word wide = angle_in_16_16(angle, fraction_bits);
  return nearest(scaled_sin_of_radians(wide, kDigits), fraction_bits);
}

Word cos(Word angle, int fraction_bits) {
  const Word wide = angle_in_16_16(angle, fraction_bits);
  return nearest(scaled_cos_of_radians(wide, kDigits), fraction_bits);
}

}  // namespace oracle
