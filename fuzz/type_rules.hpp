/// @file
/// Rules of the type that the parties do not cover: every operation under other policies than the
/// FIXED.ASM builds, including saturating and trapping, judged by the oracle.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace fixproof::fuzz {

/// The first operation on a, b and c that differs from the oracle, in 16.16 or, with the low
/// halves, in 8.8, under one policy that c chooses.
std::optional<std::string> type_difference(std::span<const std::uint32_t, 3> words);

/// The same for n / d, under every policy.
std::optional<std::string> quotient_difference(std::uint32_t n, std::uint32_t d);

}  // namespace fixproof::fuzz
