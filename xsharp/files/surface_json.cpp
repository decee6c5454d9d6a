#include "xsharp/files/surface_json.hpp"

#include <algorithm>
#include <cstdint>

namespace xsharp {
namespace {

std::uint8_t texel(const JsonNode& node) { return static_cast<std::uint8_t>(node.whole(0, 255)); }

/// {"checker": [1, 2]}
void read_bitmap(const JsonNode& node, Surface& surface) {
  int patterns = 0;
  const auto pattern = [&](Pattern which, const JsonNode& value) {
    const auto texels = value.list_of(2);
    surface.pattern = which;
    surface.texels = {texel(texels[0]), texel(texels[1])};
    ++patterns;
  };
  node.object({{"checker", [&](const JsonNode& value) { pattern(Pattern::checker, value); }},
               {"bricks", [&](const JsonNode& value) { pattern(Pattern::bricks, value); }}});
  if (patterns != 1) node.refuse("must have one key: checker or bricks");
}

/// A whole number of pixels, or "never".
std::int32_t exact_every(const JsonNode& node) {
  if (node.is_text()) return static_cast<std::int32_t>(node.word({"never"}));
  const std::int32_t every = node.whole(1);
  if (std::ranges::find(exact_choices, every) == exact_choices.end()) {
    node.refuse("must be 1, 8, 16 or \"never\"");
  }
  return every;
}

}  // namespace

Surface surface(const JsonNode& node) {
  Surface read;
  node.require("kind");
  node.object(
      {{"kind",
        [&](const JsonNode& value) {
          read.kind = static_cast<SurfaceKind>(value.word(surface_words));
        }},
       {"ramp", [&](const JsonNode& value) { read.ramp = value.whole(0, 1); }},
       {"phong",
        [&](const JsonNode& value) {
          read.phong = static_cast<PhongForm>(value.word(phong_words));
        }},
       {"exact_every", [&](const JsonNode& value) { read.exact_every = exact_every(value); }},
       {"bitmap", [&](const JsonNode& value) { read_bitmap(value, read); }}});
  return read;
}

}  // namespace xsharp
