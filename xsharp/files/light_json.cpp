#include "xsharp/files/light_json.hpp"

namespace xsharp {
namespace {

Highlight highlight(const JsonNode& node) {
  Highlight read;
  node.require("exponent");
  node.require("strength");
  node.object({{"exponent", [&](const JsonNode& value) { read.exponent = value.number(); }},
               {"strength", [&](const JsonNode& value) { read.strength = value.number(); }}});
  return read;
}

Spot spot(const JsonNode& node) {
  Spot read;
  node.require("direction");
  node.require("intensity");
  node.object({{"on", [&](const JsonNode& value) { read.on = value.flag(); }},
               {"direction", [&](const JsonNode& value) { read.direction = value.triple(); }},
               {"intensity", [&](const JsonNode& value) { read.intensity = value.triple(); }}});
  return read;
}

}  // namespace

Shading shading(const JsonNode& node) {
  Shading read;
  node.object({{"ambient", [&](const JsonNode& value) { read.ambient = value.flag(); }},
               {"diffuse", [&](const JsonNode& value) { read.diffuse = value.flag(); }},
               {"highlight", [&](const JsonNode& value) { read.highlight = highlight(value); }}});
  return read;
}

Lights lights(const JsonNode& node) {
  Lights read;
  node.object({{"ambient_on", [&](const JsonNode& value) { read.ambient_on = value.flag(); }},
               {"ambient", [&](const JsonNode& value) { read.ambient = value.triple(); }},
               {"spots", [&](const JsonNode& value) {
                  for (const JsonNode& element : value.list()) read.spots.push_back(spot(element));
                }}});
  return read;
}

}  // namespace xsharp
