/// @file
/// The hashes of records, blocks and pages. They take words as numbers, so byte order does not
/// matter.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fixproof::record {

/// Returns the upper half of the 128-bit product of a and b, xor the lower half. The xor matters:
/// each half alone, or their sum, is almost linear in a, so opposite changes of two records would
/// cancel in the sum of their hashes.
constexpr std::uint64_t folded_product(std::uint64_t a, std::uint64_t b) noexcept {
#if defined(__SIZEOF_INT128__) && !defined(FIXED_NO_INT128)
  __extension__ using wide = unsigned __int128;
  const wide product = wide{a} * b;
  return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
#else
  constexpr std::uint64_t low = 0xffffffff;
  const std::uint64_t bottom = (a & low) * (b & low);
  const std::uint64_t one = (a >> 32) * (b & low) + (bottom >> 32);
  const std::uint64_t other = (a & low) * (b >> 32) + (one & low);
  const std::uint64_t top = (a >> 32) * (b >> 32) + (one >> 32) + (other >> 32);
  return top ^ (other << 32 | (bottom & low));
#endif
}

/// Returns the hash of a sequence of pairs of words, extended by one pair. The factor 9 makes the
/// hash depend on the order. The product does not depend on the hash, so in a chain of hashes only
/// the multiplication by 9 and the sum wait for the hash before. The keys have many bits set in
/// both halves, so that small operands also spread over the whole hash.
constexpr std::uint64_t next_hash(std::uint64_t hash, std::uint64_t first,
                                  std::uint64_t second) noexcept {
  return hash * 9 + folded_product(first ^ 0x9e3779b97f4a7c00, second ^ 0xd1b54a32d192ed03);
}

/// Returns the hash of `count` words, an even number.
constexpr std::uint64_t hash_words(const std::uint64_t* words, std::size_t count) noexcept {
  std::uint64_t hash = 0;
  for (std::size_t i = 0; i < count; i += 2) hash = next_hash(hash, words[i], words[i + 1]);
  return hash;
}

/// Returns the hash of a text, which takes each byte with its index.
constexpr std::uint64_t hash_text(const char* text, std::size_t length) noexcept {
  std::uint64_t hash = length;
  for (std::size_t i = 0; i < length; ++i) {
    hash = next_hash(hash, i, static_cast<unsigned char>(text[i]));
  }
  return hash;
}

}  // namespace fixproof::record
