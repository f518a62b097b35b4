#pragma once
// The objects of a scene as nets of triangles.

#include <glm/mat4x4.hpp>
#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "raster/texture.hpp"
#include "scene/description/scene_description.hpp"
#include "scene/mesh.hpp"

namespace tuberia {

/// What of an object has one material.
struct FramePart {
  Mesh mesh;
  description::Material material;
  std::shared_ptr<const Texture> own_texture{}, own_normals{};  // of kd and relief, from the object's own file; null: the material names them
  float alpha_cutoff = 0;                                       // fragments of less alpha are not drawn
};

/// The parts of an object in object space, with the normals that it wants, and tangents where its material has
/// relief. The texture coordinates are those of the shape times the material's repetitions.
/// Errors: of the shape, the model file or a texture of heights, and relief without texture coordinates. Warnings are
/// appended: of the file's reader, and for colours at vertices that no fragment program reads.
Result<std::vector<FramePart>> parts_of(const SceneDescription& scene, const description::Object& object, std::vector<std::string>& warnings);

/// World from object: the steps, the first one first.
glm::mat4 matrix_of(const std::vector<description::Transform>& steps) noexcept;

/// "object 3 'ball'"
std::string name_of_object(const SceneDescription& scene, const description::Object& object);

}  // namespace tuberia
