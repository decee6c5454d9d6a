/// @file
/// The streams of cases. Each stream looks for one kind of defect. Case i of a stream is a pure
/// function of the operation and format of the variant, the seed, the stream and i. Enumerated
/// streams do not depend on the seed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "verify/cases/variant.hpp"

namespace fixproof::cases {

/// The way cases are made. Formats other than 16.16 and 8.8 have the streams of mul, div and sqrt
/// without whole_divisor_ties and fault_edge. F is the number of fraction bits; one unit is the
/// last place, 2^-F.
enum class Stream : std::uint8_t {
  // Any operation.
  uniform,  ///< every word is equally likely
  scaled,   ///< random sign and width: small and large words are equally common
  // Enumerated streams of one or two operands.
  lattice,  ///< every ordered choice of values of boundary_lattice()
  every,    ///< every operand, if the operands have at most 32 bits in total; up to three
  // mul, and one product of a sum whose other terms are whole units.
  product_ties,       ///< the exact product lies halfway between two units
  near_product_ties,  ///< ... or 2^-F of a unit from halfway, the smallest distance that is not a
                      ///< tie
  // div.
  quotient_ties,       ///< twice the remainder is the divisor, which uses all its bits
  near_quotient_ties,  ///< twice the remainder differs by one from an odd divisor
  whole_divisor_ties,  ///< the remainder is about half the divisor's integer part, by which the
                       ///< 8088 divides
  large_quotients,     ///< quotients near 2^(2F-1) and 2^2F units
  small_divisors,      ///< divisors below 1.0
  fault_edge,          ///< divisors near the largest that causes #DE on either processor
  // xformvec and concat; lattice_words also mul_div and hypot of three numbers.
  rotations,       ///< orthonormal rows with the translations and points of a scene
  axes,            ///< permuted and rotated axes, including the identity and its negative
  lattice_words,   ///< every word is from boundary_lattice()
  transform_ties,  ///< every product of a coefficient and a coordinate is an exact tie
  // sqrt.
  root_ties,  ///< operands whose roots come nearest to halfway
  // sin and cos.
  quarter_turns,  ///< words next to multiples of a quarter turn, and one unit from them
  hard_angles,    ///< the 16.16 words whose sine or cosine comes nearest to halfway
  // Conversions, and add and sub with results of a coarser unit. Uniform doubles of conversions
  // have any bits; their uniform decimals have few digits.
  value_ties,       ///< the operand or the sum lies halfway between two words of the results
  near_value_ties,  ///< ... or next to halfway: the next double or word, or a digit far behind
  // fmod and remainder.
  half_multiples,  ///< the dividend is a multiple of half the divisor, or a unit from one
  // mul_div.
  ratio_ties,       ///< twice the remainder of the product is the divisor
  near_ratio_ties,  ///< ... or differs by one from an odd divisor
  large_ratios,     ///< quotients near the ends of the range
  // hypot of three numbers.
  whole_lengths,     ///< the length is a whole number of units, or one operand is a unit off
  near_length_ties,  ///< the sum of squares is as near to the square of a half as it can be
  // Enumerated: functions of one or two real numbers.
  edges,  ///< next to poles, zeros, and the ends of the domain and of the range; see edges.hpp
  // mul_add, lerp and dot, which also have product_ties and lattice_words.
  extremes,  ///< every operand is an end of the range or next to 0, often all factors the same
};

std::string_view name_of(Stream stream);

/// Returns the boundary values: 0, 1, 2, 3, every power of two, the words one unit from them and
/// bit patterns, each with both signs. They are sorted and distinct.
std::vector<std::uint64_t> boundary_lattice(int word_bits);

/// Returns the number of cases of an enumerated stream; empty for a random, endless stream.
/// @throws std::invalid_argument if the operation has too many operands to enumerate
std::optional<std::uint64_t> size_of(Stream stream, const Variant& variant);

/// Writes cases `first`, `first` + 1, ... of a stream until `words` is full. The size of `words` is
/// a multiple of words_in(variant).
/// @throws std::invalid_argument if the operation does not have that stream
void make_cases(Stream stream, const Variant& variant, std::uint64_t seed, std::uint64_t first,
                std::span<std::uint32_t> words);

}  // namespace fixproof::cases
