#pragma once
// Small scenes with a light: drawn with a shadow map, and by rays.

#include <catch2/catch.hpp>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <vector>

#include "pipeline/programs/surface.hpp"
#include "scene/shadows/light_view.hpp"
#include "scene/shadows/shadow_pass.hpp"
#include "tests/support/render.hpp"
#include "tests/support/shadow_rays.hpp"
#include "tests/support/shapes.hpp"

namespace tuberia::test {

struct ShadowScene {
  struct Part {
    Mesh mesh;
    glm::mat4 world_from_object{1.0f};
    bool is_seen = true;  // by the eye; the light sees all
  };
  std::vector<Part> parts;
  Camera eye;
  Light light;

  void add(Mesh mesh, const glm::mat4& world_from_object = glm::mat4(1)) { parts.push_back({std::move(mesh), world_from_object}); }
  void add_unseen(Mesh mesh) { parts.push_back({.mesh = std::move(mesh), .is_seen = false}); }

  /// Of all parts: what casts and what receives.
  Bounds bounds() const {
    Bounds box;
    for (const Part& part : parts)
      for (const glm::vec3& p : part.mesh.positions) box.add(glm::vec3(part.world_from_object * glm::vec4(p, 1)));
    return box;
  }

  std::vector<DrawCall> draws() const {
    std::vector<DrawCall> calls;
    for (const Part& part : parts) {
      DrawCall call{.mesh = part.mesh.view(), .program = {}, .state = {}};
      call.state.transform.world_from_object = part.world_from_object;
      calls.push_back(std::move(call));
    }
    return calls;
  }

  RayScene rays() const {
    RayScene scene;
    for (const Part& part : parts) scene.add(part.mesh, glm::dmat4(part.world_from_object));
    return scene;
  }
};

/// A camera with an opening of 45 degrees.
inline Camera eye_at(const glm::dvec3& eye, const glm::dvec3& looks_at, double aspect = 1) {
  return {.eye = eye, .point_of_interest = looks_at, .up = {0, 1, 0}, .view = *perspective_volume(0.7853981633974483, aspect, 0.1, 100)};
}

/// A view straight down on the square |x|, |z| <= half_width; x to the right and -z up.
inline Camera eye_above(double half_width) {
  return {.eye = {0, 50, 0}, .point_of_interest = {0, 0, 0}, .up = {0, 0, -1}, .projection = Projection::orthographic,
          .view = {.left = -half_width, .right = half_width, .bottom = -half_width, .top = half_width, .near_distance = 0.1, .far_distance = 100}};
}

template <class T>
T value_of(Result<T> result) {
  if (!result) FAIL(result.error().message);
  return *std::move(result);
}

inline ShadowMap shadow_map_of(const ShadowScene& scene, const LightView& view, const ShadowPass& pass = {}, const PipelineOptions& options = {.threads = 1}) {
  Pipeline pipeline(options);
  return value_of(draw_shadow_map(pipeline, scene.draws(), view, pass));
}

/// White and matt, lit by nothing else.
inline FragmentProgram matt(const SurfaceLight& light) {
  return surface({.reflection = {.model = Reflection::lambert, .ambient = glm::vec3(0), .diffuse = glm::vec3(1)}, .lights = {light}});
}

/// A square picture of floats by the scene's eye.
inline Image<Rgba32F> picture_of(const ShadowScene& scene, const FragmentProgram& program, int size, const PipelineOptions& options = {.threads = 1}) {
  Studio studio({.width = size, .height = size, .colour = ColourFormat::rgba32f, .options = options});
  for (const ShadowScene::Part& part : scene.parts) {
    if (!part.is_seen) continue;
    PipelineState state;
    state.transform.world_from_object = part.world_from_object;
    state.transform.clip_from_world = value_of(camera_matrices(scene.eye)).clip_from_world;
    studio.draw(part.mesh.view(), program, state);
  }
  return studio.target().linear_image();
}

/// Each colour by the colour without what stands in the light's way: visibility times the thrown picture.
inline Image<Rgba32F> divided(Image<Rgba32F> lit, const Image<Rgba32F>& unhindered) {
  const auto quotient = [](float a, float b) { return b > 0 ? a / b : 0.0f; };
  for (int y = 0; y < lit.height(); ++y)
    for (int x = 0; x < lit.width(); ++x) {
      Rgba32F& a = lit.at(x, y);
      const Rgba32F& b = unhindered.at(x, y);
      a = {quotient(a.r, b.r), quotient(a.g, b.g), quotient(a.b, b.b), 1};
    }
  return lit;
}

/// Of the scene's light, with these in its way; 0 where surfaces are turned away from it.
inline Image<Rgba32F> visibility_picture(const ShadowScene& scene, const std::optional<ShadowMap>& shadow, int size, const std::optional<ProjectedTexture>& projected = {}) {
  return divided(picture_of(scene, matt({scene.light, shadow, projected}), size), picture_of(scene, matt({scene.light, {}, {}}), size));
}

/// The ray through the centre of a pixel of a square picture, in double.
inline Ray pixel_ray(const Camera& camera, int x, int y, int size) {
  const CameraBasis basis = value_of(camera_basis(camera.eye, camera.point_of_interest, camera.up));
  const ViewVolume& view = camera.view;
  const glm::dvec3 across = basis.u * (view.left + (view.right - view.left) * (x + 0.5) / size) + basis.v * (view.top + (view.bottom - view.top) * (y + 0.5) / size);
  if (camera.projection == Projection::orthographic) return {camera.eye + across, -basis.w};
  return {camera.eye, across - basis.w * view.near_distance};
}

/// A floor at y = 0.
inline Mesh ground(float half_width) {
  return rectangle({-half_width, 0, half_width}, {2 * half_width, 0, 0}, {0, 0, -2 * half_width}, {0, 1, 0});
}

/// Six faces, with outward normals.
inline Mesh box(const glm::vec3& lower, const glm::vec3& upper) {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool positive : {false, true}) {
      glm::vec3 corner = positive ? upper : lower, u(0), v(0), normal(0);
      const int i = (axis + 1) % 3, j = (axis + 2) % 3;
      normal[axis] = positive ? 1.0f : -1.0f;
      u[positive ? i : j] = (lower - upper)[positive ? i : j] * (positive ? 1.0f : -1.0f);
      v[positive ? j : i] = (lower - upper)[positive ? j : i] * (positive ? 1.0f : -1.0f);
      const Mesh face = rectangle(corner, u, v, normal);
      const auto base = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.insert(mesh.positions.end(), face.positions.begin(), face.positions.end());
      mesh.normals.insert(mesh.normals.end(), face.normals.begin(), face.normals.end());
      for (const std::uint32_t index : face.indices) mesh.indices.push_back(base + index);
    }
  return mesh;
}

inline ShadowScene spheres_on_a_plane() {
  ShadowScene scene;
  scene.add(ground(5));
  const Mesh ball = sphere(24);
  scene.add(ball, translation({0, 1, 0}));
  scene.add(ball, compose(translation({1.9, 0.6, 1.1}), scaling({0.6, 0.6, 0.6})));
  scene.add(ball, compose(translation({-1.8, 2.2, 0.6}), scaling({0.4, 0.4, 0.4})));
  scene.eye = eye_at({3, 6, 8}, {0, 0.3, 0});
  return scene;
}

inline ShadowScene box_on_a_plane() {
  ShadowScene scene;
  scene.add(ground(5));
  scene.add(box({-1, 0, -1}, {1, 1.5f, 1}), rotation({0, 1, 0}, 0.5));
  scene.add(box({-2.5f, 1, 1}, {-1.5f, 1.25f, 2.5f}));
  scene.eye = eye_at({-3, 7, 8}, {0, 0, 0});
  return scene;
}

/// The shadows of thin things begin where they stand, and are the first to let go. For kSunBehind.
inline ShadowScene cards_and_a_ball() {
  ShadowScene scene;
  scene.add(ground(4));
  scene.add(rectangle({-1, 0, 0.8f}, {1.6f, 0, -0.5f}, {0, 1.2f, 0}, {0.3f, 0, 0.95f}));
  scene.add(rectangle({-2.6f, 0, -0.6f}, {1.4f, 0, -0.5f}, {0, 1.6f, 0}, {0.34f, 0, 0.94f}));
  scene.add(sphere(24), compose(translation({1.2, 0.7, 0.9}), scaling({0.7, 0.7, 0.7})));
  scene.eye = eye_at({-4, 5, 6.5}, {-0.4, 0.2, -0.2});
  return scene;
}

inline ShadowScene thin_pole() {
  ShadowScene scene;
  scene.add(ground(3));
  scene.add(box({-0.06f, 0, -0.06f}, {0.06f, 2.5f, 0.06f}), translation({0.3, 0, -0.4}));
  scene.eye = eye_at({-2, 6, 6}, {0.5, 0, 0});
  return scene;
}

/// Four walls, a floor and a ceiling, seen from inside, with things on all sides of the middle.
inline ShadowScene room() {
  ShadowScene scene;
  Mesh walls = box({-3, 0, -3}, {3, 3, 3});
  for (glm::vec3& n : walls.normals) n = -n;
  for (std::size_t i = 0; i < walls.indices.size(); i += 3) std::swap(walls.indices[i], walls.indices[i + 1]);
  scene.add(std::move(walls));
  const Mesh ball = sphere(16);
  for (const glm::dvec3& at : {glm::dvec3(1.4, 0.5, 0.3), {-1.2, 1.8, 0.4}, {0.3, 0.6, -1.5}, {0.2, 2.5, 1.0}, {-1.1, 0.9, -1.2}})
    scene.add(ball, compose(translation(at), scaling({0.3, 0.3, 0.3})));
  scene.eye = eye_at({2.7, 2.6, 2.8}, {-0.5, 0.8, -0.8});
  return scene;
}

inline const Light kSun{.kind = Light::Kind::directional, .towards = {0.48f, 0.8f, 0.36f}};
inline const Light kSunBehind{.kind = Light::Kind::directional, .towards = {-0.36f, 0.64f, -0.6788225f}};
inline const Light kLamp{.kind = Light::Kind::point, .towards = {4, 7, 3}};

inline glm::dvec3 to_light(const Light& light, const glm::dvec3& point) {
  const glm::dvec3 towards(light.towards);
  return light.kind == Light::Kind::directional ? towards : towards - point;
}

}  // namespace tuberia::test
