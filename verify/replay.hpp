/// @file
/// Command lines that show or repeat one case.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "cases/plan.hpp"
#include "cases/variant.hpp"

namespace fixproof::verify {

/// The `fixproof trace` command for the case.
std::string trace_line(const cases::Variant& variant, std::span<const std::uint32_t> words);

/// The command that asks for the case again: `fixproof eval` of the judged party if it has the
/// variant, otherwise `fixproof verify --case`.
std::string replay(const cases::Row& row, std::span<const std::uint32_t> words);

}  // namespace fixproof::verify
