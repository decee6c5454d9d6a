#include <cstddef>

#include "oracle/exact.hpp"
#include "oracle/unbounded.hpp"

namespace oracle {
namespace {

constexpr std::size_t kColumns = 4;

/// The largest multiple of 1.0 not above `value`.
Integer whole(const Integer& value, int fraction_bits) {
  const Integer unit = one(fraction_bits);
  return rounded(value, unit, Rounding::floor) * unit;
}

/// TranslationRule::fourth_in_parts, before reduction to a word.
Integer sum_in_parts(const Integer& x, const Integer& t, int fraction_bits) {
  const Integer sum = x + t;
  return whole(x, fraction_bits) + whole(t, fraction_bits) + sum - whole(sum, fraction_bits);
}

}  // namespace

std::array<Word, 3> xform_vec(std::span<const Word, 12> m, std::span<const Word, 3> v,
                              Rounding rule, int fraction_bits) {
  std::array<Word, 3> result{};
  for (std::size_t row = 0; row < 3; ++row) {
    Integer sum = ulps(m[row * kColumns + 3], fraction_bits);
    for (std::size_t k = 0; k < 3; ++k) {
      sum += exact_product(m[row * kColumns + k], v[k], rule, fraction_bits);
    }
    result[row] = wrap(sum, word_bits(fraction_bits));
  }
  return result;
}

std::array<Word, 12> concat(std::span<const Word, 12> first, std::span<const Word, 12> second,
                            Rounding rule, TranslationRule translation, int fraction_bits) {
  std::array<Word, 12> result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < kColumns; ++column) {
      Integer sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        sum += exact_product(first[row * kColumns + k], second[k * kColumns + column], rule,
                             fraction_bits);
      }
      if (column == 3 || translation == TranslationRule::every) {
        const Integer moved = ulps(first[row * kColumns + 3], fraction_bits);
        sum = translation == TranslationRule::fourth_in_parts
                  ? sum_in_parts(sum, moved, fraction_bits)
                  : sum + moved;
      }
      result[row * kColumns + column] = wrap(sum, word_bits(fraction_bits));
    }
  }
  return result;
}

}  // namespace oracle
