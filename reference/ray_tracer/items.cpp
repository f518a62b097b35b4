#include "reference/ray_tracer/items.hpp"

#include <cmath>
#include <utility>

namespace tuberia::tracer {

PreparedRay::PreparedRay(const Ray& sound_ray) noexcept : ray(sound_ray), inverse_direction(1.0 / sound_ray.direction) {
  const glm::dvec3& d = ray.direction;
  const glm::dvec3 size(std::abs(d.x), std::abs(d.y), std::abs(d.z));
  z = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  x = (z + 1) % 3;
  y = (x + 1) % 3;
  // Against the long axis the triangle would be seen mirrored.
  if (d[z] < 0) std::swap(x, y);
  shear = glm::dvec3(d[x] / d[z], d[y] / d[z], 1 / d[z]);
}

BoundingSphere Items::bounding_sphere(std::int64_t item) const noexcept { return sphere_around(bounds(item)); }

}  // namespace tuberia::tracer
