/// @file
/// The targets whose input is words: who judges them, and how an input becomes the next one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cases/draw.hpp"
#include "fuzz/jury.hpp"

namespace fixproof::fuzz {

enum class WordTarget : std::uint8_t { divide, multiply, matrix, agreement };

/// Every variant that the target judges. Those of `agreement`, whose first byte chooses one, are
/// all there are, heard with every party that this machine has; the others with the model, compiled
/// and interpreted, and the type. Unicorn, which translates a routine anew whenever another one
/// came between, is left to `step`.
const std::vector<Seat>& seats_of(WordTarget target);

/// Bytes of a whole input.
std::size_t input_size(WordTarget target);

/// Makes a new case of an old one: a fresh one from the generators of cases/streams.hpp, or one of
/// its words moved to where rules change, or by a step. For a divide also: the dividend at which
/// the divisor that is there gives an exact tie, or a quotient of 0, 1, 2^31 or 2^32 units, or the
/// one beside it.
void mutate_case(const cases::Variant& variant, std::span<std::uint32_t> words, cases::Draw& draw);

/// The same of an input of the target, in libFuzzer's terms: `size` bytes of `room` are there.
/// @return the bytes of the new input
std::size_t mutate_input(WordTarget target, std::span<std::uint8_t> room, std::size_t size,
                         std::uint32_t seed);

}  // namespace fixproof::fuzz
