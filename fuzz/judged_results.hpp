/// @file
/// A random operation, formats and rules, and the verdict of `check` on right results and on one
/// wrong result.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace fixproof::fuzz {

/// Judges what the bytes choose. Rational numbers of another library say what is right. Returns
/// what is wrong with the verdict: an error, right results called wrong, a wrong one called right,
/// or a value that is no word of its format. Empty if nothing is.
std::optional<std::string> judged_results(std::span<const std::uint8_t> bytes);

}  // namespace fixproof::fuzz
