/// @file
/// Maps a build to the number type with the same rules.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <type_traits>

#include "fixed/number.hpp"
#include "fixed/version.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::parties {

/// Returns the version of the number type.
inline std::string fixed_version() {
  return fmt::format("fixed {}.{}.{}", FIXED_VERSION_MAJOR, FIXED_VERSION_MINOR,
                     FIXED_VERSION_PATCH);
}

/// Returns the policy whose results are bit-identical to those of a build.
constexpr fixproof::policy policy_of(const cases::Build& build) {
  namespace p = fixproof::policies;
  const auto choose = [&build](const fixproof::policy& both, const fixproof::policy& mul_only,
                               const fixproof::policy& div_only, const fixproof::policy& neither) {
    if (build.mul_round) return build.div_round ? both : mul_only;
    return build.div_round ? div_only : neither;
  };
  switch (build.target) {
    case cases::Target::i386:
      return choose(p::i386_rounded, p::i386_mul_rounded, p::i386_div_rounded, p::i386_unrounded);
    case cases::Target::i8088:
      return choose(p::i8088_rounded, p::i8088_mul_rounded, p::i8088_div_rounded,
                    p::i8088_unrounded);
    case cases::Target::standard:
      break;
  }
  return p::wrapping;
}

template <cases::Build build, int fraction_bits = 16>
using NumberOf =
    fixproof::number<std::conditional_t<fraction_bits == 16, std::int32_t, std::int16_t>,
                     fraction_bits, policy_of(build)>;

/// Calls call.operator()<B>(), where B has the target and the roundings of `build`. B omits the
/// chapter and the repair, because they change ConcatXforms but not the numbers.
template <class Call>
decltype(auto) with_build(const cases::Build& build, const Call& call) {
  using cases::Build;
  using enum cases::Target;
  const auto with_target = [&]<cases::Target target>() -> decltype(auto) {
    if (build.mul_round) {
      return build.div_round ? call.template operator()<Build{target, true, true}>()
                             : call.template operator()<Build{target, true, false}>();
    }
    return build.div_round ? call.template operator()<Build{target, false, true}>()
                           : call.template operator()<Build{target, false, false}>();
  };
  switch (build.target) {
    case i386:
      return with_target.template operator()<i386>();
    case i8088:
      return with_target.template operator()<i8088>();
    case standard:
      break;
  }
  return call.template operator()<Build{standard}>();
}

/// Calls call(std::type_identity<N>()), where N is the type with the rules of `build`.
template <int fraction_bits = 16, class Call>
decltype(auto) with_number(const cases::Build& build, const Call& call) {
  return with_build(build, [&]<cases::Build constant>() -> decltype(auto) {
    return call(std::type_identity<NumberOf<constant, fraction_bits>>());
  });
}

/// Does the same at the width of a variant.
template <class Call>
void with_number(const cases::Variant& v, const Call& call) {
  v.format == cases::q8_8 ? with_number<8>(v.build, call) : with_number<16>(v.build, call);
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
