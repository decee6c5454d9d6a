#include <cstddef>

#include "oracle/exact.hpp"

namespace oracle {
namespace {

constexpr std::size_t kColumns = 4;

// A rounded product of words has at most 2^46 ulps. Three of them and a word stay below 2^48, and
// sum_in_parts() stays below 2^50, so a Wide holds every sum here.

/// The largest multiple of 1.0 not above `value`.
Wide whole(const Wide& value, const Format& format) {
  const Wide unit = one<Wide>(format);
  return rounded<Wide>(value, unit, Rounding::floor) * unit;
}

/// TranslationRule::fourth_in_parts, before reduction to a word.
Wide sum_in_parts(const Wide& x, const Wide& t, const Format& format) {
  const Wide sum = x + t;
  return whole(x, format) + whole(t, format) + sum - whole(sum, format);
}

}  // namespace

std::array<Word, 3> xform_vec(std::span<const Word, 12> m, std::span<const Word, 3> v,
                              Rounding rule, const Format& format) {
  std::array<Word, 3> result{};
  for (std::size_t row = 0; row < 3; ++row) {
    Wide sum = ulps<Wide>(m[row * kColumns + 3], format);
    for (std::size_t k = 0; k < 3; ++k) {
      sum += exact_product<Wide>(m[row * kColumns + k], v[k], rule, format);
    }
    result[row] = static_cast<Word>(wrap<Wide>(sum, format));
  }
  return result;
}

std::array<Word, 12> concat(std::span<const Word, 12> first, std::span<const Word, 12> second,
                            Rounding rule, TranslationRule translation, const Format& format) {
  std::array<Word, 12> result{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < kColumns; ++column) {
      Wide sum = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        sum += exact_product<Wide>(first[row * kColumns + k], second[k * kColumns + column], rule,
                                   format);
      }
      if (column == 3 || translation == TranslationRule::every) {
        const Wide moved = ulps<Wide>(first[row * kColumns + 3], format);
        sum = translation == TranslationRule::fourth_in_parts ? sum_in_parts(sum, moved, format)
                                                              : sum + moved;
      }
      result[row * kColumns + column] = static_cast<Word>(wrap<Wide>(sum, format));
    }
  }
  return result;
}

}  // namespace oracle
