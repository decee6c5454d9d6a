// Target `obj_file`: the input as Wavefront OBJ. It is refused with a SceneError, or it gives a
// mesh, which written out as OBJ gives the same mesh again.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>

#include "fuzz/finding.hpp"
#include "xsharp/files/obj.hpp"

namespace {

std::string text_of(const xsharp::Mesh& mesh) {
  std::string text;
  for (const auto& [x, y, z] : mesh.vertices) text += fmt::format("v {} {} {}\n", x, y, z);
  for (const auto& face : mesh.faces) {
    // OBJ runs the other way round from the first vertex.
    auto corners = face.vertices;
    std::reverse(corners.begin() + 1, corners.end());
    text += 'f';
    for (const std::size_t corner : corners) text += fmt::format(" {}", corner + 1);
    text += '\n';
  }
  return text;
}

/// As near as the library reads decimals; it leaves magnitudes far from 1 to chance.
bool same_place(const xsharp::Triple& a, const xsharp::Triple& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) {
    const double size = std::abs(x);
    return size < 1e-6 || size > 1e6 || std::abs(x - y) <= size * 1e-9;
  });
}

bool same(const xsharp::Mesh& a, const xsharp::Mesh& b) {
  return std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
                    same_place) &&
         std::equal(a.faces.begin(), a.faces.end(), b.faces.begin(), b.faces.end(),
                    [](const auto& x, const auto& y) { return x.vertices == y.vertices; });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  try {
    const xsharp::Mesh mesh = xsharp::parse_obj(text);
    if (!same(xsharp::parse_obj(text_of(mesh)), mesh)) {
      fixproof::fuzz::report_finding("another mesh once written out:\n" + text_of(mesh));
    }
  } catch (const xsharp::SceneError&) {
    // Refused, as it may be.
  } catch (const std::exception& error) {
    fixproof::fuzz::report_finding(fmt::format("not a SceneError: {}", error.what()));
  }
  return 0;
}
