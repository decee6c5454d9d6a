/// @file
/// The sizes and bit positions of a log. docs/recorder.md documents the format to the byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "fixed/number.hpp"
#include "fixed/policy.hpp"
#include "fixed/record/kinds.hpp"

namespace fixproof::record {

/// A word of 64 bits, little-endian in the file.
using word = std::uint64_t;

/// A page: a header of 8 words and 120 words of contents.
inline constexpr std::size_t page_words = 128;
inline constexpr std::size_t page_bytes = page_words * sizeof(word);  ///< Its bytes.
inline constexpr std::size_t page_header = 8;                         ///< The words of its header.
inline constexpr std::size_t page_room = page_words - page_header;  ///< The words of its contents.

/// The number of records in a block. A block before a frame or at the end of the run has fewer.
inline constexpr std::size_t block_records = 1024;
/// The number of words in an entry, which summarises one block.
inline constexpr std::size_t entry_words = 4;
/// The number of entries in a page.
inline constexpr std::size_t page_entries = page_room / entry_words;

/// What a page contains. It is in the upper half of the first word; the lower half is `magic`.
enum class page_type : std::uint32_t {
  header = 1,   ///< The origin of the log, as text.
  name = 2,     ///< The text of a mark or the path of a source.
  records = 3,  ///< The records of a block.
  blocks = 4,   ///< The entries of blocks.
};
/// "FXRL" as little-endian bytes.
inline constexpr std::uint32_t magic = 0x4c525846;

/// The current frame before the first call of frame(), and the confirmed frame before the first
/// call of confirm().
inline constexpr std::int64_t no_frame = (std::numeric_limits<std::int64_t>::min)();

/// @name Bits of the fourth word of an entry
/// \{
inline constexpr word entry_operations = 0xffff;  ///< The operations of the block.
inline constexpr word entry_begins_frame = 1 << 16;
inline constexpr word entry_is_last = 1 << 17;  ///< The run ended before the block was full.
inline constexpr int entry_name_shift = 32;     ///< The number of the name in force at its start.
/// \}

/// @name A type, in the upper 24 bits of 32
/// The lower 8 bits of a tag are the kind and `tag_is_long`. Those of a type in a list are a
/// value_class.
/// \{
inline constexpr std::uint32_t tag_kind = 0x7f;
inline constexpr std::uint32_t tag_is_long = 0x80;
inline constexpr int tag_size_shift = 8;  ///< log2 of the bytes, in 2 bits.
inline constexpr std::uint32_t tag_is_unsigned = 1 << 10;
inline constexpr int tag_fraction_shift = 11;  ///< Fraction bits, in 7 bits.
inline constexpr int tag_policy_shift = 18;    ///< The policy, in 14 bits.
/// \}

/// What a value of a long record is.
enum class value_class : std::uint8_t {
  number = 0,   ///< The stored integer.
  integer = 1,  ///< An integer in two's complement.
  boolean = 2,  ///< 0 or 1.
  digest = 3,   ///< The hash of many operands.
  none = 4,     ///< No result, as of checked_add() on overflow.
};

/// @name The upper half of the first word of a long record
/// \{
inline constexpr int long_operands_shift = 32;  ///< The number of operands, in 8 bits.
inline constexpr int long_results_shift = 40;   ///< The number of results, in 8 bits.
inline constexpr word long_threw = word{1} << 48;
/// \}
/// The most operands and results of a long record together.
inline constexpr std::size_t max_values = 8;
/// The most words of a record.
inline constexpr std::size_t max_record_words = 14;

/// Returns the policy in 14 bits.
constexpr std::uint32_t code_of(const policy& p) noexcept {
  const auto n = [](auto rule) { return static_cast<std::uint32_t>(rule); };
  const std::uint32_t ranges = n(p.range) << 4 | n(p.products) << 2 | n(p.quotients);
  return (n(p.multiply) * 5 + n(p.divide)) << 9 | ranges << 3 | n(p.divisor) << 2 | n(p.fault);
}

/// Returns the logarithm of 1, 2, 4 or 8.
constexpr std::uint32_t log2_of(std::size_t bytes) noexcept {
  return bytes == 1 ? 0 : bytes == 2 ? 1 : bytes == 4 ? 2 : 3;
}

/// Returns the type of an integer of `bytes` bytes.
constexpr std::uint32_t integer_code(std::size_t bytes, bool is_unsigned) noexcept {
  return log2_of(bytes) << tag_size_shift | (is_unsigned ? tag_is_unsigned : 0);
}

/// The type of a number.
template <class Number>
inline constexpr std::uint32_t type_code =
    integer_code(sizeof(typename Number::raw_type), std::is_unsigned_v<typename Number::raw_type>) |
    static_cast<std::uint32_t>(Number::fraction_bits) << tag_fraction_shift |
    code_of(Number::rules) << tag_policy_shift;

/// Returns the kind of a record whose first word is `first`. Another program may have written one
/// that text_of() does not know.
constexpr kind kind_of(word first) noexcept { return static_cast<kind>(first & tag_kind); }

/// Returns the number of words of a record whose first word is `first`. A short record has 2 words
/// for numbers of at most 32 bits, and 4 for 64 bits. A long record has its types, two in a word,
/// and its values, filled up to an even number.
constexpr std::size_t words_of(word first) noexcept {
  if ((first & tag_is_long) == 0) return (first >> tag_size_shift & 3) == 3 ? 4 : 2;
  const std::size_t values =
      (first >> long_operands_shift & 0xff) + (first >> long_results_shift & 0xff);
  return (1 + (values + 1) / 2 + values + 1) / 2 * 2;
}

}  // namespace fixproof::record
