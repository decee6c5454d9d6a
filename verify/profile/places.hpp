/// @file
/// What the words of a call are: its operands and results, by name.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "verify/variant.hpp"

namespace fixproof {

/// Names of the kinds of operands of a routine, in their order: `matrix`, `translation`, `vector`.
std::span<const std::string_view> operand_names(Operation operation);
/// The same of its results.
std::span<const std::string_view> result_names(Operation operation);

/// Which of operand_names() word `index` of a call is.
std::size_t operand_place(Operation operation, std::size_t index);
/// Which of result_names().
std::size_t result_place(Operation operation, std::size_t index);

}  // namespace fixproof
