/// @file
/// Convex bodies from Wavefront OBJ.
#pragma once

#include <filesystem>
#include <string>

#include "xsharp/mesh.hpp"
#include "xsharp/scene_error.hpp"

namespace xsharp {

/// The places (v) and faces (f) of a file of up to 4 MiB, all its groups as one body, in the file's
/// units; texture, normals, materials, lines and points are passed over. Faces keep their first
/// vertex; their order, counterclockwise in OBJ, is turned into that of Face.
/// @throws SceneError naming the file: it cannot be read, a coordinate is missing or no finite
/// number, a face has fewer than 3 or more than longest_polygon vertices or one that is not there,
/// there are no faces, or more vertices or faces than validate_mesh() accepts
Mesh read_obj(const std::filesystem::path& file);

/// The same from the text of a file, without its name.
Mesh parse_obj(const std::string& text);

}  // namespace xsharp
