#include <cstddef>

#include "oracle/exact.hpp"
#include "oracle/unbounded.hpp"

namespace oracle {
namespace {

constexpr std::size_t kColumns = 4;

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
                            Rounding rule, TranslationColumn translation, int fraction_bits) {
  std::array<Word, 12> result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < kColumns; ++column) {
      const bool translated = column == 3 || translation == TranslationColumn::every;
      Integer sum = translated ? ulps(first[row * kColumns + 3], fraction_bits) : Integer(0);
      for (std::size_t k = 0; k < 3; ++k) {
        sum += exact_product(first[row * kColumns + k], second[k * kColumns + column], rule,
                             fraction_bits);
      }
      result[row * kColumns + column] = wrap(sum, word_bits(fraction_bits));
    }
  }
  return result;
}

}  // namespace oracle
