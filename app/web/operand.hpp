/// @file
/// A number that a person types, for the type and the oracle.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "app/web/formats.hpp"
#include "oracle/decimal.hpp"
#include "oracle/format.hpp"

namespace fixproof::web {

struct Operand {
  std::string error{};    ///< what is wrong with the text; empty if it is right
  oracle::Ratio exact{};  ///< the exact number
  std::string decimal{};  ///< the same as decimal text, which the type can read
};

/// Reads what input::number_of() reads.
Operand operand_of(std::string_view text, const NumberFormat& format);

/// An operand as a word of a format.
struct WordOperand {
  std::string error{};  ///< what is wrong with the text; empty if it is right
  std::uint64_t word = 0;
};

/// Reads what operand_of() reads, and rounds it to a word of the format.
WordOperand word_operand_of(std::string_view text, const NumberFormat& format);

/// Returns the range of a format, such as `-32768 to 32767.9999847412109375`.
std::string range_of(const NumberFormat& format);

}  // namespace fixproof::web
