/// @file
/// Single answers, and the only comparison of answers.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cases/plan.hpp"
#include "parties/party.hpp"

namespace fixproof::parties {

/// The answer of one party to one case.
struct Answer {
  Ending ending = Ending::broken;
  std::vector<std::uint32_t> words;  ///< empty unless the case ended in a value

  /// Each word in lower-case hex digits, separated by single spaces; otherwise DE, or the ending in
  /// words.
  [[nodiscard]] std::string text(int word_bits) const;
};

/// An answer in somebody's buffer. The words count only if the case ended in a value.
struct AnswerView {
  Ending ending;
  std::span<const std::uint32_t> words;
};

/// Whether two answers are the same value, or both #DE. A broken run agrees with nothing, not even
/// with a run that breaks in the same way. Inline, because it decides every case of a verification.
inline bool agree(const AnswerView& a, const AnswerView& b) {
  if (a.ending != b.ending) return false;
  if (a.ending == Ending::divide_error) return true;
  return a.ending == Ending::value &&
         std::equal(a.words.begin(), a.words.end(), b.words.begin(), b.words.end());
}

/// Whether all answers to a case agree with one another.
bool agree(std::span<const Answer> answers);

/// The answer of one party to one case.
Answer ask(const Party& party, const cases::Variant& variant, std::span<const std::uint32_t> words);

/// The row of `variant`: those candidates that answer it, in the same order.
cases::Row row_of(const cases::Variant& variant, std::span<const Party* const> candidates);

}  // namespace fixproof::parties
