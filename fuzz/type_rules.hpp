/// @file
/// Checks every operation of the type against the oracle under policies that the parties do not
/// cover, including saturating and trapping ones.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace fixproof::fuzz {

/// Describes the first operation on a, b and c that differs from the oracle, under one policy that
/// c chooses, in 16.16 or, with the low halves, in 8.8.
std::optional<std::string> type_difference(std::span<const std::uint32_t, 3> words);

/// The same for n / d under every policy.
std::optional<std::string> quotient_difference(std::uint32_t n, std::uint32_t d);

}  // namespace fixproof::fuzz
