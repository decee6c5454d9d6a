/// @file
/// One case with the subject's result.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "judge/check/ports.hpp"

namespace fixproof::check {

struct JudgedCase {
  std::uint64_t number = 0;  ///< from 1, as results are counted
  std::string_view origin;   ///< the stream or the file of the case; must outlive the case
  std::array<std::uint64_t, 2> words{};
  Said said;
  std::optional<ValuedCase> valued{};  ///< of a case that is judged by its exact value
  std::string said_text{};             ///< the result of to_decimal, as it stands on its line
  /// The words in two's complement, if a rule reads them otherwise: see read_words().
  std::optional<std::array<std::uint64_t, 2>> read{};

  [[nodiscard]] Operands operands() const { return valued ? Operands(*valued) : Operands(words); }
  /// The operands that have the exact result.
  [[nodiscard]] Operands values() const { return read ? Operands(*read) : operands(); }
  /// Sets `read` if the rule reads the words otherwise.
  void read_by(const Rules& rules) {
    if (rules.port != nullptr && rules.port->has_signed_fraction) {
      read = read_words(*rules.port, words);
    }
  }
};

/// The first cases of a category, and their total number.
class FirstCases {
 public:
  FirstCases() = default;
  explicit FirstCases(std::size_t max_shown) : max_shown_(max_shown) {}

  void add(const JudgedCase& one) {
    if (count_++ < max_shown_) shown_.push_back(one);
  }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] const std::vector<JudgedCase>& shown() const { return shown_; }

 private:
  std::size_t max_shown_ = 3;
  std::uint64_t count_ = 0;
  std::vector<JudgedCase> shown_;
};

}  // namespace fixproof::check
