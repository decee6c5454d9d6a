/// @file
/// The operands of one case as a person types them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "verify/cases/variant.hpp"

namespace fixproof::cli {

/// Returns a number as a word of the format, rounded to nearest with halves up. In a format
/// without a fraction it must be whole.
/// @throws UsageError with the text and what is wrong with it
std::uint64_t word_of(std::string_view text, const cases::Format& format);

/// Reads the operands of one case into words_in(v) words. The angle of cossin is
/// in tenths of a degree.
/// @throws UsageError with what is wrong
void read_words(std::span<const std::string_view> numbers, const cases::Variant& v,
                std::span<std::uint32_t> words);
/// The same for a line. Spaces, tabs, commas and semicolons separate the numbers.
void read_words(std::string_view line, const cases::Variant& v, std::span<std::uint32_t> words);

}  // namespace fixproof::cli
