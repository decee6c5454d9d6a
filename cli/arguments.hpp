/// @file
/// What an option may be given, shared by the commands.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace fixproof::cli {

/// A whole number in decimal; to be given to transform(). CLI11 itself takes -1 for the largest
/// unsigned number and 010 for eight: it is handed digits that it cannot misread.
CLI::Validator whole_number(std::uint64_t first, std::uint64_t last);

/// An option that is given says something: a script's empty variable is not taken for none.
CLI::Validator not_empty();

}  // namespace fixproof::cli
