/// @file
/// Quotients that are accurate even if a divide uses only a part of its divisor.
#pragma once

#include "xsharp/arithmetic.hpp"

namespace xsharp {

/// Whether twice the number is in range, with a margin.
template <Scalar N>
bool can_be_doubled(N x) {
  const N most = from_whole<N>(8191);
  return -most < x && x < most;
}

/// Doubles both as long as both fit. This does not change the quotient, but a divide that uses only
/// the whole part of its divisor, as on the 8088, then uses nearly all of it.
template <Scalar N>
void double_both(N& n, N& d) {
  for (int i = 0; i < 29 && can_be_doubled(n) && can_be_doubled(d); ++i) {
    n = n + n;
    d = d + d;
  }
}

/// n / d, rounded as the arithmetic's divide rounds; 0 if there is no quotient.
///
/// A dividend not less than the divisor stops the doubling too early; one beyond 8191 prevents it.
/// A divide by the whole part then works like long division: first by the divisor doubled alone,
/// which gives the upper digits of the quotient, doubled back as often; then with the small
/// remainder.
template <Scalar N>
N ratio(N n, N d) {
  const N zero = from_whole<N>(0);
  N upper = zero;
  double_both(n, d);
  // Uses negatives, which have the greater range.
  const auto minus_size = [&zero](N x) { return zero < x ? -x : x; };
  if (Arithmetic<N>::divides_by_whole_part() && !(minus_size(d) < minus_size(n))) {
    N divisor = d;
    int doublings = 0;
    for (; doublings < 29 && can_be_doubled(divisor); ++doublings) divisor = divisor + divisor;
    upper = Arithmetic<N>::divide(n, divisor).value_or(zero);
    const N most = from_whole<N>(16384);
    for (; doublings > 0; --doublings) {
      // Exactly 16384 may be rounded up from less: it wraps, and comes back with the remainder.
      if (upper < -most || upper > most) return zero;
      upper = upper + upper;
    }
    n = n - upper * d;
    double_both(n, d);
  }
  const auto quotient = Arithmetic<N>::divide(n, d);
  return quotient ? upper + *quotient : zero;
}

}  // namespace xsharp
