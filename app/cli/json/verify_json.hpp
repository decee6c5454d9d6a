/// @file
/// The results of `fixproof verify` and `merge` as JSON.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "support/json.hpp"
#include "verify/cases/variant.hpp"
#include "verify/report.hpp"

namespace fixproof::cli {

support::Json verify_json(const verify::Report& report);

/// The answers of all parties to one case.
struct AskedCase {
  cases::Variant variant;
  std::vector<std::uint32_t> words;
  std::vector<std::pair<std::string, std::string>> said;
  bool equal = false;
};
support::Json asked_json(const std::vector<AskedCase>& asked);

}  // namespace fixproof::cli
