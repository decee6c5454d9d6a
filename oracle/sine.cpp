#include "oracle/exact.hpp"
#include "oracle/real.hpp"

namespace oracle {
namespace {

/// Far more than the 33 that separate all 2^32 results from ties.
constexpr int kDigits = 60;

Word angle_in_16_16(Word angle, const Format& format) {
  return static_cast<Word>(wrap(ulps(angle, format) * one(16) / one(format), 16));
}

/// Rounds a result in ulps of 16.16 times 2^kDigits to nearest.
Word nearest(const Integer& scaled, const Format& format) {
  const Integer ulp = Integer(1) << (16 - format.fraction_bits + kDigits);
  return static_cast<Word>(wrap(rounded(scaled, ulp, Rounding::half_up), format));
}

}  // namespace

Word sin(Word angle, const Format& format) {
  const Word wide = angle_in_16_16(angle, format);
  return nearest(scaled_sin_of_radians(wide, kDigits), format);
}

Word cos(Word angle, const Format& format) {
  const Word wide = angle_in_16_16(angle, format);
  return nearest(scaled_cos_of_radians(wide, kDigits), format);
}

}  // namespace oracle
