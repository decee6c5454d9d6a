/// @file
/// Shrinks a failing case to a simple one.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace fixproof::verify {

/// Returns the simplest case that greedy steps reach from `words` while `fails` holds. A step sets
/// a word to 0, drops its sign, replaces it by a power of two, clears bits or halves it. It counts
/// only if the word becomes simpler: fewer bits in its magnitude, then no sign, then a smaller
/// magnitude. The result therefore depends on the case alone.
/// @param words two's complement numbers of `word_bits` bits; `fails(words)` must hold
std::vector<std::uint32_t> shrink(std::vector<std::uint32_t> words, int word_bits,
                                  const std::function<bool(std::span<const std::uint32_t>)>& fails);

}  // namespace fixproof::verify
