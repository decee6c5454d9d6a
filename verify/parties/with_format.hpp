/// @file
/// Finds the type of a named format.
#pragma once

#include <cstdint>
#include <type_traits>

#include "fixed/fixed.hpp"
#include "fixed/formats.hpp"
#include "verify/cases/format.hpp"

namespace fixproof::parties {

template <class... Numbers>
struct NumberList {};

/// The formats that fixed/formats.hpp names, in the order of cases::named_formats().
using NamedNumbers = NumberList<q8_0, q4_4, q1_7, u4_4, u0_8, q12_4, q8_8, q4_12, q2_14, q1_15,
                                u8_8, u1_15, u0_16, q32_0, q26_6, q24_8, q20_12, q16_16, q8_24,
                                q4_28, q2_30, q1_31, u24_8, u16_16, u8_24, u1_31, u0_32, q48_16,
                                q40_24, q32_32, q16_48, q2_62, q1_63, u48_16, u32_32, u0_64>;

template <class Number>
constexpr cases::Format format_of() {
  using Raw = typename Number::raw_type;
  return {.word_bits = static_cast<int>(8 * sizeof(Raw)),
          .fraction_bits = Number::fraction_bits,
          .is_signed = std::is_signed_v<Raw>};
}

/// Calls `call` with a std::type_identity of the format's type. Returns false if the format has no
/// name.
template <class Call, class... Numbers>
bool with_number_in(const cases::Format& format, const Call& call,
                    NumberList<Numbers...> /*numbers*/) {
  return ((format_of<Numbers>() == format && (call(std::type_identity<Numbers>()), true)) || ...);
}
template <class Call>
bool with_number_in(const cases::Format& format, const Call& call) {
  return with_number_in(format, call, NamedNumbers());
}

/// The number whose word is the low bits of `word`.
template <class Number>
Number number_from(std::uint64_t word) {
  return Number::from_raw(static_cast<typename Number::raw_type>(word));
}

/// The number's word, zero-extended.
template <class Number>
std::uint64_t bits_of(Number x) {
  return static_cast<std::make_unsigned_t<typename Number::raw_type>>(x.raw());
}

}  // namespace fixproof::parties
