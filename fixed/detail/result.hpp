/// @file
/// Makes an exact value a number of the type that the caller names.
#pragma once

#include "fixed/detail/overflow.hpp"
#include "fixed/detail/raise.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/number.hpp"

namespace fixproof::detail {

/// The exact value * 2^-FractionBits in units of To, rounded by policy::multiply.
/// @tparam Bits the width of the value
template <class To, int FractionBits, int Bits, class Wide>
constexpr auto rescaled(const Wide& value) noexcept {
  constexpr int up = To::fraction_bits - FractionBits;
  using wide = signed_t<larger(signed_bits<typename To::raw_type>, Bits + larger(up, 1))>;
  return shift_right<To::rules.multiply>(static_cast<wide>(value) << larger(up, 0), larger(-up, 0));
}

/// Applies the rule Overflow to a result in units of To. @pre Wide holds every stored integer of To
template <class To, overflow Overflow, class Wide, class... Operands>
constexpr To narrowed_to(const Wide& value, const char* operation,
                         Operands... operands) noexcept(Overflow != overflow::trap) {
  return To::from_raw(narrow<Overflow, typename To::raw_type>(value, [&] {
    raise<overflow_error>(
        "overflow", operation,
        operand<typename Operands::raw_type, Operands::fraction_bits>{operands.raw()}...);
  }));
}

}  // namespace fixproof::detail
