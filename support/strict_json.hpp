/// @file
/// Detects JSON that the library's parser would accept and silently change.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace fixproof::support {

/// Finds duplicate keys and excessive depth. The library's parser would take the last duplicate,
/// and its callbacks take quadratic time for a list of objects.
class StrictJsonCheck final : public nlohmann::json_sax<nlohmann::json> {
 public:
  bool key(std::string& name) override {
    if (open_.back().insert(name).second) return true;
    throw std::runtime_error("the key \"" + name + "\" occurs twice in one object");
  }
  bool start_object(std::size_t /*keys*/) override {
    open_.emplace_back();
    return deeper();
  }
  bool end_object() override {
    open_.pop_back();
    --depth_;
    return true;
  }
  bool null() override { return true; }
  bool boolean(bool /*value*/) override { return true; }
  bool number_integer(std::int64_t /*value*/) override { return true; }
  bool number_unsigned(std::uint64_t /*value*/) override { return true; }
  bool number_float(double /*value*/, const std::string& /*text*/) override { return true; }
  bool string(std::string& /*value*/) override { return true; }
  bool binary(nlohmann::json::binary_t& /*value*/) override { return true; }
  bool start_array(std::size_t /*elements*/) override { return deeper(); }
  bool end_array() override {
    --depth_;
    return true;
  }
  bool parse_error(std::size_t /*at*/, const std::string& /*token*/,
                   const nlohmann::json::exception& /*error*/) override {
    return false;  // the parser has the better message
  }

 private:
  /// Deep nesting never occurs in the project's files, and could overflow the stack of a reader.
  bool deeper() {
    constexpr int max_depth = 16;
    if (++depth_ > max_depth) throw std::runtime_error("nested too deeply");
    return true;
  }

  std::vector<std::set<std::string>> open_;
  int depth_ = 0;
};

/// Returns the library's message without its label, "[json.exception...] ".
inline std::string json_message(const nlohmann::json::exception& error) {
  const std::string_view message = error.what();
  const std::size_t label = message.find("] ");
  return std::string(label == std::string_view::npos ? message : message.substr(label + 2));
}

/// Parses JSON, with comments if `comments`. Objects have sorted keys, so an object of many keys
/// takes no quadratic time.
/// @throws std::runtime_error for a zero byte, a duplicate key or excessive depth
/// @throws nlohmann::json::parse_error for text that is not JSON
inline nlohmann::json parse_strictly(std::string_view text, bool comments = false) {
  // The library would take one for the end of the text.
  if (text.find('\0') != std::string_view::npos) throw std::runtime_error("not JSON: a zero byte");
  StrictJsonCheck check;
  nlohmann::json::sax_parse(text, &check, nlohmann::json::input_format_t::json, true, comments);
  return nlohmann::json::parse(text, nullptr, true, comments);
}

}  // namespace fixproof::support
