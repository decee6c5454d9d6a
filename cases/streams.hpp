/// @file
/// The cases: each stream looks for one kind of trouble. Case i of a stream is a pure function of
/// the variant's operation and format, the seed, the stream and i.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "cases/variant.hpp"

namespace fixproof::cases {

/// How cases are made. F is the number of fraction bits, "one unit" the last place, 2^-F.
enum class Stream : std::uint8_t {
  // Any operation.
  uniform,  ///< every word as likely
  scaled,   ///< a random sign and a random number of bits: small and large words alike
  // One or two operands, counted through.
  lattice,  ///< every ordered choice of values of boundary_lattice()
  every,    ///< every operand of at most 32 bits in all
  // mul.
  product_ties,       ///< the exact product lies halfway between two units
  near_product_ties,  ///< ... or 2^-F of a unit beside halfway, as near as a product can come
  // div.
  quotient_ties,       ///< twice the remainder is the divisor, all its bits used
  near_quotient_ties,  ///< twice the remainder is one beside an odd divisor
  whole_divisor_ties,  ///< about half the divisor's integer part remains: the 8088 divides by that
                       ///< part
  large_quotients,     ///< quotients about 2^(2F-1) and 2^2F units
  small_divisors,      ///< divisors below 1.0
  fault_edge,          ///< divisors about the largest that faults, on either processor
  // xformvec and concat.
  rotations,       ///< orthonormal rows, translations and points as a scene has them
  axes,            ///< the axes permuted and turned about; the identity and its negative among them
  lattice_words,   ///< every word one of boundary_lattice()
  transform_ties,  ///< every product of a coefficient and a coordinate is an exact tie
  // sqrt.
  root_ties,  ///< the operands whose roots come nearest to halfway
  // sin and cos.
  quarter_turns,  ///< the words next to multiples of a quarter turn, and one unit beside them
  hard_angles,    ///< the 16.16 words whose sine or cosine comes nearest to halfway
};

/// The lower-case name of a stream.
std::string_view name_of(Stream stream);

/// Words where rules change: 0, 1, 2, 3, every power of two, one unit beside them, patterns of
/// bits, all with either sign; sorted, each once.
std::vector<std::uint32_t> boundary_lattice(int word_bits);

/// How many different cases a stream that counts has; empty for the random ones, which go on for
/// ever.
/// @throws std::invalid_argument where the operation has too many operands to count through
std::optional<std::uint64_t> size_of(Stream stream, const Variant& variant);

/// Writes cases `first`, `first` + 1, ... of a stream, as many as fill `words`, whose size is a
/// multiple of words_in(operation).
/// @throws std::invalid_argument if the stream is not one for that operation
void make_cases(Stream stream, const Variant& variant, std::uint64_t seed, std::uint64_t first,
                std::span<std::uint32_t> words);

}  // namespace fixproof::cases
