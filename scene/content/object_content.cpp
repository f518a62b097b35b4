#include "scene/content/object_content.hpp"

#include <numbers>

#include "scene/content/model_parts.hpp"
#include "scene/content/shape_meshes.hpp"
#include "scene/mesh_editing.hpp"
#include "scene/sphere_mapping.hpp"
#include "scene/vertex_normals.hpp"

namespace tuberia {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

Result<std::vector<ContentPart>> shaped(const SceneDescription& scene, const description::Object& object, std::vector<std::string>& warnings) {
  const auto material = material_of(scene, object);
  if (!material) return material.error();
  if (const auto* file = std::get_if<description::ModelFile>(&object.shape)) return parts_of_model(scene, *file, *material, warnings);
  auto mesh = mesh_of_shape(scene, object.shape);
  if (!mesh) return mesh.error();
  std::vector<ContentPart> parts;
  parts.push_back({.mesh = *std::move(mesh), .material = *material});
  return parts;
}

/// The normals that the object wants, and what its material needs.
Result<Mesh> finished(Mesh mesh, const description::Object& object, const description::Material& material) {
  if (object.normals == description::Normals::facet) mesh = with_facet_normals(std::move(mesh));
  if (object.normals == description::Normals::averaged) {
    auto averaged = with_vertex_normals(std::move(mesh), {.crease_angle_radians = object.crease_degrees * kRadiansPerDegree});
    if (!averaged) return averaged;
    mesh = *std::move(averaged);
  }
  const description::Mapping& mapping = material.mapping;
  if (mapping.kind == description::Mapping::Kind::sphere) {
    const auto sphere = sphere_mapping({.pole = mapping.pole, .equator = mapping.equator}, mapping.of_positions);
    if (!sphere) return sphere.error();
    auto mapped = with_texture_mapping(std::move(mesh), *sphere);
    if (!mapped) return mapped;
    mesh = *std::move(mapped);
  }
  if (material.bump && mesh.tangents.empty()) {
    auto with = with_tangents(std::move(mesh));
    if (!with) return with;
    mesh = *std::move(with);
  }
  return mapping.repeat == glm::dvec2(1) ? Result<Mesh>(std::move(mesh)) : with_repeated_texture(std::move(mesh), mapping.repeat);
}

}  // namespace

Result<description::Material> material_of(const SceneDescription& scene, const description::Object& object) {
  const description::Material* named = find_material(scene, object.material);
  if (named == nullptr && !object.material.empty()) return Error{"there is no material '" + object.material + "'"};
  return named != nullptr ? *named : description::Material{};
}

Result<std::vector<ContentPart>> content_of(const SceneDescription& scene, const description::Object& object, std::vector<std::string>& warnings) {
  auto parts = shaped(scene, object, warnings);
  if (!parts) return Error{name_of_object(scene, object) + ": " + parts.error().message};
  for (ContentPart& part : *parts) {
    auto mesh = finished(std::move(part.mesh), object, part.material);
    if (!mesh) return Error{name_of_object(scene, object) + ": " + mesh.error().message};
    part.mesh = *std::move(mesh);
  }
  return parts;
}

std::string name_of_object(const SceneDescription& scene, const description::Object& object) {
  const auto index = static_cast<std::size_t>(&object - scene.objects.data());
  return "object " + std::to_string(index) + (object.name.empty() ? "" : " '" + object.name + "'");
}

}  // namespace tuberia
