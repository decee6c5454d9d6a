#include "xsharp/files/parse_json.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "xsharp/scene_error.hpp"

namespace xsharp {
namespace {

using Json = nlohmann::json;

/// Detects duplicate keys and excessive depth. The library's parser would take the last duplicate,
/// and its callbacks take quadratic time for a list of objects.
class DuplicateKeyCheck final : public nlohmann::json_sax<Json> {
 public:
  bool key(std::string& name) override {
    if (open_.back().insert(name).second) return true;
    throw SceneError("the key \"" + name + "\" occurs twice in one object");
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
  bool binary(Json::binary_t& /*value*/) override { return true; }
  bool start_array(std::size_t /*elements*/) override { return deeper(); }
  bool end_array() override {
    --depth_;
    return true;
  }
  bool parse_error(std::size_t /*at*/, const std::string& /*token*/,
                   const Json::exception& /*error*/) override {
    return false;  // the parser has the better message
  }

 private:
  /// Deep nesting never occurs in a scene, and could overflow the stack of a reader.
  bool deeper() {
    constexpr int max_depth = 16;
    if (++depth_ > max_depth) throw SceneError("nested too deeply");
    return true;
  }

  std::vector<std::set<std::string>> open_;
  int depth_ = 0;
};

}  // namespace

nlohmann::json parse_json(std::string_view text) {
  // The library would take one for the end.
  if (text.find('\0') != std::string_view::npos) throw SceneError("not JSON: a zero byte");
  DuplicateKeyCheck twice;
  Json::sax_parse(text, &twice, Json::input_format_t::json, true, true);
  try {
    return Json::parse(text, nullptr, true, true);
  } catch (const Json::exception& error) {
    // Removes the library's label, "[json.exception...] ".
    const std::string what = error.what();
    throw SceneError("not JSON: " + what.substr(std::min(what.find("] ") + 2, what.size())));
  }
}

}  // namespace xsharp
