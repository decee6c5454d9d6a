#include "oracle/real.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <stdexcept>

#include "oracle/format.hpp"

namespace oracle {
namespace {

/// 166 bits: more than enough for 16 fraction bits, 60 digits and 15 whole bits of an angle.
using Decimal50 = boost::multiprecision::cpp_bin_float_50;

void require_digits(int digits) {
  if (digits < 0 || digits > 60) throw std::invalid_argument("digits must be 0 ... 60");
}

Integer scaled(const Decimal50& value, int digits) {
  return Integer(floor(ldexp(value, 16 + digits)));
}

Decimal50 radians(Word angle) { return ldexp(Decimal50(ulps(angle, 16)), -16); }

}  // namespace

Integer scaled_sqrt(Word x, int digits) {
  require_digits(digits);
  const Integer value = ulps(x, 16);
  if (value < 0) throw std::domain_error("the square root of a negative number");
  return boost::multiprecision::sqrt(value << (16 + 2 * digits));
}

Integer scaled_cos(std::int32_t angle_tenths, int digits) {
  require_digits(digits);
  // The series is slightly off for the five rational cosines (Niven), whose exact values are known.
  const int turned = (angle_tenths % 3600 + 3600) % 3600;
  Integer unit = Integer(1) << (16 + digits);
  switch (turned) {
    case 0:
      return unit;
    case 600:
    case 3000:
      return unit / 2;
    case 900:
    case 2700:
      return 0;
    case 1200:
    case 2400:
      return -unit / 2;
    case 1800:
      return -unit;
    default:
      break;
  }
  static const Decimal50 pi = acos(Decimal50(-1));
  return scaled(cos(pi * turned / 1800), digits);
}

Integer scaled_sin_of_radians(Word angle, int digits) {
  require_digits(digits);
  return scaled(sin(radians(angle)), digits);
}

Integer scaled_cos_of_radians(Word angle, int digits) {
  require_digits(digits);
  return scaled(cos(radians(angle)), digits);
}

}  // namespace oracle
