#pragma once
// The objects of a scene as nets of triangles with materials, for whoever draws or traces them.

#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "image/image.hpp"
#include "scene/description/scene_description.hpp"
#include "scene/mesh.hpp"

namespace tuberia {

/// What of an object has one material.
struct ContentPart {
  Mesh mesh;
  description::Material material;
  std::shared_ptr<const Image<Rgba8>> own_texture{};  // of kd, from the object's own file, sRGB codes; null: the material names it
  std::shared_ptr<const Image<Rgba8>> own_normals{};  // of its relief, as Bump::normal_map has them, linear codes
  float alpha_cutoff = 0;                             // where own_texture has less alpha there is a hole
};

/// The material that an object names, or the default one. Error for a name that is not there.
Result<description::Material> material_of(const SceneDescription& scene, const description::Object& object);

/// The parts of an object in object space, with the normals that it wants, and tangents where its material has
/// relief. The texture coordinates are those of the shape times the material's repetitions.
/// Errors: of the shape, the model file or a texture of heights, and relief without texture coordinates; they name the
/// object. Warnings of the file's reader are appended.
Result<std::vector<ContentPart>> content_of(const SceneDescription& scene, const description::Object& object, std::vector<std::string>& warnings);

/// "object 3 'ball'"
std::string name_of_object(const SceneDescription& scene, const description::Object& object);

}  // namespace tuberia
