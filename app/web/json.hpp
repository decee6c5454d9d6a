/// @file
/// Writes JSON text. This writer takes a few hundred bytes; nlohmann/json would take half of the
/// module.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace fixproof::web {

class Json {
 public:
  /// Calls `members`, which writes the members of an object or the elements of an array.
  template <std::invocable Members>
  void object(const Members& members) {
    in('{', '}', members);
  }
  template <std::invocable Members>
  void object(std::string_view name, const Members& members) {
    key(name);
    in('{', '}', members);
  }
  template <std::invocable Elements>
  void array(std::string_view name, const Elements& elements) {
    key(name);
    in('[', ']', elements);
  }

  void element(std::string_view text) {
    separate();
    quote(text);
  }
  void element(std::integral auto value) {
    separate();
    text_ += std::to_string(value);
  }
  void field(std::string_view name, std::string_view text) {
    key(name);
    quote(text);
  }
  void field(std::string_view name, const char* text) { field(name, std::string_view(text)); }
  void field(std::string_view name, bool value) {
    key(name);
    text_ += value ? "true" : "false";
  }
  void field(std::string_view name, std::integral auto value) {
    key(name);
    text_ += std::to_string(value);
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void separate() {
    if (!text_.empty() && text_.back() != '{' && text_.back() != '[' && text_.back() != ':') {
      text_ += ',';
    }
  }
  void key(std::string_view name) {
    separate();
    quote(name);
    text_ += ':';
  }
  template <class Body>
  void in(char open, char close, const Body& body) {
    separate();
    text_ += open;
    body();
    text_ += close;
  }
  void quote(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    text_ += '"';
    for (const char c : text) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte < 0x20) {
        text_ += "\\u00";
        text_ += digits[byte >> 4U];
        text_ += digits[byte & 15U];
        continue;
      }
      if (c == '"' || c == '\\') text_ += '\\';
      text_ += c;
    }
    text_ += '"';
  }

  std::string text_;
};

}  // namespace fixproof::web
