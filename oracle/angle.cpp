#include "oracle/angle.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <stdexcept>

namespace oracle {

Integer nearest_angle(const Integer& y, const Integer& x, int fraction_bits) {
  using Decimal50 = boost::multiprecision::cpp_bin_float_50;
  if (y == 0 && x >= 0) return 0;
  const Decimal50 angle = atan2(Decimal50(y), Decimal50(x));
  const Decimal50 biased = ldexp(angle, fraction_bits) + 0.5;
  const Decimal50 whole = floor(biased);
  const Decimal50 rest = biased - whole;
  constexpr double uncertain = 0x1p-90;
  if (rest < uncertain || 1 - rest < uncertain) {
    throw std::range_error("an angle is too near a tie for 168 bits");
  }
  return Integer(whole);
}

}  // namespace oracle
