/// @file
/// Command lines that trace or repeat one case.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "cases/plan.hpp"
#include "cases/variant.hpp"

namespace fixproof::verify {

std::string trace_line(const cases::Variant& variant, std::span<const std::uint32_t> words);

/// Returns the command that runs the case again: `fixproof eval` if the judged party has the
/// variant, otherwise `fixproof verify --case`.
std::string replay(const cases::Row& row, std::span<const std::uint32_t> words);

}  // namespace fixproof::verify
