/// @file
/// JSON as it is written to files.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace fixproof::support {

/// Bytes that are no UTF-8 are replaced: what is named after a file may have them.
inline std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace fixproof::support
