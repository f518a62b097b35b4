#include "reference/ray_tracer/straight_light.hpp"

#include <algorithm>

namespace tuberia::tracer {

glm::dvec3 BodiesOnTheWay::share(const PointMaterial& material, int object, double t, bool comes_in) {
  if (comes_in) {
    inside_.emplace_back(object, t);
    return material.transmitted;
  }
  const auto entry = std::find_if(inside_.rbegin(), inside_.rend(), [&](const auto& body) { return body.first == object; });
  if (entry == inside_.rend()) return material.transmitted;
  const double path = t - entry->second;
  inside_.erase(std::next(entry).base());
  return glm::dvec3(std::exp(-material.shadow_density * path));
}

}  // namespace tuberia::tracer
