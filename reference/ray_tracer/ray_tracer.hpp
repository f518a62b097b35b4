#pragma once
// Whitted's algorithm as the notes tell it.                              [A 2.3] [B 5.1-5.6] [Whitted]

#include <cstdint>

#include "reference/ray_tracer/traced_scene.hpp"

namespace tuberia::tracer {

class RayTree;

/// Against surfaces that shadow themselves because a hit is never quite on them [B 5.4]: t must be above a tolerance; or
/// the ray starts a little off the surface; or what is convex is left out of its own rays. none: to see why.
enum class AcneRemedy : std::uint8_t { moved_origin, tolerance, skip_convex, none };

struct TraceSettings {
  int most_level = 5;             // eye rays are level 0; rays beyond it are not followed: black  [B 5.5]
  double least_weight = 0;        // a branch whose coefficients multiply to less is not followed [B 5.5]
  std::int64_t most_rays = 100'000;  // for one eye ray, so that a hall of mirrors ends; beyond it black
  AcneRemedy remedy = AcneRemedy::moved_origin;
  double tolerance = 0;           // world units of moved_origin and tolerance; 0: chosen by the size of the numbers
  bool shadows_of_all = false;    // every light casts shadows, whether the scene says so or not
};

/// One for each worker: scratch memory and counts.
struct TraceScratch {
  Traversal traversal;
  std::vector<TracedLight> lights;
  std::int64_t reflected_rays = 0, transmitted_rays = 0, shadow_rays = 0;
  std::int64_t rays_of_this_eye_ray = 0;
};

class RayTracer {
 public:
  explicit RayTracer(const TracedScene& scene, TraceSettings settings = {});

  /// The light that comes along an eye ray, linear RGB, not clamped; writes the tree if there is one.
  glm::dvec3 radiance(const Ray& ray, TraceScratch& scratch, RayTree* tree = nullptr) const;

  /// What an eye ray meets first.
  Hit first_hit(const Ray& ray, TraceScratch& scratch) const;
};

}  // namespace tuberia::tracer
