#include "oracle/whole_function.hpp"

#include "oracle/format.hpp"

namespace oracle {
namespace {

std::optional<Integer> remainder(const Integer& n, const Integer& d, Rounding of_quotient) {
  if (d == 0) return std::nullopt;
  return n - d * rounded(n, d, of_quotient);
}

Integer sum_of_squares(const Integer& x, const Integer& y, const Integer& z) {
  return x * x + y * y + z * z;
}

}  // namespace

std::optional<Integer> truncated_remainder(const Integer& n, const Integer& d) {
  return remainder(n, d, Rounding::truncate);
}

std::optional<Integer> nearest_remainder(const Integer& n, const Integer& d) {
  return remainder(n, d, Rounding::half_even);
}

std::optional<Integer> product_quotient(const Integer& a, const Integer& b, const Integer& c,
                                        Rounding rule) {
  if (c == 0) return std::nullopt;
  return rounded(a * b, c, rule);
}

Integer nearest_length(const Integer& x, const Integer& y, const Integer& z) {
  Integer rest;
  const Integer floor = boost::multiprecision::sqrt(sum_of_squares(x, y, z), rest);
  // The rest is the sum minus floor^2; above the midpoint it exceeds floor + 1/4.
  return rest > floor ? floor + 1 : floor;
}

Ratio length_of(const Integer& x, const Integer& y, const Integer& z) {
  constexpr int precision = 220;
  const Integer sum = sum_of_squares(x, y, z);
  Integer rest;
  const Integer floor = boost::multiprecision::sqrt(sum, rest);
  if (rest == 0) return {floor, 1};
  return {boost::multiprecision::sqrt(sum << 2 * precision), Integer(1) << precision};
}

}  // namespace oracle
