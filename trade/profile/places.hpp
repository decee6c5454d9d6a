/// @file
/// What the words of a call are: its operands and results, by name.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "cases/variant.hpp"

namespace fixproof::trade {

/// Names of the kinds of operands of a routine, in their order: `matrix`, `translation`, `vector`.
std::span<const std::string_view> operand_names(cases::Operation operation);
/// The same of its results.
std::span<const std::string_view> result_names(cases::Operation operation);

/// Which of operand_names() word `index` of a call is.
std::size_t operand_place(cases::Operation operation, std::size_t index);
/// Which of result_names().
std::size_t result_place(cases::Operation operation, std::size_t index);

}  // namespace fixproof::trade
