/// @file
/// The targets with word inputs: their judges and mutators.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fuzz/panel.hpp"
#include "verify/cases/draw.hpp"

namespace fixproof::fuzz {

enum class WordTarget : std::uint8_t { divide, multiply, matrix, agreement };

/// Every variant that the target judges. `agreement`, whose first byte chooses one, has all
/// variants with every party that this machine can run except Unicorn, which retranslates a routine
/// after each change of routine. The others have the compiled model, the interpreter and the type.
const std::vector<VariantParties>& parties_by_variant(WordTarget target);

std::size_t input_size(WordTarget target);

/// Mutates a case: draws a fresh one from verify/cases/streams.hpp, or moves one word to an edge or
/// by a step. For a divide, it may also choose a dividend that gives an exact tie, a quotient of 0,
/// 1, 2^31 or 2^32 ulp, or a neighbour of these.
void mutate_case(const cases::Variant& variant, std::span<std::uint32_t> words, cases::Draw& draw);

/// Mutates an input of the target as libFuzzer does: the first `size` bytes of `room` are valid.
/// @return the size of the new input
std::size_t mutate_input(WordTarget target, std::span<std::uint8_t> room, std::size_t size,
                         std::uint32_t seed);

}  // namespace fixproof::fuzz
