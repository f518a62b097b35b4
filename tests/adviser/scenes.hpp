#pragma once
// Ten pictures for the adviser, from formulas: textured and not, lit and not, coarse and fine, near and far.

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "math/camera.hpp"
#include "scene/adviser/model_picture.hpp"

namespace tuberia::test {

struct AdviserScene {
  std::string name;
  Model model;
  Camera camera;
  int width = 320, height = 192;
};

/// A surface over the unit square in `cells` x `cells` quadrilaterals, counter-clockwise seen from where u x v points.
inline Mesh surface(int cells, float repeats, const std::function<glm::vec3(double u, double v)>& position) {
  Mesh mesh;
  const double step = 1e-4;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const double u = static_cast<double>(i) / cells, v = static_cast<double>(j) / cells;
      const glm::vec3 along = position(u + step, v) - position(u - step, v), across = position(u, v + step) - position(u, v - step);
      const glm::vec3 normal = glm::cross(along, across);
      mesh.positions.push_back(position(u, v));
      mesh.normals.push_back(glm::length(normal) > 0 ? glm::normalize(normal) : glm::vec3(0, 1, 0));
      mesh.texcoords.push_back(repeats * glm::vec2(u, v));
    }
  const auto number = [&](int i, int j) { return static_cast<std::uint32_t>(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i)
      for (const std::uint32_t index : {number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j), number(i + 1, j + 1), number(i, j + 1)})
        mesh.indices.push_back(index);
  return mesh;
}

inline glm::vec3 on_sphere(double u, double v) {
  const double turn = 6.283185307179586 * u, polar = 3.141592653589793 * (1 - v);
  return glm::vec3(std::sin(polar) * std::sin(turn), std::cos(polar), std::sin(polar) * std::cos(turn));
}
inline glm::vec3 on_torus(double u, double v) {
  const double turn = 6.283185307179586 * u, tube = 6.283185307179586 * v, radius = 1 + 0.4 * std::cos(tube);
  return glm::vec3(radius * std::sin(turn), 0.4 * std::sin(tube), radius * std::cos(turn));
}
inline glm::vec3 on_floor(double u, double v) { return glm::vec3(20 * u - 10, 0, 10 - 20 * v); }
inline glm::vec3 on_wall(double u, double v) { return glm::vec3(2 * u - 1, 2 * v - 1, 0); }
inline glm::vec3 on_hills(double u, double v) { return glm::vec3(4 * u - 2, 0.3 * std::sin(11 * u) * std::cos(9 * v), 2 - 4 * v); }

/// Coarse and fine structure: waves over a checkerboard.
inline ModelTexture pattern(int size, int cell) {
  Image<Rgba8> image(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const bool is_odd = (x / cell + y / cell) % 2 != 0;
      const auto wave = static_cast<std::uint8_t>(std::lround(60 + 50 * std::sin(0.13 * x) * std::cos(0.07 * y)));
      image.at(x, y) = is_odd ? Rgba8{wave, static_cast<std::uint8_t>(2 * wave), 200, 255} : Rgba8{230, 220, wave, 255};
    }
  return {.name = "pattern", .image = std::move(image)};
}

inline Camera camera_at(glm::dvec3 eye, glm::dvec3 look_at, double near_distance = 0.05) {
  Camera camera;
  camera.eye = eye;
  camera.point_of_interest = look_at;
  const double half = 0.4 * near_distance;
  camera.view = {.left = -half * 320 / 192, .right = half * 320 / 192, .bottom = -half, .top = half, .near_distance = near_distance, .far_distance = 60};
  return camera;
}

inline AdviserScene scene_of(const std::string& name, const Mesh& mesh, const Camera& camera, bool textured, float shininess, int cell = 8) {
  AdviserScene scene{.name = name, .model = {}, .camera = camera};
  scene.model.meshes.push_back(mesh);
  Material material;
  material.base_colour = {0.8f, 0.7f, 0.6f, 1};
  if (shininess > 0) material.specular = glm::vec3(0.6f), material.shininess = shininess;
  if (textured) {
    scene.model.textures.push_back(pattern(256, cell));
    material.texture = 0;
    material.base_colour = glm::vec4(1);
  }
  scene.model.materials.push_back(material);
  return scene;
}

inline std::vector<AdviserScene> adviser_scenes() {
  const Camera before = camera_at({0.9, 1.1, 2.6}, {0, 0, 0}), flat_view = camera_at({0, 0, 2.4}, {0, 0, 0});
  return {scene_of("coarse shining sphere", surface(10, 1, on_sphere), before, false, 60),
          scene_of("fine shining sphere", surface(64, 1, on_sphere), before, false, 60),
          scene_of("torus of many triangles", surface(160, 1, on_torus), camera_at({0, 2.2, 2.6}, {0, 0, 0}), false, 20),
          scene_of("floor to the horizon", surface(1, 30, on_floor), camera_at({0, 0.7, 9}, {0, 0, 0}), true, 0),
          scene_of("floor in pieces", surface(40, 30, on_floor), camera_at({0, 1.5, 9}, {0, 0, 0}), true, 0),
          scene_of("wall from straight ahead", surface(1, 1, on_wall), flat_view, true, 0),
          scene_of("wall seen along", surface(8, 4, on_wall), camera_at({1.3, 0.1, 0.35}, {-0.3, 0, 0}), true, 0, 4),
          scene_of("textured sphere", surface(24, 2, on_sphere), before, true, 40),
          scene_of("textured torus", surface(48, 6, on_torus), camera_at({0.5, 1.4, 2.6}, {0, 0, 0}), true, 10, 16),
          scene_of("hills", surface(60, 8, on_hills), camera_at({0, 0.9, 2.3}, {0, 0, 0}), true, 30)};
}

/// Everything that an Adviser needs for a scene, kept alive together.
struct AdvisedScene {
  explicit AdvisedScene(AdviserScene description)
      : scene(std::move(description)), drawable(*DrawableModel::create(scene.model)),
        picture(drawable, view_of(scene), {0.05f, 0.05f, 0.08f, 1}, {.threads = 1}),
        traits(traits_of(scene.model, Shading::automatic)),
        target{.width = scene.width, .height = scene.height, .colour = ColourFormat::srgb8} {}
  AdvisedScene(const AdvisedScene&) = delete;
  AdvisedScene& operator=(const AdvisedScene&) = delete;

  static ModelView view_of(const AdviserScene& scene) {
    ModelView view;
    view.camera = *camera_matrices(scene.camera);
    view.eye = glm::vec3(scene.camera.eye);
    return view;
  }

  AdviserScene scene;
  DrawableModel drawable;
  ModelPicture picture;
  SurfaceTraits traits;
  RenderTargetDescription target;
};

}  // namespace tuberia::test
