/// @file
/// Two numbers and an operation: the exact result, and where each rule and each build lands.
#pragma once

#include <string>
#include <string_view>

namespace fixproof::web {

/// @param request operation, format, first and second number, on four lines; the second is ignored
/// by sqrt
/// @return JSON; `error` says what is wrong with the request
std::string operation_view(std::string_view request);

/// Answers cases by the type's own rules.
/// @param request operation and format on a line, then one case per line: words as hexadecimal
/// digits
/// @return one word per line, `DE` for a zero divisor; empty for a malformed request
std::string answers(std::string_view request);

}  // namespace fixproof::web
