// Target `obj_file`: the input as Wavefront OBJ. It must raise a SceneError or give a mesh that
// survives writing as OBJ and reading back.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>

#include "fuzz/finding.hpp"
#include "xsharp/files/obj.hpp"

namespace {

std::string text_of(const xsharp::Mesh& mesh) {
  std::string text;
  for (const auto& [x, y, z] : mesh.vertices) text += fmt::format("v {} {} {}\n", x, y, z);
  for (const auto& face : mesh.faces) {
    // OBJ has the reverse order and the same first vertex.
    auto corners = face.vertices;
    std::reverse(corners.begin() + 1, corners.end());
    text += 'f';
    for (const std::size_t corner : corners) text += fmt::format(" {}", corner + 1);
    text += '\n';
  }
  return text;
}

/// Allows for rounding in the library, which multiplies by rounded powers of ten.
bool same_place(const xsharp::Triple& a, const xsharp::Triple& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) {
    return std::abs(x - y) <= std::max(1e-6, std::abs(x) * 1e-9);
  });
}

bool same(const xsharp::Mesh& a, const xsharp::Mesh& b) {
  return std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
                    same_place) &&
         std::equal(a.faces.begin(), a.faces.end(), b.faces.begin(), b.faces.end(),
                    [](const auto& x, const auto& y) { return x.vertices == y.vertices; });
}

std::optional<xsharp::Mesh> mesh_of(const std::string& text) {
  try {
    return xsharp::parse_obj(text);
  } catch (const xsharp::SceneError&) {
    // A SceneError is allowed.
  } catch (const std::exception& error) {
    fixproof::fuzz::report_finding(fmt::format("not a SceneError: {}", error.what()));
  }
  return std::nullopt;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto mesh = mesh_of(std::string(data, data + size));
  if (!mesh) return 0;
  const std::string written = text_of(*mesh);
  const auto again = mesh_of(written);
  if (!again) fixproof::fuzz::report_finding("refused once written out:\n" + written);
  if (!same(*again, *mesh)) {
    fixproof::fuzz::report_finding("another mesh once written out:\n" + written);
  }
  return 0;
}
