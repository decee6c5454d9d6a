#include "judge/check/case_words.hpp"

#include <algorithm>
#include <bit>
#include <string>

#include "verify/cases/words.hpp"

namespace fixproof::check {

JudgedCase case_of(const cases::Variant& variant, std::span<const std::uint32_t> words) {
  JudgedCase one;
  if (is_judged_by_value(variant)) {
    std::string line;
    cases::append_operands(line, variant, words);
    one.valued = parse_valued(line, variant);
    const auto& whole = one.valued->words;
    std::copy_n(whole.begin(), std::min(whole.size(), one.words.size()), one.words.begin());
  } else {
    join_words(words, variant.format,
               std::span(one.words).first(cases::words_in(variant.operation)));
  }
  return one;
}

int size_of(const cases::Variant& variant, std::span<const std::uint32_t> words) {
  const cases::Format format = cases::operand_format(variant);
  const std::uint64_t sign = std::uint64_t{1} << (format.word_bits - 1);
  int size = 0;
  if (format.word_bits > 32) {
    for (const std::uint32_t word : words) size += std::popcount(word);
    return size;
  }
  for (const std::uint32_t word : words) {
    const bool negative = format.is_signed && (word & sign) != 0;
    const std::uint64_t magnitude = negative ? 2 * sign - word : word;
    size += 2 * static_cast<int>(std::bit_width(magnitude)) + (negative ? 1 : 0);
  }
  return size;
}

}  // namespace fixproof::check
