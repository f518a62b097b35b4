#include "reference/ray_tracer/shapes/sphere.hpp"

#include <algorithm>

#include "reference/ray_tracer/shapes/ball_crossing.hpp"
#include "reference/ray_tracer/shapes/crossing.hpp"
#include "reference/ray_tracer/shapes/revolution.hpp"

namespace tuberia::tracer {

std::optional<ShapeHit> Sphere::intersect(const Ray& ray) const noexcept {
  if (!(radius_ > 0)) return std::nullopt;
  const glm::dvec3 to_centre = centre_ - ray.origin;
  const BallCrossing<double> ball = cross_ball<double, 3>({to_centre.x, to_centre.y, to_centre.z},
                                                          {ray.direction.x, ray.direction.y, ray.direction.z}, radius_, ray.t_min >= 0);
  if (ball.meeting != BallMeeting::crossing) return std::nullopt;
  return first_end({.enter = ball.first, .leave = ball.second}, ray);
}

SurfacePoint Sphere::surface(const Ray& ray, const ShapeHit& hit) const noexcept {
  SurfacePoint point;
  point.normal = point.geometric_normal = glm::normalize((ray.origin - centre_) + hit.t * ray.direction);
  point.position = centre_ + radius_ * point.normal;
  point.magnitude = radius_ + std::max({std::abs(centre_.x), std::abs(centre_.y), std::abs(centre_.z)});

  const MeridianPlane at = meridian_plane(point.normal);
  const double polar_angle = std::atan2(at.radius, point.normal.y);
  point.texcoord = {at.u, 2 * polar_angle / kTurn};
  point.tangent = kTurn * radius_ * at.radius * at.around;
  point.bitangent = 0.5 * kTurn * radius_ * (point.normal.y * at.outwards - glm::dvec3(0, at.radius, 0));
  return point;
}

}  // namespace tuberia::tracer
