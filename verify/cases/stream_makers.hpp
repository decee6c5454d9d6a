/// @file
/// Functions that construct one random case of each stream of streams.hpp.
#pragma once

#include <cstdint>
#include <span>

#include "verify/cases/draw.hpp"
#include "verify/cases/format.hpp"

namespace fixproof::cases {

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
