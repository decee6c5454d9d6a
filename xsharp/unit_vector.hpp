/// @file
/// Unit vectors by the exact length.
#pragma once

#include <concepts>

#include "xsharp/arithmetic.hpp"
#include "xsharp/ratio.hpp"
#include "xsharp/rotation.hpp"
#include "xsharp/transform.hpp"

namespace xsharp {

/// The vector of length 1 with the same direction; 0 stays 0. Any length below 32768 is allowed.
///
/// Doubles the vector until a component is 8191 or more, so that rounding the length to 2^-16
/// changes the quotients by less than 2^-29. Each component is then rounded once, by the
/// arithmetic's divide. A divide by the whole part of the length makes all three components too
/// large by the same factor, which is below 1 + 2^-12; toward_unit() removes it.
template <Scalar N>
Vec3<N> unit_vector(Vec3<N> v) {
  const N zero = from_whole<N>(0);
  if (v == Vec3<N>{zero, zero, zero}) return v;
  if constexpr (!std::floating_point<N>) {
    while (can_be_doubled(v.x) && can_be_doubled(v.y) && can_be_doubled(v.z)) v = v + v;
  }
  const N length = Arithmetic<N>::length(v);
  const auto part = [&](N x) { return Arithmetic<N>::divide(x, length).value_or(zero); };
  const Vec3<N> quotients{part(v.x), part(v.y), part(v.z)};
  return Arithmetic<N>::divides_by_whole_part() ? toward_unit(quotients) : quotients;
}

}  // namespace xsharp
