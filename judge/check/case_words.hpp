/// @file
/// A case from the words of its operands, as `gen` makes them.
#pragma once

#include <cstdint>
#include <span>

#include "judge/check/judged_case.hpp"

namespace fixproof::check {

/// Returns the case in the form that Judge takes, without a result.
JudgedCase case_of(const cases::Variant& variant, std::span<const std::uint32_t> words);

/// Returns a measure of a case that grows with the bits of its operands.
int size_of(const cases::Variant& variant, std::span<const std::uint32_t> words);

}  // namespace fixproof::check
