/// @file
/// The JSON type of every file that the project writes.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace fixproof::support {

/// Keeps the members of an object in the order in which they were added.
using Json = nlohmann::ordered_json;

/// The text of a JSON file. Invalid UTF-8 is replaced, because file names may contain it.
inline std::string json_text(const Json& json) {
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace fixproof::support
