/// @file
/// Common ways to write a multiply, divide, remainder or root in C, and which of them a subject
/// acts like.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "judge/check/judged_case.hpp"
#include "oracle/integer.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::check {

/// Arithmetic in C on words a and b, or on the operand x of a conversion. The exact value of x is
/// a / b ulps of the result. Of mul_div it is arithmetic on the product a and the divisor b.
struct Idiom {
  /// Returns the result in ulps; empty for a divide error. Requires operands whose exact
  /// result fits a word.
  template <class Number>
  using Result = std::optional<Number> (*)(const Number& a, const Number& b,
                                           const cases::Format& format);

  cases::Operation operation;
  /// The text in C, with named places that text_in() fills for a format.
  std::string_view text;
  Result<std::int64_t> narrow;   ///< for words of 16.16; null for conversions
  Result<oracle::Integer> wide;  ///< for other formats; null if the idiom is only for 16.16

  [[nodiscard]] std::string text_in(const cases::Format& format) const;
  [[nodiscard]] bool is_for(const cases::Variant& of) const;
};

inline constexpr std::size_t idiom_count = 30;
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
  explicit IdiomTrial(const cases::Variant& variant) : variant_(variant) {}

  /// Adds a case whose rounded result fits a word. `right` tells whether the subject's is right.
  void add(const JudgedCase& one, bool right);

  /// Returns the best idioms. Empty if no result is wrong, and if the best have exceptions in more
  /// than 1 % of the cases or more than a tenth as many exceptions as there are wrong results.
  [[nodiscard]] std::optional<Likeness> likeness() const;

 private:
  cases::Variant variant_;
  std::uint64_t cases_ = 0;
  std::uint64_t wrong_ = 0;
  std::array<std::uint64_t, idiom_count> exceptions_{};
};

}  // namespace fixproof::check
