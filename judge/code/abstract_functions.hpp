/// @file
/// The abstract functions of 64-bit code: products and quotients of whole registers, whose exact
/// values need more than the 64 bits of a term. Those of narrower numbers are the functions of
/// x86model/symbolic/domain.hpp.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "verify/proof/specification.hpp"

namespace fixproof::judge {

// Of two arguments: the halves of a product. The low half is that of signed and unsigned numbers.
inline constexpr const char* low_product_64 = "mullo64";
inline constexpr const char* unsigned_high_product_64 = "umulh64";
inline constexpr const char* signed_high_product_64 = "smulh64";

// Of two arguments: quotient and remainder of a dividend of 64 bits, signed and unsigned.
inline constexpr const char* quotient_64 = "squot64";
inline constexpr const char* remainder_64 = "srest64";
inline constexpr const char* unsigned_quotient_64 = "uquot64";
inline constexpr const char* unsigned_remainder_64 = "urest64";

// Of three arguments, the halves of a dividend of 128 bits and a divisor: quotient, remainder, and
// whether IDIV faults. DIV faults if the upper half is not below the divisor, which needs no name.
inline constexpr const char* unsigned_quotient_128 = "udiv128";
inline constexpr const char* unsigned_remainder_128 = "urem128";
inline constexpr const char* signed_quotient_128 = "sdiv128";
inline constexpr const char* signed_remainder_128 = "srem128";
inline constexpr const char* signed_quotient_overflows_128 = "sfault128";

/// Returns their values, those of x86model::symbolic::concrete() too. A quotient or remainder is 0
/// where the divide faults.
std::uint64_t concrete_function(const std::string& name, std::span<const std::uint64_t> arguments);

/// Returns their declarations in SMT-LIB, or in exact arithmetic their definitions. Those of
/// x86model::symbolic::concrete() are in proof::abstractions().
std::string declare_functions(proof::Arithmetic arithmetic);

}  // namespace fixproof::judge
