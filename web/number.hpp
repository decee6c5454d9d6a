/// @file
/// One number in every format.
#pragma once

#include <string>
#include <string_view>

namespace fixproof::web {

/// The number that a text says, in every format: its word, value, neighbours and error.
/// @param request the format of words in the text, then the text, on two lines
/// @return JSON; `error` says what is wrong with the request
std::string number_view(std::string_view request);

}  // namespace fixproof::web
