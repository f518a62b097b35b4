#pragma once
// Small scenes for the tests of the recursion, and rays through them.

#include <catch2/catch.hpp>
#include <sstream>
#include <string>
#include <string_view>

#include "reference/ray_tracer/ray_tracer.hpp"
#include "reference/ray_tracer/ray_tree.hpp"
#include "scene/description/read_scene.hpp"

namespace tuberia::tracer {

/// Pieces of a text one after the other, numbers with all their digits.
template <class... Pieces>
std::string whitted_text(const Pieces&... pieces) {
  std::ostringstream text;
  text.precision(17);
  (text << ... << pieces);
  return text.str();
}

inline SceneDescription whitted_description(std::string_view json) {
  auto scene = scene_from_json(json, "test");
  if (!scene) FAIL(scene.error().message);
  return *std::move(scene);
}

inline TracedScene whitted_scene(SceneDescription description, const TracedSceneOptions& options = {}) {
  Workers workers(1);
  auto scene = TracedScene::create(std::move(description), workers, options);
  if (!scene) FAIL(scene.error().message);
  return *std::move(scene);
}

inline TracedScene whitted_scene(std::string_view json, const TracedSceneOptions& options = {}) { return whitted_scene(whitted_description(json), options); }

/// What an eye ray brings, with its counts and its tree.
struct WhittedRay {
  glm::dvec3 light{0};
  TraceScratch scratch;
  RayTree tree;
};

inline WhittedRay whitted_ray(const TracedScene& scene, const Ray& ray, const TraceSettings& settings = {}) {
  WhittedRay traced;
  const RayTracer tracer(scene, settings);
  traced.light = tracer.radiance(ray, traced.scratch, &traced.tree);
  // The tree only watches.
  TraceScratch without_tree;
  CHECK(tracer.radiance(ray, without_tree) == traced.light);
  return traced;
}

inline Ray whitted_towards(const glm::dvec3& from, const glm::dvec3& to) { return {.origin = from, .direction = glm::normalize(to - from)}; }

inline const TracedRay* whitted_named(const RayTree& tree, std::string_view name) {
  for (const TracedRay& ray : tree.rays())
    if (ray.name == name) return &ray;
  return nullptr;
}

inline bool whitted_is_near(const glm::dvec3& a, const glm::dvec3& b, double margin = 1e-9) { return glm::length(a - b) <= margin; }

}  // namespace tuberia::tracer
