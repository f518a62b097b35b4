#pragma once
// Where rays of the imitation set out, and where mirrors send them.

#include <algorithm>
#include <glm/geometric.hpp>

#include "reference/ray_tracer/ray.hpp"

namespace tuberia::witness {

inline constexpr double kOffSurface = 1e-9;  // of the size of the numbers: where rays begin

/// From a point, off its surface on the side of the direction.
inline tracer::Ray leaving(const tracer::SurfacePoint& at, const glm::dvec3& direction, double distance) {
  const glm::dvec3& n = at.geometric_normal;
  const double off = kOffSurface * std::max(1.0, glm::length(at.position));
  return {.origin = at.position + (glm::dot(n, direction) < 0 ? -off : off) * n, .direction = direction, .t_max = distance - off};
}

/// 2 (N.V) N - V, with the normal as the pipeline has it.                                            [A 1.4]
inline glm::dvec3 mirror_direction(const glm::dvec3& N, const glm::dvec3& V) { return glm::normalize(2 * glm::dot(N, V) * N - V); }

}  // namespace tuberia::witness
