#include "xsharp/files/scene_json.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/bounded_file.hpp"
#include "xsharp/files/json_node.hpp"
#include "xsharp/files/light_json.hpp"
#include "xsharp/files/obj.hpp"
#include "xsharp/files/parse_json.hpp"
#include "xsharp/files/surface_json.hpp"
#include "xsharp/normals.hpp"
#include "xsharp/shapes.hpp"
#include "xsharp/text_of.hpp"
#include "xsharp/validate.hpp"

namespace xsharp {
namespace {

std::array<std::int32_t, 3> three_whole(const JsonNode& node, std::int32_t least,
                                        std::int32_t most) {
  const auto numbers = node.list_of(3);
  return {numbers[0].whole(least, most), numbers[1].whole(least, most),
          numbers[2].whole(least, most)};
}

/// An angle for CosSin, which takes 16 bits.
std::int32_t tenths(const JsonNode& node) { return node.whole(INT16_MIN, INT16_MAX); }

std::array<std::int32_t, 3> three_tenths(const JsonNode& node) {
  return three_whole(node, INT16_MIN, INT16_MAX);
}

std::array<std::int32_t, 3> page(const JsonNode& node) {
  return three_whole(node, -max_page, max_page);
}

/// The size of a body about its origin.
double size(const JsonNode& node) {
  const double value = node.number();
  if (value <= 0) node.refuse(detail::text_of("must be above 0, not ", value));
  return value;
}

std::uint8_t byte(const JsonNode& node) { return static_cast<std::uint8_t>(node.whole(0, 255)); }

/// A paint: 17, a palette index; "#rrggbb" or [red, green, blue], a colour.
Paint paint(const JsonNode& node) {
  if (node.is_list()) {
    const auto parts = node.list_of(3);
    return {false, 0, {byte(parts[0]), byte(parts[1]), byte(parts[2])}};
  }
  if (!node.is_text()) return {true, byte(node), {}};
  const std::string text = node.text();
  std::uint32_t value = 0;
  const char* const end = text.data() + text.size();
  if (text.size() != 7 || text[0] != '#' ||
      std::from_chars(text.data() + 1, end, value, 16).ptr != end) {
    node.refuse("a colour is written \"#rrggbb\", not \"" + text + '"');
  }
  return {false,
          0,
          {static_cast<std::uint8_t>(value >> 16U), static_cast<std::uint8_t>(value >> 8U & 0xFFU),
           static_cast<std::uint8_t>(value & 0xFFU)}};
}

Delay delay(const JsonNode& node) {
  const auto counts = node.list_of(2);
  return {counts[0].whole(1), counts[1].whole(1)};
}

Spin spin(const JsonNode& node) {
  Spin read;
  node.require("tenths");
  node.object({{"tenths", [&](const JsonNode& value) { read.tenths = three_tenths(value); }},
               {"delay", [&](const JsonNode& value) { read.delay = delay(value); }}});
  return read;
}

Drift drift(const JsonNode& node) {
  Drift read;
  node.require("step");
  node.object({{"step", [&](const JsonNode& value) { read.step = value.triple(); }},
               {"stop_z", [&](const JsonNode& value) { read.stop_z = value.number(); }},
               {"bounce_z",
                [&](const JsonNode& value) {
                  const auto ends = value.list_of(2);
                  read.bounce_z = Bounds{ends[0].number(), ends[1].number()};
                }},
               {"delay", [&](const JsonNode& value) { read.delay = delay(value); }}});
  return read;
}

Orbit orbit(const JsonNode& node) {
  Orbit read;
  node.require("radius");
  node.object({{"about", [&](const JsonNode& value) { read.about = value.triple(); }},
               {"radius", [&](const JsonNode& value) { read.radius = value.number(); }},
               {"start_tenths", [&](const JsonNode& value) { read.start_tenths = tenths(value); }},
               {"step_tenths", [&](const JsonNode& value) { read.step_tenths = tenths(value); }},
               {"tilt_tenths", [&](const JsonNode& value) { read.tilt_tenths = tenths(value); }}});
  return read;
}

Camera camera(const JsonNode& node) {
  Camera read;
  node.object(
      {{"page", [&](const JsonNode& value) { read.page = page(value); }},
       {"position", [&](const JsonNode& value) { read.position = value.triple(); }},
       {"turn_tenths", [&](const JsonNode& value) { read.turn_tenths = three_tenths(value); }},
       {"look_at", [&](const JsonNode& value) { read.look_at = value.triple(); }}});
  return read;
}

ArithmeticChoice arithmetic(const JsonNode& node) {
  ArithmeticChoice read;
  node.object({{"by", [&](const JsonNode& value) { read.by = value.text(); }},
               {"target", [&](const JsonNode& value) { read.target = value.text(); }},
               {"mul_round", [&](const JsonNode& value) { read.mul_round = value.flag(); }},
               {"div_round", [&](const JsonNode& value) { read.div_round = value.flag(); }},
               {"repaired", [&](const JsonNode& value) { read.repaired = value.flag(); }}});
  if (read.repaired && !can_be_repaired(read)) {
    node.refuse("repaired is for the target i8088: only its ConcatXforms loses a carry");
  }
  return read;
}

/// A mesh and, for checks, the number of faces around a ball.
struct Shape {
  Mesh mesh;
  std::optional<std::size_t> faces_around{};
};

/// The folder of the files that the text names, and the bodies of those read so far.
struct Files {
  std::filesystem::path folder;
  std::map<std::string, Mesh> read{};
};

Shape shape(const JsonNode& node, Files& files) {
  std::vector<Shape> read;
  node.object({{"cube",
                [&](const JsonNode& value) {
                  value.require("half_edge");
                  value.object({{"half_edge", [&](const JsonNode& half_edge) {
                                   read.push_back({cube(size(half_edge))});
                                 }}});
                }},
               {"obj",
                [&](const JsonNode& value) {
                  const std::string file = value.text();
                  try {
                    if (!files.read.contains(file)) {
                      files.read.emplace(file, read_obj(files.folder, file));
                    }
                    read.push_back({files.read.at(file)});
                  } catch (const SceneError& error) {
                    value.refuse(error.what());
                  }
                }},
               {"ball", [&](const JsonNode& value) {
                  double radius = 0;
                  std::int32_t bands = 0;
                  value.require("radius");
                  value.require("bands");
                  value.object({{"radius", [&](const JsonNode& number) { radius = size(number); }},
                                {"bands", [&](const JsonNode& number) {
                                   bands = number.whole(2, max_bands);
                                 }}});
                  read.push_back({ball(radius, bands), static_cast<std::size_t>(2 * bands)});
                }}});
  if (read.size() != 1) node.refuse("must have one key: cube, ball or obj");
  return std::move(read[0]);
}

/// How the paints of an object are given.
struct Paints {
  enum class Kind { none, each, all, checks } kind = Kind::none;
  std::vector<Paint> list;
};

/// A partly read object: first from `defaults`, then from the object.
struct Draft {
  ObjectDescription object;
  std::optional<Shape> shape;
  Paints paints;
  /// One from `shading` for all faces, or one per face from `shadings`.
  std::vector<Shading> shadings{};
  bool shadings_are_each = false;
};

void read_draft(const JsonNode& node, Files& files, Draft& draft) {
  ObjectDescription& object = draft.object;
  if (node.has("paint") + node.has("paints") + node.has("checks") > 1) {
    node.refuse("must have one of paint, paints and checks");
  }
  if (node.has("shading") && node.has("shadings")) {
    node.refuse("must have one of shading and shadings");
  }
  const auto shadings = [&](bool are_each, const std::vector<JsonNode>& nodes) {
    draft.shadings.clear();
    for (const JsonNode& element : nodes) draft.shadings.push_back(shading(element));
    draft.shadings_are_each = are_each;
  };
  const auto paints = [&](Paints::Kind kind, const std::vector<JsonNode>& nodes) {
    draft.paints = {kind, {}};
    for (const JsonNode& element : nodes) draft.paints.list.push_back(paint(element));
  };
  node.object(
      {{"name", [&](const JsonNode& value) { object.name = value.text(); }},
       {"shape", [&](const JsonNode& value) { draft.shape = shape(value, files); }},
       {"paint", [&](const JsonNode& value) { paints(Paints::Kind::all, {value}); }},
       {"paints", [&](const JsonNode& value) { paints(Paints::Kind::each, value.list()); }},
       {"checks", [&](const JsonNode& value) { paints(Paints::Kind::checks, value.list_of(2)); }},
       {"shading", [&](const JsonNode& value) { shadings(false, {value}); }},
       {"shadings", [&](const JsonNode& value) { shadings(true, value.list()); }},
       {"surface", [&](const JsonNode& value) { object.surface = surface(value); }},
       {"page", [&](const JsonNode& value) { object.page = page(value); }},
       {"position", [&](const JsonNode& value) { object.position = value.triple(); }},
       {"spin", [&](const JsonNode& value) { object.spin = spin(value); }},
       {"drift", [&](const JsonNode& value) { object.drift = drift(value); }},
       {"orbit", [&](const JsonNode& value) { object.orbit = orbit(value); }},
       {"look_at", [&](const JsonNode& value) { object.look_at = value.triple(); }}});
}

ObjectDescription finished(const JsonNode& node, Draft draft) {
  if (!draft.shape) node.refuse("must have the key \"shape\"");
  ObjectDescription& object = draft.object;
  const std::size_t faces = draft.shape->mesh.faces.size();
  switch (draft.paints.kind) {
    case Paints::Kind::none:
      node.refuse("must have one of paint, paints and checks");
    case Paints::Kind::each:
      object.paints = std::move(draft.paints.list);
      break;
    case Paints::Kind::all:
      object.paints.assign(faces, draft.paints.list[0]);
      break;
    case Paints::Kind::checks:
      if (!draft.shape->faces_around) node.refuse("only a ball has checks");
      for (std::size_t face = 0; face < faces; ++face) {
        const std::size_t around = *draft.shape->faces_around;
        object.paints.push_back(draft.paints.list[(face / around + face % around) % 2]);
      }
      break;
  }
  if (draft.shadings_are_each) {
    if (draft.shadings.empty()) node.refuse("shadings must have one for each face");
    object.shadings = std::move(draft.shadings);
  } else if (!draft.shadings.empty()) {
    object.shadings.assign(faces, draft.shadings[0]);
  }
  object.mesh = std::move(draft.shape->mesh);
  // Vertex normals first: an object's own vertices come first, then the ends of their normals.
  if (needs_normals(object.surface)) object.mesh = with_vertex_normals(std::move(object.mesh));
  object.mesh = with_normals(std::move(object.mesh), [&object](std::size_t face) {
    return face < object.shadings.size() && needs_normals(object.shadings[face]);
  });
  return std::move(object);
}

Scene scene(const JsonNode& node, const std::filesystem::path& folder) {
  Scene read;
  Files files{folder};
  Draft defaults;
  std::vector<ObjectDescription>& objects = read.objects;
  node.require("objects");
  node.object(
      {{"name", [&](const JsonNode& value) { read.name = value.text(); }},
       {"width", [&](const JsonNode& value) { read.width = value.whole(narrowest, longest_side); }},
       {"height", [&](const JsonNode& value) { read.height = value.whole(1, longest_side); }},
       {"frames_per_second",
        [&](const JsonNode& value) { read.frames_per_second = value.number(); }},
       {"projection_ratio", [&](const JsonNode& value) { read.projection_ratio = value.number(); }},
       {"conversion",
        [&](const JsonNode& value) {
          read.conversion = std::array{Conversion::published,
                                       Conversion::nearest}[value.word({"published", "nearest"})];
        }},
       {"trigonometry",
        [&](const JsonNode& value) {
          read.trigonometry = std::array{Trigonometry::floating,
                                         Trigonometry::table}[value.word({"floating", "table"})];
        }},
       {"depth_key",
        [&](const JsonNode& value) {
          read.depth_key =
              std::array{DepthKey::none, DepthKey::center, DepthKey::nearest,
                         DepthKey::farthest}[value.word({"none", "center", "nearest", "farthest"})];
        }},
       {"palette",
        [&](const JsonNode& value) {
          read.palette = std::array{
              PaletteKind::vga, PaletteKind::shading, PaletteKind::shading_gamma,
              PaletteKind::ramps}[value.word({"vga", "shading", "shading-gamma", "ramps"})];
        }},
       {"background", [&](const JsonNode& value) { read.background = byte(value); }},
       {"depth_buffer",
        [&](const JsonNode& value) {
          read.depth_buffer = static_cast<DepthBuffering>(value.word(depth_buffer_words));
        }},
       {"depth_measure",
        [&](const JsonNode& value) {
          read.depth_measure = static_cast<DepthMeasure>(value.word(depth_measure_words));
        }},
       {"near", [&](const JsonNode& value) { read.near = value.number(); }},
       {"arithmetic", [&](const JsonNode& value) { read.arithmetic = arithmetic(value); }},
       {"restore_every", [&](const JsonNode& value) { read.restore_every = value.whole(0); }},
       {"restore_rows",
        [&](const JsonNode& value) {
          read.restore_rows = static_cast<RestoredRows>(value.word(restored_rows_words));
        }},
       {"from_scratch", [&](const JsonNode& value) { read.from_scratch = value.flag(); }},
       {"camera", [&](const JsonNode& value) { read.camera = camera(value); }},
       {"lights", [&](const JsonNode& value) { read.lights = lights(value); }},
       {"defaults", [&](const JsonNode& value) { read_draft(value, files, defaults); }},
       {"objects", [&](const JsonNode& value) {
          std::size_t faces = 0;
          std::size_t vertices = 0;
          for (const JsonNode& element : value.list()) {
            Draft draft = defaults;
            draft.object.name = "object " + std::to_string(objects.size());
            read_draft(element, files, draft);
            objects.push_back(finished(element, std::move(draft)));
            // validate() checks this too, but a small text can make a scene that does not fit in
            // memory.
            const ObjectDescription& last = objects.back();
            faces += last.mesh.faces.size();
            vertices += last.mesh.vertices.size();
            if (objects.size() > max_objects || faces > max_faces_in_scene ||
                vertices > max_vertices_in_scene || last.paints.size() != last.mesh.faces.size() ||
                last.shadings.size() > last.mesh.faces.size()) {
              break;
            }
          }
        }}});
  for (const auto& [file, mesh] : files.read) read.files.push_back((files.folder / file).string());
  return read;
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& name,
                  const std::filesystem::path& folder) {
  const nlohmann::json document = parse_json(text);
  Scene read = scene({document, ""}, folder);
  if (read.name.empty()) read.name = name;
  validate(read);
  return read;
}

Scene read_scene(const std::filesystem::path& file) {
  try {
    const std::string text = fixproof::support::read_bounded(file.string(), std::size_t{16} << 20U);
    Scene read =
        parse_scene(text, file.stem().string(), file.has_parent_path() ? file.parent_path() : ".");
    read.files.push_back(file.string());
    return read;
  } catch (const std::runtime_error& error) {
    throw SceneError(file.string() + ": " + error.what());
  }
}

}  // namespace xsharp
