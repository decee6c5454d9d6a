/// @file
/// One number in every format.
#pragma once

#include <string>
#include <string_view>

namespace fixproof::web {

/// Returns a number in every format: its word, value, neighbours and error.
/// @param request two lines: the format of a word after 0x or 0b, and the text of the number
/// @return JSON; `error` says what is wrong with the request
std::string number_view(std::string_view request);

}  // namespace fixproof::web
