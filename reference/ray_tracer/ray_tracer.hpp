#pragma once
// Whitted's algorithm as the notes tell it.                              [A 2.3] [B 5.1-5.6] [Whitted]

#include <cstdint>

#include "reference/ray_tracer/acne.hpp"
#include "reference/ray_tracer/footprint.hpp"
#include "reference/ray_tracer/straight_light.hpp"
#include "reference/ray_tracer/traced_scene.hpp"

namespace tuberia::tracer {

class RayTree;

struct TraceSettings {
  int most_level = 5;             // eye rays are level 0; rays beyond it are not followed: black  [B 5.5]
  double least_weight = 0;        // a branch whose coefficients multiply to less is not followed [B 5.5]
  std::int64_t most_rays = 100'000;  // for one eye ray, shadow rays apart, so that a hall of mirrors ends; beyond it black
  AcneRemedy remedy = AcneRemedy::moved_origin;
  double tolerance = 0;           // world units of the first three remedies; 0: chosen by the size of the numbers
  bool shadows_of_all = false;    // every light casts shadows, whether the scene says so or not
};

/// One for each worker: scratch memory and counts.
struct TraceScratch {
  Traversal traversal;
  std::vector<TracedLight> lights;
  BodiesOnTheWay bodies;
  std::int64_t reflected_rays = 0, transmitted_rays = 0, shadow_rays = 0;
  std::int64_t unfollowed_rays = 0;            // for want of most_rays
  std::int64_t rays_of_this_eye_ray = 0;
};

/// Bodies are surrounded by vacuum: what leaves one goes on at the index 1, so bodies must not touch or contain each other.
/// A body that transmits attenuates the light that goes through it without bending: each body by kt, and exp(-shadow_density
/// path) along its path inside; a conventional ray tracer has no caustics.                                          [B 5.9]
class RayTracer {
 public:
  /// scene must outlive it.
  explicit RayTracer(const TracedScene& scene, TraceSettings settings = {}) noexcept : scene_(scene), settings_(settings) {}

  /// The light that comes along an eye ray, linear RGB, not clamped; writes the tree if there is one. An unsound ray brings none.
  /// neighbours: of that pixel, for textures on what the eye sees itself; without them, and by reflection, the finest level is read.
  glm::dvec3 radiance(const Ray& ray, TraceScratch& scratch, RayTree* tree = nullptr, const NeighbourRays* neighbours = nullptr) const;

  /// What an eye ray meets first, holes passed through.
  Hit first_hit(const Ray& ray, TraceScratch& scratch) const;

  const TracedScene& scene() const noexcept { return scene_; }
  const TraceSettings& settings() const noexcept { return settings_; }

 private:
  const TracedScene& scene_;
  TraceSettings settings_;
};

}  // namespace tuberia::tracer
