/// @file
/// One random case of each kind that is constructed; streams.hpp says what the kinds are.
#pragma once

#include <cstdint>
#include <span>

#include "cases/draw.hpp"

namespace fixproof::cases {

/// The format of a word: 16 and 32 bits, or 8 and 16.
struct Format {
  int fraction_bits;
  int word_bits;

  /// `value` units as a word, modulo 2^word_bits.
  [[nodiscard]] constexpr std::uint32_t word(std::int64_t value) const {
    return static_cast<std::uint32_t>(value) & (~std::uint32_t{0} >> (32 - word_bits));
  }
  /// 1.0 in units.
  [[nodiscard]] constexpr std::int64_t one() const { return std::int64_t{1} << fraction_bits; }
  /// The first magnitude that a positive word cannot hold.
  [[nodiscard]] constexpr std::int64_t limit() const { return std::int64_t{1} << (word_bits - 1); }
};

/// Two operands in units, each within -limit() ... limit().
struct Pair {
  std::int64_t first;
  std::int64_t second;
};

/// A word of random sign and width, the most negative one included.
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

/// Every 16.16 word of which the sine or the cosine is less than 2^-27 units from halfway, without
/// the negative ones, as a look at all 2^31 has found them.
std::span<const std::uint32_t> hard_angles();

// Transforms: 12 words of a matrix, then 3 of a point or 12 of a second matrix.
void rotation(Draw& draw, const Format& format, std::span<std::uint32_t> words);
void axes(Draw& draw, const Format& format, std::span<std::uint32_t> words);
void transform_tie(Draw& draw, const Format& format, std::span<std::uint32_t> words);

}  // namespace fixproof::cases
