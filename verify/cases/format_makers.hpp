/// @file
/// Random cases of any format, where stream_makers.hpp serves only those of the routines.
#pragma once

#include <cstdint>
#include <optional>

#include "verify/cases/draw.hpp"
#include "verify/cases/format.hpp"
#include "verify/cases/streams.hpp"

namespace fixproof::cases {

/// Two operands as words of the format.
struct WordPair {
  std::uint64_t first;
  std::uint64_t second;
};

/// Every word is equally likely.
std::uint64_t any_word(Draw& draw, const Format& format);
/// Every width is equally likely, with either sign if the format has one.
std::uint64_t any_width(Draw& draw, const Format& format);

/// Returns a number of 0 ... `widest` bits. Every width is equally likely. 0 <= widest <= 64
std::uint64_t any_number(Draw& draw, int widest);
/// Returns an odd number of 1 ... `widest` bits.
std::uint64_t odd_number(Draw& draw, int widest);
/// Returns the word or, in half of the cases of a signed format, its negative.
std::uint64_t either_sign(Draw& draw, std::uint64_t word, const Format& format);

/// Returns the format that the makers of a stream below take: the operands' words, and as many
/// fraction bits as put results where the stream wants them if these have another format. Empty if
/// no operands do.
std::optional<Format> maker_format(Stream stream, const Variant& variant);

/// The exact product lies halfway between two units.
WordPair product_tie_in(Draw& draw, const Format& format);
/// ... or 2^-F of a unit from halfway.
WordPair near_product_tie_in(Draw& draw, const Format& format);
/// Twice the remainder is the divisor.
WordPair quotient_tie_in(Draw& draw, const Format& format);
/// Twice the remainder differs by one from an odd divisor.
WordPair near_quotient_tie_in(Draw& draw, const Format& format);
/// Quotients near the largest word.
WordPair large_quotient_in(Draw& draw, const Format& format);
/// Divisors below 1.0.
WordPair small_divisor_in(Draw& draw, const Format& format);
/// Operands whose roots come nearest to halfway.
std::uint64_t root_tie_in(Draw& draw, const Format& format);

/// One of the ends of the range and the words next to 0.
std::uint64_t extreme_word(Draw& draw, const Format& format);

}  // namespace fixproof::cases
