/// @file
/// The number type whose policy is to be bit-identical to a variant.
#pragma once

#include <cstdint>
#include <type_traits>

#include "cases/variant.hpp"
#include "fixed/number.hpp"

namespace fixproof::parties {

namespace with_number_detail {

template <fixed::policy both, fixed::policy mul_only, fixed::policy div_only, fixed::policy neither,
          int bits, class Call>
void with_switches(const cases::Variant& v, const Call& call) {
  if (v.mul_round) {
    v.div_round ? call(std::type_identity<fixed::number<bits, both>>())
                : call(std::type_identity<fixed::number<bits, mul_only>>());
  } else {
    v.div_round ? call(std::type_identity<fixed::number<bits, div_only>>())
                : call(std::type_identity<fixed::number<bits, neither>>());
  }
}

template <int bits, class Call>
void with_policy(const cases::Variant& v, const Call& call) {
  namespace p = fixed::policies;
  switch (v.target) {
    case cases::Target::i386:
      return with_switches<p::i386_rounded, p::i386_mul_rounded, p::i386_div_rounded,
                           p::i386_unrounded, bits>(v, call);
    case cases::Target::i8088:
      return with_switches<p::i8088_rounded, p::i8088_mul_rounded, p::i8088_div_rounded,
                           p::i8088_unrounded, bits>(v, call);
    case cases::Target::standard:
      return call(std::type_identity<fixed::number<bits, p::wrapping>>());
  }
}

}  // namespace with_number_detail

/// call(std::type_identity<N>()), where N is the type that the variant's rules name.
template <class Call>
void with_number(const cases::Variant& v, const Call& call) {
  v.fraction_bits == 8 ? with_number_detail::with_policy<8>(v, call)
                       : with_number_detail::with_policy<16>(v, call);
}

template <class Number>
Number number_of(std::uint32_t word) {
  return Number::from_raw(static_cast<typename Number::raw_type>(word));
}

template <class Number>
std::uint32_t word_of(Number x) {
  return static_cast<std::make_unsigned_t<typename Number::raw_type>>(x.raw());
}

}  // namespace fixproof::parties
