/// @file
/// Operands where a function of real numbers changes from one kind of result to another.
#pragma once

#include <cstdint>
#include <span>

#include "verify/cases/format.hpp"
#include "verify/cases/operation.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::cases {

/// Tells whether the operation is a function of one or two real numbers.
constexpr bool has_edges(Operation operation) {
  return is_function(operation) && words_in(operation) <= 2;
}

/// Tells whether edge_words() has words of the operation and the format, which has at most 32 bits:
/// in wider ones the oracle would take minutes to search.
constexpr bool has_edges_in(Operation operation, const Format& format) {
  return has_edges(operation) && format.word_bits <= 32 && is_in_format(operation, format);
}

/// Returns the operands of every case, words_in(operation) words for each, without a case twice.
/// An edge lies between two neighbouring operands. One of them is outside the domain, or their
/// results are on different sides of zero or of an end of the range. The cases are the operands
/// within two words of an edge, and for an angle also those within two words of a multiple of a
/// quarter turn: the 64 multiples next to zero and the last 64 on each side. The oracle finds the
/// edges between neighbours of boundary_lattice(). Of two operands, either is from the lattice.
///
/// Results have the format of the operands. The words are computed once for each operation and
/// format, and live as long as the program.
/// @pre has_edges_in(operation, format)
std::span<const std::uint32_t> edge_words(Operation operation, const Format& format);

}  // namespace fixproof::cases
