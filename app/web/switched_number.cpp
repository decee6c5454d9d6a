#include "app/web/switched_number.hpp"

#include <cstddef>
#include <numeric>

namespace fixproof::web {

namespace {

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): numbers have no place for it
Arithmetic current = Arithmetic::i386;

}  // namespace

void switch_to(Arithmetic arithmetic) { current = arithmetic; }

Arithmetic current_arithmetic() { return current; }

}  // namespace fixproof::web

namespace xsharp {

namespace {

using Switched = fixproof::web::SwitchedNumber;

template <class N>
Transform<N> as(const Transform<Switched>& t) {
  Transform<N> result;
  for (std::size_t i = 0; i < 12; ++i) result.rows[i / 4][i % 4] = t.rows[i / 4][i % 4].as<N>();
  return result;
}

}  // namespace

bool Arithmetic<Switched>::divides_by_whole_part() {
  const auto arithmetic = fixproof::web::current_arithmetic();
  return arithmetic >= fixproof::web::Arithmetic::i8088 &&
         arithmetic <= fixproof::web::Arithmetic::i8088_repaired;
}

std::optional<Switched> Arithmetic<Switched>::divide(N n, N d) {
  return fixproof::web::with_current(
      [&]<class T>(std::type_identity<T> /*type*/) -> std::optional<N> {
        const auto quotient = fixproof::try_divide(n.as<T>(), d.as<T>());
        return quotient ? std::optional(N::of(*quotient)) : std::nullopt;
      });
}

Turn<Switched> Arithmetic<Switched>::turn(std::int32_t tenths) {
  const auto [sin, cos] = fixproof::sin_cos_of_tenths<fixproof::q16_16>(tenths);
  return {N::of(cos), N::of(sin)};
}

Switched Arithmetic<Switched>::midpoint(N a, N b) {
  return N::from_raw(std::midpoint(a.raw(), b.raw()));
}

Vec3<Switched> Arithmetic<Switched>::apply(const Transform<N>& t, const Vec3<N>& v) {
  return fixproof::web::with_current([&]<class T>(std::type_identity<T> /*type*/) -> Vec3<N> {
    const auto [x, y, z] = apply_products(as<T>(t), Vec3<T>{v.x.as<T>(), v.y.as<T>(), v.z.as<T>()});
    return {N::of(x), N::of(y), N::of(z)};
  });
}

Transform<Switched> Arithmetic<Switched>::concatenate(const Transform<N>& first,
                                                      const Transform<N>& second,
                                                      Concatenation /*how*/) {
  const auto how = fixproof::web::current_arithmetic() == fixproof::web::Arithmetic::i8088_repaired
                       ? Concatenation::repaired
                       : Concatenation::published;
  return fixproof::web::with_current([&]<class T>(std::type_identity<T> /*type*/) -> Transform<N> {
    const Transform<T> product = Arithmetic<T>::concatenate(as<T>(first), as<T>(second), how);
    Transform<N> result;
    for (std::size_t i = 0; i < 12; ++i)
      result.rows[i / 4][i % 4] = N::of(product.rows[i / 4][i % 4]);
    return result;
  });
}

Switched Arithmetic<Switched>::length(const Vec3<N>& v) {
  return fixproof::web::with_current([&]<class T>(std::type_identity<T> /*type*/) {
    return N::of(Arithmetic<T>::length({v.x.as<T>(), v.y.as<T>(), v.z.as<T>()}));
  });
}

Switched Arithmetic<Switched>::power(N base, N exponent) {
  return fixproof::web::with_current([&]<class T>(std::type_identity<T> /*type*/) {
    return N::of(Arithmetic<T>::power(base.as<T>(), exponent.as<T>()));
  });
}

}  // namespace xsharp
