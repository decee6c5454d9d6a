/// @file
/// Functions that construct one random case of each stream of streams.hpp.
#pragma once

#include <cstdint>
#include <span>

#include "cases/draw.hpp"

namespace fixproof::cases {

/// The format of a word: 16 fraction bits of 32 bits, or 8 of 16.
struct Format {
  int fraction_bits;
  int word_bits;

  /// Returns `value` units as a word, modulo 2^word_bits.
  [[nodiscard]] constexpr std::uint32_t word(std::int64_t value) const {
    return static_cast<std::uint32_t>(value) & (~std::uint32_t{0} >> (32 - word_bits));
  }
  /// 1.0 in units.
  [[nodiscard]] constexpr std::int64_t one() const { return std::int64_t{1} << fraction_bits; }
  /// The smallest positive magnitude that overflows a word.
  [[nodiscard]] constexpr std::int64_t limit() const { return std::int64_t{1} << (word_bits - 1); }
};

/// Two operands in units, each within -limit() ... limit().
struct Pair {
  std::int64_t first;
  std::int64_t second;
};

/// Returns a word of random sign and width. It can be the most negative word.
std::uint32_t scaled_word(Draw& draw, const Format& format);

Pair product_tie(Draw& draw, const Format& format);
Pair near_product_tie(Draw& draw, const Format& format);

Pair quotient_tie(Draw& draw, const Format& format);
Pair near_quotient_tie(Draw& draw, const Format& format);
Pair whole_divisor_tie(Draw& draw, const Format& format);
Pair large_quotient(Draw& draw, const Format& format);
Pair small_divisor(Draw& draw, const Format& format);
Pair fault_edge(Draw& draw, const Format& format);

std::uint32_t root_tie(Draw& draw, const Format& format);

std::uint32_t quarter_turn(Draw& draw, const Format& format);

/// Returns every positive 16.16 word whose sine or cosine is less than 2^-27 units from halfway. A
/// search of all 2^31 words found them.
std::span<const std::uint32_t> hard_angles();

// Transforms: 12 words of a matrix, then 3 of a point or 12 of a second matrix.
void rotation(Draw& draw, const Format& format, std::span<std::uint32_t> words);
void axes(Draw& draw, const Format& format, std::span<std::uint32_t> words);
void transform_tie(Draw& draw, const Format& format, std::span<std::uint32_t> words);

}  // namespace fixproof::cases
