/// @file
/// A 16.16 number whose arithmetic can be switched while a scene runs.
///
/// One instantiation of the pipeline serves every arithmetic. The type computes every result.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>

#include "fixed/fixed.hpp"
#include "xsharp/arithmetic.hpp"

namespace fixproof::web {

/// The arithmetics, in the order of `arithmetic_names`.
enum class Arithmetic : std::uint8_t {
  i386,
  i386_mul,
  i386_div,
  i386_off,
  i8088,
  i8088_mul,
  i8088_div,
  i8088_off,
  i8088_repaired,
  standard,
  saturating,
};

struct ArithmeticName {
  std::string_view key;   ///< what links say
  std::string_view name;  ///< what people read
};
inline constexpr std::array<ArithmeticName, 11> arithmetic_names{{
    {"i386-on", "386, rounded"},
    {"i386-mul", "386, multiplies rounded"},
    {"i386-div", "386, divides rounded"},
    {"i386-off", "386, not rounded"},
    {"i8088-on", "8088, rounded"},
    {"i8088-mul", "8088, multiplies rounded"},
    {"i8088-div", "8088, divides rounded"},
    {"i8088-off", "8088, not rounded"},
    {"i8088-on-repaired", "8088, rounded, carry repaired"},
    {"q16_16", "q16_16"},
    {"saturating", "q16_16, saturating"},
}};

/// Sets the arithmetic of all switched numbers from now on.
void switch_to(Arithmetic arithmetic);
Arithmetic current_arithmetic();

/// Calls call(std::type_identity<N>()) for the type N of the current arithmetic.
template <class Call>
decltype(auto) with_current(const Call& call) {
  const auto with = [&call]<policy p>() -> decltype(auto) {
    return call(std::type_identity<number<std::int32_t, 16, p>>());
  };
  using namespace policies;
  switch (current_arithmetic()) {
    case Arithmetic::i386:
      return with.template operator()<i386_rounded>();
    case Arithmetic::i386_mul:
      return with.template operator()<i386_mul_rounded>();
    case Arithmetic::i386_div:
      return with.template operator()<i386_div_rounded>();
    case Arithmetic::i386_off:
      return with.template operator()<i386_unrounded>();
    case Arithmetic::i8088:
    case Arithmetic::i8088_repaired:
      return with.template operator()<i8088_rounded>();
    case Arithmetic::i8088_mul:
      return with.template operator()<i8088_mul_rounded>();
    case Arithmetic::i8088_div:
      return with.template operator()<i8088_div_rounded>();
    case Arithmetic::i8088_off:
      return with.template operator()<i8088_unrounded>();
    case Arithmetic::saturating:
      return with.template operator()<saturating>();
    case Arithmetic::standard:
      break;
  }
  return with.template operator()<wrapping>();
}

class SwitchedNumber {
 public:
  constexpr SwitchedNumber() = default;
  static constexpr SwitchedNumber from_raw(std::int32_t raw) {
    SwitchedNumber result;
    result.raw_ = raw;
    return result;
  }
  [[nodiscard]] constexpr std::int32_t raw() const { return raw_; }

  friend SwitchedNumber operator+(SwitchedNumber a, SwitchedNumber b) {
    if (current_arithmetic() == Arithmetic::saturating)
      return of(a.as<q16_16_saturating>() + b.as<q16_16_saturating>());
    return of(a.as<q16_16>() + b.as<q16_16>());
  }
  friend SwitchedNumber operator-(SwitchedNumber a, SwitchedNumber b) {
    if (current_arithmetic() == Arithmetic::saturating)
      return of(a.as<q16_16_saturating>() - b.as<q16_16_saturating>());
    return of(a.as<q16_16>() - b.as<q16_16>());
  }
  SwitchedNumber operator-() const { return SwitchedNumber() - *this; }
  friend SwitchedNumber operator*(SwitchedNumber a, SwitchedNumber b) {
    return with_current(
        [&]<class N>(std::type_identity<N> /*type*/) { return of(a.as<N>() * b.as<N>()); });
  }
  friend constexpr bool operator==(SwitchedNumber, SwitchedNumber) = default;
  friend constexpr auto operator<=>(SwitchedNumber, SwitchedNumber) = default;
  explicit constexpr operator double() const { return raw_ / 65536.0; }

  template <class N>
  [[nodiscard]] constexpr N as() const {
    return N::from_raw(raw_);
  }
  template <class N>
  static constexpr SwitchedNumber of(N x) {
    return from_raw(x.raw());
  }

 private:
  std::int32_t raw_ = 0;
};

}  // namespace fixproof::web

namespace xsharp {

template <>
struct Arithmetic<fixproof::web::SwitchedNumber> {
  using N = fixproof::web::SwitchedNumber;

  static std::int32_t raw(N x) { return x.raw(); }
  static N from_raw(std::int32_t raw) { return N::from_raw(raw); }
  static N constant(double value, Conversion conversion) {
    return N::from_raw(raw_constant(value, conversion));
  }
  static std::optional<N> divide(N n, N d);
  static bool divides_by_whole_part();
  static Turn<N> turn(std::int32_t tenths);
  static N midpoint(N a, N b);
  static Vec3<N> apply(const Transform<N>& t, const Vec3<N>& v);
  static Transform<N> concatenate(const Transform<N>& first, const Transform<N>& second,
                                  Concatenation how);
  static N length(const Vec3<N>& v);
  static N power(N base, N exponent);
};

}  // namespace xsharp
