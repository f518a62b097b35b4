#include "reference/ray_tracer/acne.hpp"

namespace tuberia::tracer {

Departure departure(const SurfacePoint& from, const glm::dvec3& direction, bool is_convex, AcneRemedy remedy, double tolerance) noexcept {
  const double offset = tolerance > 0 ? tolerance : safe_offset(from), side = glm::dot(direction, from.geometric_normal);
  Departure start{.ray = {.origin = from.position, .direction = direction}};
  if (remedy == AcneRemedy::none) return start;
  start.skips_surface = remedy == AcneRemedy::skip_convex && is_convex && side >= 0;
  if (remedy == AcneRemedy::moved_origin) start.ray.origin += (side < 0 ? -offset : offset) * from.geometric_normal;
  else if (!start.skips_surface) start.ray.t_min = offset;
  return start;
}

}  // namespace tuberia::tracer
