/// @file
/// Cases of conversions: doubles, words of another format, and decimal texts.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "verify/cases/draw.hpp"
#include "verify/cases/format_makers.hpp"
#include "verify/cases/streams.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::cases {

/// Tells whether the operation's ties are words halfway between two results: it is convert, add or
/// sub.
bool has_ties_of_words(Operation operation);

/// Makes operands of add or sub whose sum or difference lies halfway between two words of the
/// results, or next to that. Of unsigned words only the sum does.
WordPair sum_tie(Stream stream, Draw& draw, const Variant& variant);

/// Tells whether the conversion has cases in a stream; value_ties and near_value_ties also of add
/// and sub. What drops no fraction has no ties.
bool has_conversion_stream(Stream stream, const Variant& variant);

/// The number of boundary cases of a conversion.
std::uint64_t conversion_lattice_size(const Variant& variant);

/// Writes boundary case `number` to words_in(variant) words: the words of boundary_lattice(),
/// doubles with every exponent, or decimal texts at and next to the words of boundary_lattice().
void conversion_lattice_case(const Variant& variant, std::uint64_t number,
                             std::span<std::uint32_t> words);

/// Writes a random case of a stream.
void conversion_case(Stream stream, Draw& draw, const Variant& variant,
                     std::span<std::uint32_t> words);

/// Appends the decimal text that the words of a case of from_decimal stand for.
void append_decimal_operand(std::string& to, std::span<const std::uint32_t> words,
                            const Format& format);

}  // namespace fixproof::cases
