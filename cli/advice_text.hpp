/// @file
/// The text of `fixproof advise`.
#pragma once

#include <string>

#include "trade/advice/advice.hpp"

namespace fixproof::cli {

/// One row per choice, the cheapest first.
std::string table_of(const trade::AdviceReport& report);

/// The advice in sentences.
std::string sentences_of(const trade::AdviceReport& report);

}  // namespace fixproof::cli
