/// @file
/// Common ways to write a multiply, divide or root in C, and which of them a subject acts like.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "cases/variant.hpp"
#include "check/judged_case.hpp"

namespace fixproof::check {

/// Arithmetic in C on 16.16 words a and b.
struct Idiom {
  cases::Operation operation;
  std::string_view text;
  /// Returns the result in ulps; empty for a divide error. Requires operands whose exact
  /// result fits a word.
  std::optional<std::int64_t> (*result)(std::int64_t a, std::int64_t b);
};

inline constexpr std::size_t idiom_count = 18;
const std::array<Idiom, idiom_count>& idioms();

/// The idioms with the fewest exceptions. Several tie if no case tells them apart.
struct Likeness {
  std::vector<const Idiom*> idioms;
  std::uint64_t exceptions = 0;
  std::uint64_t cases = 0;
};

/// Compares a subject with every idiom.
class IdiomTrial {
 public:
  explicit IdiomTrial(cases::Operation operation) : operation_(operation) {}

  /// Adds a case whose rounded result fits a word. `right` tells whether the subject's is right.
  void add(const JudgedCase& one, bool right);

  /// Returns the best idioms. Empty if no result is wrong, and if the best have exceptions in more
  /// than 1 % of the cases or more than a tenth as many exceptions as there are wrong results.
  [[nodiscard]] std::optional<Likeness> likeness() const;

 private:
  cases::Operation operation_;
  std::uint64_t cases_ = 0;
  std::uint64_t wrong_ = 0;
  std::array<std::uint64_t, idiom_count> exceptions_{};
};

}  // namespace fixproof::check
