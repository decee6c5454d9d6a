/// @file
/// Answers to single cases, and the only function that compares answers.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "verify/cases/plan.hpp"
#include "verify/parties/party.hpp"

namespace fixproof::parties {

struct Answer {
  Ending ending = Ending::broken;
  std::vector<std::uint32_t> words;  ///< empty unless the case ended in a value

  /// The words in lower-case hex, separated by single spaces. Other endings give DE or a phrase.
  [[nodiscard]] std::string text(int word_bits) const;
};

/// An answer in a buffer of the caller. The words are valid only if the case ended in a value.
struct AnswerView {
  Ending ending;
  std::span<const std::uint32_t> words;
};

/// Tells whether two answers are the same value, or both #DE. A broken run agrees with nothing, not
/// even with another broken run. Inline because every case of a verification calls it.
inline bool agree(const AnswerView& a, const AnswerView& b) {
  if (a.ending != b.ending) return false;
  if (a.ending == Ending::divide_error) return true;
  return a.ending == Ending::value &&
         std::equal(a.words.begin(), a.words.end(), b.words.begin(), b.words.end());
}

bool agree(std::span<const Answer> answers);

Answer ask(const Party& party, const cases::Variant& variant, std::span<const std::uint32_t> words);

/// Returns the row of `variant`: the candidates that answer it, in the same order.
cases::Row row_of(const cases::Variant& variant, std::span<const Party* const> candidates);

}  // namespace fixproof::parties
