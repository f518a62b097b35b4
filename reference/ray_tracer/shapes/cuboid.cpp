#include "reference/ray_tracer/shapes/cuboid.hpp"

#include <algorithm>

#include "reference/ray_tracer/shapes/crossing.hpp"
#include "reference/ray_tracer/shapes/side_frame.hpp"

namespace tuberia::tracer {

std::optional<ShapeHit> Cuboid::intersect(const Ray& ray) const noexcept {
  if (!(half_.x > 0 && half_.y > 0 && half_.z > 0)) return std::nullopt;
  Crossing crossing;
  for (int axis = 0; axis < 3; ++axis) {
    crossing.cut(ray.origin[axis] - half_[axis], ray.direction[axis], 2 * axis);
    crossing.cut(-ray.origin[axis] - half_[axis], -ray.direction[axis], 2 * axis + 1);
  }
  return first_end(crossing, ray);
}

SurfacePoint Cuboid::surface(const Ray& ray, const ShapeHit& hit) const noexcept {
  const int axis = hit.face / 2;
  const double side = hit.face % 2 == 0 ? 1 : -1;
  SurfacePoint point;
  point.position = glm::clamp(ray.at(hit.t), -half_, half_);
  point.position[axis] = side * half_[axis];
  point.normal = glm::dvec3(0);
  point.normal[axis] = side;
  point.geometric_normal = point.normal;
  point.magnitude = std::max({half_.x, half_.y, half_.z});

  const SideFrame frame = side_frame(point.normal);
  point.tangent = 2.0 * half_ * frame.right;
  point.bitangent = 2.0 * half_ * frame.down;
  point.texcoord = {0.5 + glm::dot(point.position, frame.right) / glm::length(point.tangent),
                    0.5 + glm::dot(point.position, frame.down) / glm::length(point.bitangent)};
  return point;
}

}  // namespace tuberia::tracer
