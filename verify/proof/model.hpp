/// @file
/// Checks the model that a solver returns with "sat".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fixproof::proof {

/// Evaluates the assertions of `script` under `model`, in the form of `(get-model)`. A constant or
/// function that the model omits may have any value and is 0.
/// @param script one question: declarations, definitions, assertions and one (check-sat)
/// @return why `model` does not satisfy the script; empty if it does
std::string fault_of_model(std::string_view script, std::string_view model);

/// Returns the bits, at most 64, of the constant `name` in a model that satisfies its script; 0 if
/// it is omitted.
std::uint64_t word_in_model(std::string_view model, std::string_view name);

}  // namespace fixproof::proof
