/// @file
/// The forms of instructions that the model has, as a table in Markdown.
#pragma once

#include <string>

namespace fixproof::cli {

/// One row for each form: operands, encodings, flags and clocks.
std::string forms_text();

}  // namespace fixproof::cli
