/// @file
/// Functions of shared libraries as parties.
#pragma once

#include <string_view>

#include "verify/parties/party.hpp"

namespace fixproof::parties {

/// Tells whether a party's name means a function of a shared library: it has a colon, as in
/// `./libmine.so:my_mul` and `./libmine.so:my_muls[]`.
bool names_function(std::string_view name);

/// Returns the party that calls a function of a shared library, which it loads. The name has two
/// forms, and W is the integer of the format's words, such as int32_t:
///
///     file:function    W function(W a, W b)     one case, with as many operands as the operation
///                      void function(int16_t angle, W* cos, W* sin)    cossin
///                      void function(const W matrix[12], const W operand[], W result[]) xformvec
///                      and concat
///     file:function[]  void function(const W a[], const W b[], W result[], size_t count)
///
/// The library runs in this process. A case whose call divides by zero is a divide error. One that
/// ends in another fault is broken. A function that does not return stops the verification, and
/// one that writes where it must not can do anything: load libraries that you trust.
/// @throws std::invalid_argument naming the file or the function that is not there
const Party& party_of_function(std::string_view name);

}  // namespace fixproof::parties
