/// @file
/// The findings of docs/findings.md, each with its shortest case and what is answered to it here.
#pragma once

#include "support/json.hpp"

namespace fixproof::cli {

/// A list of {number, title, test, says, cases: a list of {who, asked, answer}}; every answer is
/// computed when this is called.
support::Json computed_findings();

}  // namespace fixproof::cli
