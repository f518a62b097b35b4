#pragma once
// Light that goes through bodies without being bent: the shadows of what transmits.                   [B 4.4, 5.9]

#include <utility>
#include <vector>

#include "reference/ray_tracer/traced_scene.hpp"

namespace tuberia::tracer {

/// The bodies that a shadow ray is inside of, as it goes from surface to surface.
class BodiesOnTheWay {
 public:
  void clear() noexcept { inside_.clear(); }

  /// What a surface that transmits leaves of the light: kt where the ray comes into the body, exp(-shadow_density path) where it
  /// goes out. A sheet has no inside; met from behind it takes kt, too.   t: along the ray.   object: the body's number.
  glm::dvec3 share(const PointMaterial& material, int object, double t, bool comes_in);

 private:
  std::vector<std::pair<int, double>> inside_;  // object, and the t where the ray came in
};

}  // namespace tuberia::tracer
