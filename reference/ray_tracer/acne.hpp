#pragma once
// Surfaces that shadow themselves because a hit is never quite on them, and what helps.                    [B 5.4]

#include <cstdint>

#include "reference/ray_tracer/ray.hpp"

namespace tuberia::tracer {

/// The ray starts a little off the surface; or t must be above a tolerance; or what is convex is left out of the rays that leave
/// it outwards, all others having the tolerance. none: to see why.
enum class AcneRemedy : std::uint8_t { moved_origin, tolerance, skip_convex, none };

/// How a ray sets out from a surface.
struct Departure {
  Ray ray;
  bool skips_surface = false;  // what it leaves is to be left out
};

/// direction: unit, to either side of the surface.   tolerance: world units; 0 is safe_offset().
/// The origin moves along the normal rather than along the ray as in the notes, so that the ray is clear of the surface however
/// obliquely it leaves.
Departure departure(const SurfacePoint& from, const glm::dvec3& direction, bool is_convex, AcneRemedy remedy, double tolerance) noexcept;

}  // namespace tuberia::tracer
