#pragma once
// Model files into memory, through Assimp.

#include <filesystem>

#include "base/result.hpp"
#include "scene/model.hpp"

namespace tuberia {

/// The model in a file of any format that Assimp reads: OBJ, glTF, GLB, PLY, 3DS, Collada, OFF,
/// STL and others. All meshes come in one object space (the nodes' transforms are applied), with
///  * polygons cut into triangles, none of these left out, even those without an area; points and
///    lines are left out, with a warning;
///  * identical vertices joined; normals always there, smooth ones where the file has none;
///  * texture coordinates with (0, 0) in the upper left corner of the image, v down: Assimp gives
///    them from the lower left corner in every format, and its aiProcess_FlipUVs turns that round;
///  * colours linear, see Material; textures as sRGB codes, only those of the diffuse colour.
/// Textures are looked for by their name relative to the model's folder, then by the bare file
/// name in that folder, upper and lower case alike, so that paths of other machines do no harm;
/// one that is not found or cannot be read becomes a checker, with a warning.
///
/// Errors, one line each: the file is missing, a folder, empty, of an unknown format, corrupt or
/// truncated as far as that can be seen, without triangles, has an index out of range or a
/// position that is not finite, or claims more than memory holds.
Result<Model> load_model(const std::filesystem::path& path);

}  // namespace tuberia
