/// @file
/// The targets whose input is words: their judges and their mutators.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cases/draw.hpp"
#include "fuzz/jury.hpp"

namespace fixproof::fuzz {

enum class WordTarget : std::uint8_t { divide, multiply, matrix, agreement };

/// Every variant that the target judges. `agreement`, whose first byte chooses one, has all
/// variants with every party that this machine can run. The others have the model, compiled and
/// interpreted, and the type. Unicorn retranslates a routine whenever another one ran in between,
/// so only `step` uses it.
const std::vector<Seat>& seats_of(WordTarget target);

/// The size of a full input in bytes.
std::size_t input_size(WordTarget target);

/// Mutates a case: draws a fresh one from cases/streams.hpp, or moves one word to an edge or by a
/// step. For a divide it may also choose the dividend that gives, with the current divisor, an
/// exact tie, or a quotient of 0, 1, 2^31 or 2^32 ulp, or a neighbour of one.
void mutate_case(const cases::Variant& variant, std::span<std::uint32_t> words, cases::Draw& draw);

/// The same for an input of the target, in libFuzzer's terms: the first `size` bytes of `room` are
/// valid.
/// @return the size of the new input
std::size_t mutate_input(WordTarget target, std::span<std::uint8_t> room, std::size_t size,
                         std::uint32_t seed);

}  // namespace fixproof::fuzz
