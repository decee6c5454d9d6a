/// @file
/// Numbers and cases as people read them.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "verify/plan.hpp"
#include "verify/variant.hpp"

namespace fixproof {

/// 1234567 as 1,234,567.
std::string grouped(std::uint64_t number);

/// A duration to the precision that serves: 8.3 s, 4 min 20 s, 2 h 05 min.
std::string duration(double seconds);

/// A row in a word or three: `mul i8088 off`, `sqrt standard`, `div i386 on, chapter 52`,
/// `..., 8.8`.
std::string name_of(const Variant& variant);

/// Words of `bits` bits in hex digits, single spaces between.
std::string hex_words(std::span<const std::uint32_t> words, int bits);

/// The operands in decimal, to five places, which tell all 16.16 values apart; angles in degrees.
std::string decimal_words(const Variant& variant, std::span<const std::uint32_t> words);

/// The command line that shows what the routine does with the case.
std::string trace_line(const Variant& variant, std::span<const std::uint32_t> words);

/// The command line that asks for the case again: `fixproof eval` of the judged party where it has
/// the variant, else `fixproof verify --case`.
std::string replay(const Row& row, std::span<const std::uint32_t> words);

}  // namespace fixproof
