/// @file
/// Reads convex bodies from Wavefront OBJ.
#pragma once

#include <filesystem>
#include <string>

#include "xsharp/mesh.hpp"
#include "xsharp/scene_error.hpp"

namespace xsharp {

/// Reads the vertices (v) and faces (f) of a file of up to 4 MiB in or below a folder, all groups
/// as one body, in the file's units. Ignores texture coordinates, normals, materials, lines and
/// points. Faces keep their first vertex; their order, counterclockwise in OBJ, is reversed to that
/// of Face.
/// @throws SceneError with the file if it cannot be read or leads out of the folder; a coordinate
/// is missing or not a finite number; a face has fewer than 3 or more than max_polygon_vertices
/// vertices, or an invalid one; there are no faces; or there are more vertices or faces than
/// validate_mesh() accepts
Mesh read_obj(const std::filesystem::path& folder, const std::string& file);

/// The same from the text of a file, without the file name in errors.
Mesh parse_obj(const std::string& text);

}  // namespace xsharp
