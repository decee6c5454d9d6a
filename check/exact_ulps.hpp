/// @file
/// The exact results of judged operations in ulps, by the oracle.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "cases/format.hpp"
#include "cases/variant.hpp"
#include "oracle/integer.hpp"
#include "oracle/rule.hpp"

namespace fixproof::check {

/// The rounded result in ulps in any format; empty for x / 0 and negative radicands.
/// @throws std::invalid_argument for an operation that is not judged
std::optional<oracle::Integer> exact_ulps(cases::Operation operation, const cases::Format& format,
                                          std::span<const std::uint64_t> words,
                                          oracle::Rounding rule);

/// The same in 16.16, about ten times as fast: a result has less than 49 bits.
std::optional<std::int64_t> narrow_ulps(cases::Operation operation,
                                        std::span<const std::uint64_t> words,
                                        oracle::Rounding rule);

}  // namespace fixproof::check
