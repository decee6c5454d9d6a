/// @file
/// Powers of two and binary logarithms with an error below 2^-170, for the few results that 64 bits
/// cannot round.
///
/// The error is that of less than 200 steps, each below four units of 2^-184.
#pragma once

#include <cstdint>

#include "fixed/detail/function_tables.hpp"
#include "fixed/detail/real.hpp"

namespace fixproof::detail {

/// 2^x for 0 <= x < 1, by the Taylor series of e^(x log 2). The terms after the 44th are below
/// 2^-200.
constexpr real precise_power(const real& x) noexcept {
  const real t = product(x, real_from(real_log_2));
  real sum = real_one;
  for (std::uint32_t n = 44; n > 0; --n) sum = real_one + quotient(product(t, sum), n);
  return sum;
}

/// log2(m / 2^32) for 2^32 <= m < 2^33.
///
/// The natural logarithm of m is 2 atanh(z) with z = (m - 1) / (m + 1) <= 1/3. The terms of its
/// series after z^115 are below 2^-185.
constexpr real precise_logarithm(std::uint64_t m) noexcept {
  constexpr std::uint64_t one = std::uint64_t{1} << 32;
  const real z = ratio(real{m - one}, real{m + one});
  const real square = product(z, z);
  real sum;
  for (std::uint32_t n = 115; n > 1; n -= 2) sum = product(square, quotient(real_one, n) + sum);
  const real natural = product(z << 1, real_one + sum);
  return product(natural, real_from(real_log2_e));
}

}  // namespace fixproof::detail
