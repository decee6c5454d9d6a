/// @file
/// Text output of `fixproof advise`.
#pragma once

#include <cstdint>
#include <string>

#include "measure/trade/advice/advice.hpp"
#include "measure/trade/advice/formats.hpp"

namespace fixproof::cli {

/// Returns a table with one row per choice, cheapest first.
std::string table_of(const trade::AdviceReport& report);

std::string sentences_of(const trade::AdviceReport& report);

/// Returns a table with one row for each number of fraction bits.
std::string table_of(const trade::FormatReport& report);

std::string sentences_of(const trade::FormatReport& report);

/// `twelve cubes: 18,000 frames, 5 min 00 s at 60 frames a second; budget 0.5 pixels.`, and what a
/// pixel is.
std::string scene_line(const std::string& scene, std::uint64_t frames, double budget);

}  // namespace fixproof::cli
