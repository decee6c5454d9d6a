/// @file
/// What all wrong cases of a subject have in common and its right ones do not.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "judge/check/traits.hpp"

namespace fixproof::check {

class CommonTraits {
 public:
  explicit CommonTraits(const cases::Variant& variant) : variant_(variant) {}

  void add(const TraitCase& one, bool right);

  /// Returns at most three lines: a trait of all wrong results, then those traits of all wrong
  /// cases that the fewest right cases share. Empty if less than two cases are wrong. A trait that
  /// more than 3/4 of the right cases share says little, and one that as many random right cases
  /// would share with probability 1 % or more may be chance; both are left out.
  [[nodiscard]] std::vector<std::string> lines() const;

 private:
  /// The number of cases by operand and bit length of its magnitude.
  using Lengths = std::array<std::array<std::uint64_t, 65>, 2>;
  struct Shared {
    std::uint64_t right = 0;  ///< right cases that share the trait
    std::string text;
  };
  [[nodiscard]] std::vector<Shared> shared_traits() const;
  [[nodiscard]] Shared shared_length(std::size_t operand) const;
  [[nodiscard]] bool tells(std::uint64_t sharing_right) const;

  cases::Variant variant_;
  std::uint64_t right_ = 0;
  std::uint64_t wrong_ = 0;
  TraitSet of_wrong_ = ~TraitSet{};          ///< of every wrong case
  TraitSet of_wrong_results_ = ~TraitSet{};  ///< of every wrong result
  std::array<std::uint64_t, max_traits> right_with_{};
  Lengths right_lengths_{};
  Lengths wrong_lengths_{};
};

}  // namespace fixproof::check
