#include "xsharp/files/obj.hpp"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <span>
#include <sstream>
#include <string_view>

#include "support/bounded_file.hpp"
#include "xsharp/text_of.hpp"
#include "xsharp/validate_mesh.hpp"

namespace xsharp {
namespace {

constexpr std::string_view blank = " \t\r";

/// Removes the first word from the line and returns it; empty at the end of the line.
std::string_view next_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(blank), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(blank));
  line.remove_prefix(word.size());
  return word;
}

template <class Number>
bool is_number(std::string_view word, Number& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size();
}

bool is_place(std::string_view word) {
  double value = 0;
  return is_number(word, value) && std::isfinite(value);
}

/// 7, 7/1, 7//3 or 7/1/3: indices of a vertex, a texture coordinate and a normal.
bool is_corner(std::string_view word) {
  for (int part = 0; part < 3; ++part) {
    const std::string_view index = word.substr(0, word.find('/'));
    int value = 0;
    const bool left_out = part == 1 && index.empty() && word.starts_with('/');
    if (!left_out && (!is_number(index, value) || value == 0)) return false;
    if (index.size() == word.size()) return true;
    word.remove_prefix(index.size() + 1);
  }
  return false;
}

/// Checks vertices and faces beforehand, because the library reads an invalid number as 0.
void check_numbers(std::string_view text) {
  std::size_t number = 0;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    text.remove_prefix(line.size());
    text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, text.size()));
    ++number;
    const auto refuse = [number](std::string_view wants, std::string_view word) {
      throw SceneError(
          detail::text_of("line ", number, ": ", wants, ", not \"", word.substr(0, 40), '"'));
    };
    const std::string_view kind = next_word(line);
    if (kind == "v") {
      for (int component = 0; component < 3; ++component) {
        const std::string_view word = next_word(line);
        if (!is_place(word)) refuse("a vertex must have three numbers", word);
      }
    } else if (kind == "f") {
      std::string_view word = next_word(line);
      do {
        if (!is_corner(word)) refuse("a face must have vertex numbers", word);
        word = next_word(line);
      } while (!word.empty());
    }
  }
}

void add_vertex(Mesh& mesh, const Triple& place) {
  // The library does not accept 0e999.
  if (!std::ranges::all_of(place, [](double component) { return std::isfinite(component); })) {
    throw SceneError(detail::text_of("vertex ", mesh.vertices.size() + 1, " is not finite"));
  }
  if (mesh.vertices.size() == max_vertices) {
    throw SceneError(detail::text_of("more than ", max_vertices, " vertices"));
  }
  mesh.vertices.push_back(place);
}

void add_face(Mesh& mesh, std::span<const tinyobj::index_t> corners) {
  const std::size_t number = mesh.faces.size();
  if (number == max_faces) throw SceneError(detail::text_of("more than ", max_faces, " faces"));
  if (corners.size() < 3 || corners.size() > max_polygon_vertices) {
    throw SceneError(detail::text_of("face ", number, " has ", corners.size(),
                                     " vertices, must have 3 to ", max_polygon_vertices));
  }
  Face face;
  for (const tinyobj::index_t& corner : corners) {
    // Counted from 1, or backward from the last vertex so far.
    const auto count = static_cast<std::ptrdiff_t>(mesh.vertices.size());
    const std::ptrdiff_t written = corner.vertex_index;
    const std::ptrdiff_t index = written < 0 ? count + written : written - 1;
    if (index < 0 || index >= count) {
      throw SceneError(
          detail::text_of("face ", number, " has vertex ", written, " of ", count, " so far"));
    }
    face.vertices.push_back(static_cast<std::size_t>(index));
  }
  std::reverse(face.vertices.begin() + 1, face.vertices.end());
  mesh.faces.push_back(std::move(face));
}

}  // namespace

Mesh parse_obj(const std::string& text) {
  if (text.find('\0') != std::string::npos) throw SceneError("a zero byte in the text");
  check_numbers(text);
  Mesh mesh;
  tinyobj::callback_t callbacks;
  callbacks.vertex_cb = [](void* to, double x, double y, double z, double /*w*/) {
    add_vertex(*static_cast<Mesh*>(to), {x, y, z});
  };
  callbacks.index_cb = [](void* to, tinyobj::index_t* corners, int count) {
    add_face(*static_cast<Mesh*>(to), {corners, static_cast<std::size_t>(count)});
  };
  std::istringstream stream(text);
  std::string error;
  // Without a material reader no other file is opened.
  if (!tinyobj::LoadObjWithCallback(stream, callbacks, &mesh, nullptr, nullptr, &error) ||
      !error.empty()) {
    throw SceneError("not a Wavefront OBJ file: " + error);
  }
  if (mesh.faces.empty()) throw SceneError("the file has no faces");
  return mesh;
}

Mesh read_obj(const std::filesystem::path& folder, const std::string& file) {
  if (file.find('\0') != std::string::npos)
    throw SceneError("the name of an OBJ file has a zero byte");
  try {
    return parse_obj(fixproof::support::read_beneath(folder.string(), file, std::size_t{4} << 20U));
  } catch (const std::runtime_error& error) {
    throw SceneError((folder / file).string() + ": " + error.what());
  }
}

}  // namespace xsharp
