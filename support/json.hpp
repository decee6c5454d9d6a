/// @file
/// The JSON type of all files that the project writes.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace fixproof::support {

/// Keeps the members of an object in insertion order.
using Json = nlohmann::ordered_json;

/// Returns the text of a JSON file. Replaces invalid UTF-8, because file names may contain it.
inline std::string json_text(const Json& json) {
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace fixproof::support
