#include "verify/cases/value.hpp"

#include <cstdlib>

#include "oracle/format.hpp"

namespace fixproof::cases {

oracle::Ratio unit_of(const Format& format) {
  const auto exponent = static_cast<unsigned>(std::abs(format.fraction_bits));
  const oracle::Integer power = pow(oracle::Integer(format.is_decimal ? 10 : 2), exponent);
  return format.fraction_bits < 0 ? oracle::Ratio{power, 1} : oracle::Ratio{1, power};
}

oracle::Ratio value_of(const oracle::Integer& units, const Format& format) {
  const oracle::Ratio unit = unit_of(format);
  return {units * unit.numerator, unit.denominator};
}

oracle::Ratio value_of(std::uint64_t word, const Format& format) {
  return value_of(oracle::ulps(word, format.as<oracle::Format>()), format);
}

oracle::Integer to_ulps(const oracle::Ratio& value, oracle::Rounding rule, const Format& format) {
  const oracle::Ratio unit = unit_of(format);
  return oracle::rounded(value.numerator * unit.denominator, value.denominator * unit.numerator,
                         rule);
}

}  // namespace fixproof::cases
