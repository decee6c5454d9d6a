/// @file
/// The JSON type of all files that the project writes.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

/// Writes an empty optional as null. nlohmann does so itself from version 3.12 on.
template <class T>
requires(NLOHMANN_JSON_VERSION_MAJOR == 3 &&
         NLOHMANN_JSON_VERSION_MINOR < 12) struct nlohmann::adl_serializer<std::optional<T>> {
  template <class Json>
  static void to_json(Json& json, const std::optional<T>& value) {
    value ? json = *value : json = nullptr;
  }
};

namespace fixproof::support {

/// Keeps the members of an object in insertion order. A type T with a function
/// `to_json(Json&, const T&)` in its namespace converts to Json, as do lists and optionals of T.
using Json = nlohmann::ordered_json;

/// Returns the text of a JSON file. Replaces invalid UTF-8, because file names may contain it.
inline std::string json_text(const Json& json) {
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace fixproof::support
