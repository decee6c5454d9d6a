/// @file
/// The parties of verify/ over one case: the oracle is the judge.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cases/variant.hpp"
#include "parties/party.hpp"

namespace fixproof::fuzz {

/// Who answers one variant; the oracle comes first.
struct Seat {
  cases::Variant variant;
  std::vector<const parties::Party*> parties;
};

/// A seat for every variant of these operations, multiply and divide at half width too. Parties
/// that are absent from this build, or do not answer a variant, have no place.
std::vector<Seat> seats_of(std::span<const cases::Operation> operations,
                           std::span<const std::string_view> parties);

/// What there is to say where the parties do not all give the oracle's answer: the smallest case
/// that shows it, every answer, and the command that asks for it again. Of `words` the first
/// ones, as many as the operation takes and as low as its operands are wide, are the case.
std::optional<std::string> disagreement(const Seat& seat, std::span<const std::uint32_t> words);

/// The first disagreement of all seats.
std::optional<std::string> disagreement(std::span<const Seat> seats,
                                        std::span<const std::uint32_t> words);

}  // namespace fixproof::fuzz
