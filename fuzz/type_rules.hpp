/// @file
/// What the type does beyond the parties: every operation under policies that no target of
/// FIXED.ASM names, saturating and trapping among them, judged by the oracle.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace fixproof::fuzz {

/// The first operation on a, b and c that is not what the oracle says, in 16.16 or, of the low
/// halves, in 8.8, under one policy, which c chooses.
std::optional<std::string> type_difference(std::span<const std::uint32_t, 3> words);

/// The same of n / d alone, under every policy.
std::optional<std::string> quotient_difference(std::uint32_t n, std::uint32_t d);

}  // namespace fixproof::fuzz
