/// @file
/// Names for the operands and results of a call.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "verify/cases/variant.hpp"

namespace fixproof::trade {

/// The kinds of operands of a routine in call order, such as `matrix`, `translation`, `vector`.
std::span<const std::string_view> operand_names(cases::Operation routine);
/// The kinds of results of a routine.
std::span<const std::string_view> result_names(cases::Operation routine);

/// The index into operand_names() of word `index` of a call.
std::size_t operand_place(cases::Operation operation, std::size_t index);
/// The index into result_names() of word `index` of the results.
std::size_t result_place(cases::Operation operation, std::size_t index);

}  // namespace fixproof::trade
