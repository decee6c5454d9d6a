/// @file
/// Makes a failing case simple.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace fixproof::verify {

/// The simplest case that greedy steps reach from `words` while `fails` holds: words become 0, lose
/// their sign, become a power of two, lose bits, or are halved; a step is kept only if it makes a
/// word simpler (fewer bits in its magnitude, then no sign, then a smaller magnitude), so that the
/// result does not depend on anything but the case. Words are two's complement of `word_bits` bits.
/// `fails(words)` must hold.
std::vector<std::uint32_t> shrink(std::vector<std::uint32_t> words, int word_bits,
                                  const std::function<bool(std::span<const std::uint32_t>)>& fails);

}  // namespace fixproof::verify
