#pragma once
// Shapes as nets of triangles.

#include "base/result.hpp"
#include "scene/description/scene_description.hpp"
#include "scene/mesh.hpp"

namespace tuberia {

/// A shape in object space, with the normals and texture coordinates of the surface that it stands for. Errors: of the
/// shape's own mesh, a texture of heights that is not there or cannot be read, model files, which are several meshes, and
/// shapes that only rays can meet.
Result<Mesh> mesh_of_shape(const SceneDescription& scene, const description::Shape& shape);

}  // namespace tuberia
