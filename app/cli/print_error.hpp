/// @file
/// The error lines of the command.
#pragma once

#include <stdexcept>
#include <string_view>

namespace fixproof::cli {

/// Writes `fixproof: MESSAGE` as one line to stderr, made printable, because a message may quote a
/// file name or a file. It never fails: see support/error_text.hpp.
void print_error(std::string_view message) noexcept;

/// Standard output cannot be written.
struct OutputLost : std::runtime_error {
  OutputLost() : std::runtime_error("cannot write standard output") {}
};

}  // namespace fixproof::cli
