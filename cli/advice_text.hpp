/// @file
/// Text output of `fixproof advise`.
#pragma once

#include <string>

#include "trade/advice/advice.hpp"

namespace fixproof::cli {

/// Returns a table with one row per choice, cheapest first.
std::string table_of(const trade::AdviceReport& report);

std::string sentences_of(const trade::AdviceReport& report);

}  // namespace fixproof::cli
