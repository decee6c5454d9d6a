/// @file
/// Two numbers and an operation: the exact result, and the word that each rule and each build
/// gives.
#pragma once

#include <string>
#include <string_view>

namespace fixproof::web {

/// @param request four lines: operation, format, first and second number; sqrt ignores the second
/// number
/// @return JSON; `error` says what is wrong with the request
std::string operation_view(std::string_view request);

/// Computes cases by the type's default rules, or by another rounding.
/// @param request a line with operation, format and, for another rounding, its place among `rules`;
/// the place after the last one means the first rule, saturating. Then one case per line, with its
/// words in hexadecimal
/// @return one word per line, or `DE` for a zero divisor; nothing for a malformed request
std::string answers(std::string_view request);

}  // namespace fixproof::web
