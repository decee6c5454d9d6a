#include "judge/check/common_traits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "support/plain_text.hpp"

namespace fixproof::check {

namespace {

constexpr std::size_t max_lines = 3;
/// So few operands have like magnitudes by chance.
constexpr std::uint64_t fewest_for_lengths = 10;

std::size_t length_of(std::uint64_t word, const cases::Format& format) {
  return static_cast<std::size_t>(64 - std::countl_zero(magnitude(word, format)));
}

}  // namespace

void CommonTraits::add(const TraitCase& one, bool right) {
  const TraitSet traits = case_traits(variant_, one);
  Lengths& lengths = right ? right_lengths_ : wrong_lengths_;
  for (std::size_t i = 0; i < one.words.size(); ++i) {
    ++lengths.at(i).at(length_of(one.words.at(i), operand_format(variant_)));
  }
  if (right) {
    ++right_;
    for (TraitSet rest = traits; rest != 0; rest &= rest - 1) {
      ++right_with_.at(static_cast<std::size_t>(std::countr_zero(rest)));
    }
  } else {
    ++wrong_;
    of_wrong_ &= traits;
    of_wrong_results_ &= result_traits(one);
  }
}

bool CommonTraits::tells(std::uint64_t sharing_right) const {
  if (right_ == 0 || 4 * sharing_right > 3 * right_) return false;
  const double share = static_cast<double>(sharing_right) / static_cast<double>(right_);
  return std::pow(share, static_cast<double>(wrong_)) < 0.01;
}

// Of each part of a case the trait that the fewest right cases share; of several the first.
std::vector<CommonTraits::Shared> CommonTraits::shared_traits() const {
  std::array<std::optional<Shared>, parts_of_case> best;
  const auto offer = [this, &best](About part, Shared shared) {
    auto& known = best.at(static_cast<std::size_t>(part));
    if (!tells(shared.right) || (known && known->right <= shared.right)) return;
    known = std::move(shared);
  };
  for (std::size_t i = 0; i < case_trait_count(); ++i) {
    if ((of_wrong_ >> i & 1U) == 0) continue;
    offer(about(i), {right_with_.at(i), case_trait_text(variant_, i)});
  }
  if (wrong_ >= fewest_for_lengths) {
    for (std::size_t i = 0; i < words_of(variant_); ++i) {
      offer(static_cast<About>(i), shared_length(i));
    }
  }
  // "A negative operand" says nothing beside "a negative divisor" or "an exact result below 0".
  auto& either = best.at(static_cast<std::size_t>(About::either));
  const auto says_more = [&either](const std::optional<Shared>& other) {
    return &other != &either && other && other->right <= either->right;
  };
  if (either && std::ranges::any_of(best, says_more)) either.reset();
  std::vector<Shared> shared;
  for (auto& one : best) {
    if (one) shared.push_back(std::move(*one));
  }
  std::ranges::stable_sort(shared, {}, &Shared::right);
  return shared;
}

CommonTraits::Shared CommonTraits::shared_length(std::size_t operand) const {
  const auto& wrong = wrong_lengths_.at(operand);
  const auto& right = right_lengths_.at(operand);
  std::size_t least = 0;
  std::size_t most = wrong.size() - 1;
  while (wrong.at(least) == 0) ++least;
  while (wrong.at(most) == 0) --most;
  // The longest magnitude of a signed format is only that of its lowest word.
  const cases::Format format = operand_format(variant_);
  const auto top = static_cast<std::size_t>(format.word_bits);
  if (format.is_signed && most + 1 >= top) most = top;
  Shared shared;
  for (std::size_t length = least; length <= most; ++length) shared.right += right.at(length);
  const auto low = hex_text(least == 0 ? 0 : std::uint64_t{1} << (least - 1), format);
  const auto high = hex_text(most == 0 ? 0 : ~std::uint64_t{0} >> (64 - most), format);
  shared.text = fmt::format("has {} ", noun_of(variant_.operation, static_cast<About>(operand)));
  if (most == top) {
    shared.text += fmt::format("of {} or more", low);
  } else if (least == 0) {
    shared.text += fmt::format("of {} or less", high);
  } else {
    shared.text += fmt::format("from {} to {}", low, high);
  }
  shared.text += " in magnitude";
  return shared;
}

std::vector<std::string> CommonTraits::lines() const {
  std::vector<std::string> lines;
  if (wrong_ < 2) return lines;
  if (of_wrong_results_ != 0) {
    const auto first = static_cast<std::size_t>(std::countr_zero(of_wrong_results_));
    lines.push_back(fmt::format("every wrong result {}: all {}",
                                result_trait_text(variant_.format, first),
                                support::grouped(wrong_)));
  }
  for (const Shared& shared : shared_traits()) {
    if (lines.size() == max_lines) break;
    lines.push_back(fmt::format("every wrong case {}: all {}, and {} of {} right ones", shared.text,
                                support::grouped(wrong_), support::grouped(shared.right),
                                support::grouped(right_)));
  }
  return lines;
}

}  // namespace fixproof::check
