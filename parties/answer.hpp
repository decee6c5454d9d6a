/// @file
/// The answer of one party to one case, and the only comparison of answers.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cases/plan.hpp"
#include "parties/party.hpp"

namespace fixproof::parties {

/// What one party says of one case.
struct Answer {
  Ending ending = Ending::broken;
  std::vector<std::uint32_t> words;  ///< empty unless the case ended in a value

  /// Lower-case hex digits of each word, single spaces between; or DE, or how else it ended.
  [[nodiscard]] std::string text(int word_bits) const;
  friend bool operator==(const Answer&, const Answer&) = default;
};

/// Asks one party one case.
Answer ask(const Party& party, const cases::Variant& variant, std::span<const std::uint32_t> words);

/// Whether the answers of a case are all alike, and a value or #DE: parties that agree on a broken
/// program have verified nothing.
bool agree(std::span<const Answer> answers);

/// The row of `variant`: the candidates that answer it, in their order.
cases::Row row_of(const cases::Variant& variant, std::span<const Party* const> candidates);

}  // namespace fixproof::parties
