/// @file
/// Random cases of remainders, of the quotient of a product, and of the length of a vector, in any
/// format. All are the same for every number of fraction bits.
#pragma once

#include <array>
#include <cstdint>

#include "verify/cases/draw.hpp"
#include "verify/cases/format.hpp"
#include "verify/cases/format_makers.hpp"

namespace fixproof::cases {

/// Three operands as words of the format.
using WordTriple = std::array<std::uint64_t, 3>;

/// The dividend is a multiple of half the divisor, or a unit from one.
WordPair half_multiple(Draw& draw, const Format& format);

/// Twice the remainder of the product of the first two is the third.
WordTriple ratio_tie(Draw& draw, const Format& format);
/// ... or differs by one from an odd third.
WordTriple near_ratio_tie(Draw& draw, const Format& format);
/// The product divided by the third is near an end of the range.
WordTriple large_ratio(Draw& draw, const Format& format);

/// A box of whole edges and a whole diagonal, or one edge a unit off. Some diagonals are near the
/// largest word. For words of at most 32 bits
WordTriple whole_length(Draw& draw, const Format& format);
/// The sum of squares is r (r + 1), or one more: the square of r + 1/2 lies between. For words of
/// at most 32 bits
WordTriple near_length_tie(Draw& draw, const Format& format);

}  // namespace fixproof::cases
