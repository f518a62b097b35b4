#pragma once
// A scene as plain data: what there is, not how it is drawn. Whoever makes a picture of it, by whatever
// method, reads this.                                                              [C 1.2] [B 1.7]

#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/description/camera.hpp"
#include "scene/description/environment.hpp"
#include "scene/description/light.hpp"
#include "scene/description/material.hpp"
#include "scene/description/shape.hpp"
#include "scene/description/tracing.hpp"
#include "scene/description/transform.hpp"

namespace tuberia {

namespace description {

/// How intensities between vertices are found, where triangles stand for surfaces.  [B 3]
enum class Shading : std::uint8_t { flat, gouraud, dot_product, phong };

/// Which normals vertices get: those of the curved surface itself; of each triangle; or the mean of those
/// that meet at a vertex, of each side of a crease for itself.                       [B 3.2]
enum class Normals : std::uint8_t { exact, facet, averaged };

struct Object {
  std::string name;
  Shape shape = Sphere{};
  std::string material;              // "": the default one
  std::vector<Transform> transforms; // world from object, the first one first
  Shading shading = Shading::phong;
  Normals normals = Normals::exact;
  double crease_degrees = 180;       // averaged: triangles that meet at a larger angle keep normals of their own
  bool casts_shadow = true;
  bool seen_in_environment = true;   // in one that is rendered from the scene itself
  bool operator==(const Object&) const = default;
};

}  // namespace description

struct SceneDescription {
  std::string title, caption, source;   // what it is, what to see in it, which figure it is
  description::Picture picture;
  description::Tracing tracing;
  description::Camera camera;
  glm::vec3 ambient{0.2f};              // Ia, linear RGB
  std::vector<description::Light> lights;
  std::vector<description::Texture> textures;
  std::vector<description::Material> materials;
  std::optional<description::Environment> environment;
  std::vector<description::Object> objects;
  std::filesystem::path folder;         // that files are relative to; the scene file's own
  bool operator==(const SceneDescription&) const = default;
};

/// Nothing if there is none of that name.
const description::Texture* find_texture(const SceneDescription& scene, std::string_view name) noexcept;
const description::Material* find_material(const SceneDescription& scene, std::string_view name) noexcept;

/// The file that a scene names, relative to the scene's folder unless absolute.
std::filesystem::path file_of(const SceneDescription& scene, const std::string& name);

}  // namespace tuberia
