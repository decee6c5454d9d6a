/// @file
/// Compares the parties on one case and judges them by the oracle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "verify/cases/variant.hpp"
#include "verify/parties/party.hpp"

namespace fixproof::fuzz {

/// The parties for one variant; the oracle comes first.
struct VariantParties {
  cases::Variant variant;
  std::vector<const parties::Party*> parties;
};

/// One entry per variant of these operations; multiply and divide also at half width. Omits parties
/// that this build lacks or that do not answer a variant.
std::vector<VariantParties> parties_by_variant(std::span<const cases::Operation> operations,
                                               std::span<const std::string_view> names);

/// Describes a disagreement with the oracle: the smallest case that shows it, every answer, and the
/// command that reproduces it. Uses the first words that the operation takes, reduced to its
/// operand width.
std::optional<std::string> disagreement(const VariantParties& tested,
                                        std::span<const std::uint32_t> words);

std::optional<std::string> disagreement(std::span<const VariantParties> variants,
                                        std::span<const std::uint32_t> words);

}  // namespace fixproof::fuzz
