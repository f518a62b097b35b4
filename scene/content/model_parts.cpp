#include "scene/content/model_parts.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "math/transforms.hpp"
#include "scene/description/model_material.hpp"
#include "scene/load_model.hpp"
#include "scene/mesh_editing.hpp"

namespace tuberia {
namespace {

void move_to_unit_sphere(Model& model) {
  const glm::vec3 centre = model.bounds().centre();
  float radius = 0;
  for (const Mesh& mesh : model.meshes)
    for (const glm::vec3& position : mesh.positions) radius = std::max(radius, glm::distance(position, centre));
  const double factor = radius > 0 ? 1.0 / static_cast<double>(radius) : 1.0;
  const glm::mat4 unit_from_object = compose(scaling(glm::dvec3(factor)), translation(-glm::dvec3(centre)));
  for (Mesh& mesh : model.meshes) mesh = transformed(std::move(mesh), unit_from_object);
}

/// One texture of a model; null for the index -1.
std::shared_ptr<const Image<Rgba8>> model_texture(const Model& model, int index) {
  if (index < 0) return nullptr;
  return std::make_shared<const Image<Rgba8>>(model.textures[static_cast<std::size_t>(index)].image);
}

/// A model's material, made once for all of its meshes.
std::vector<ContentPart> materials_of_model(const SceneDescription& scene, const Model& model) {
  std::vector<ContentPart> materials;
  for (const Material& own : model.materials) {
    ContentPart& part = materials.emplace_back(ContentPart{.mesh = {}, .material = description_of(own, scene.environment.has_value())});
    part.own_texture = model_texture(model, own.texture);
    part.own_normals = model_texture(model, own.normal_texture);
    part.alpha_cutoff = own.alpha_cutoff;
    if (part.own_normals) {
      part.material.bump.emplace();
      part.material.bump->kind = description::Bump::Kind::normal_map;
      part.material.bump->gain = static_cast<double>(own.normal_scale);
    }
  }
  return materials;
}

}  // namespace

Result<std::vector<ContentPart>> parts_of_model(const SceneDescription& scene, const description::ModelFile& shape, const description::Material& material,
                                              std::vector<std::string>& warnings) {
  auto model = load_model(file_of(scene, shape.file));
  if (!model) return model.error();
  warnings.insert(warnings.end(), model->warnings.begin(), model->warnings.end());
  if (shape.unit_size) move_to_unit_sphere(*model);
  const auto own = shape.own_materials ? materials_of_model(scene, *model) : std::vector<ContentPart>();
  std::vector<ContentPart> parts;
  for (Mesh& mesh : model->meshes) {
    const auto index = static_cast<std::size_t>(mesh.material);
    ContentPart part = index < own.size() ? own[index] : ContentPart{.mesh = {}, .material = material};
    if (mesh.texcoords.empty() && index < own.size()) {
      part.own_texture = part.own_normals = nullptr;
      part.material.bump.reset();
    }
    part.mesh = std::move(mesh);
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace tuberia
