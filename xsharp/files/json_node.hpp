/// @file
/// Strict reading of JSON: every violation is an error with its position in the file.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "xsharp/triple.hpp"

namespace xsharp {

/// A value in a document and its path, such as objects[2].spin.tenths.
class JsonNode {
 public:
  using Json = nlohmann::json;
  struct Key {
    std::string_view name;
    std::function<void(const JsonNode&)> read;
  };

  /// @param value must outlive the node and the nodes made from it
  JsonNode(const Json& value, std::string place) : value_(&value), place_(std::move(place)) {}

  [[nodiscard]] const std::string& place() const { return place_; }
  [[nodiscard]] bool is_text() const { return value_->is_string(); }
  [[nodiscard]] bool is_list() const { return value_->is_array(); }
  [[nodiscard]] bool has(std::string_view key) const {
    return value_->is_object() && value_->contains(key);
  }

  // Each throws SceneError, with the path and what is allowed, for a value of another kind.
  [[nodiscard]] bool flag() const;
  [[nodiscard]] std::int32_t whole(std::int32_t least = INT32_MIN,
                                   std::int32_t most = INT32_MAX) const;
  [[nodiscard]] double number() const;
  [[nodiscard]] std::string text() const;
  [[nodiscard]] Triple triple() const;
  [[nodiscard]] std::vector<JsonNode> list() const;
  [[nodiscard]] std::vector<JsonNode> list_of(std::size_t count) const;
  /// The index of the value in `words`.
  [[nodiscard]] std::size_t word(std::span<const std::string_view> words) const;
  [[nodiscard]] std::size_t word(std::initializer_list<std::string_view> words) const {
    return word(std::span(words.begin(), words.size()));
  }

  /// Calls `read` for every key that is present, in the order of `keys`.
  /// @throws SceneError for any other key
  void object(std::initializer_list<Key> keys) const;
  /// @throws SceneError if `key` is missing
  void require(std::string_view key) const;

  /// @throws SceneError "place: wrong"
  [[noreturn]] void refuse(const std::string& wrong) const;

 private:
  [[noreturn]] void must_be(const std::string& demand) const;

  const Json* value_;
  std::string place_;
};

}  // namespace xsharp
