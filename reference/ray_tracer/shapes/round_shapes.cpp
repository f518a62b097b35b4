#include "reference/ray_tracer/shapes/round_shapes.hpp"

#include <algorithm>

#include "reference/ray_tracer/shapes/ball_crossing.hpp"
#include "reference/ray_tracer/shapes/centred_line.hpp"
#include "reference/ray_tracer/shapes/flat_shapes.hpp"
#include "reference/ray_tracer/shapes/quadratic.hpp"
#include "reference/ray_tracer/shapes/revolution.hpp"

namespace tuberia::tracer {

std::optional<ShapeHit> RoundShape::intersect(const Ray& ray) const noexcept {
  if (!(radius_ > 0 && half_ > 0)) return std::nullopt;
  std::optional<Crossing> crossing = cross_side(ray);
  if (!crossing) return std::nullopt;
  if (!capped_) {
    for (const double t : {crossing->enter, crossing->leave}) {
      const double y = ray.origin.y + t * ray.direction.y;
      if (is_within(ray, t) && y >= -half_ && (ends_in_tip_ || y <= half_)) return ShapeHit{.t = t};
    }
    return std::nullopt;
  }
  if (!ends_in_tip_) crossing->cut(ray.origin.y - half_, ray.direction.y, 1);
  crossing->cut(-ray.origin.y - half_, -ray.direction.y, 2);
  return first_end(*crossing, ray);
}

SurfacePoint RoundShape::surface(const Ray& ray, const ShapeHit& hit) const noexcept {
  const glm::dvec3 near_surface = ray.at(hit.t);
  const bool on_side = hit.face == 0, on_top = hit.face == 1;
  SurfacePoint point = on_side ? side_surface(near_surface) : disc_surface(near_surface, radius_, on_top ? half_ : -half_, on_top);
  point.magnitude = std::max(radius_, half_);
  return point;
}

std::optional<Crossing> Cylinder::cross_side(const Ray& ray) const noexcept {
  const std::array<double, 2> to_axis{-ray.origin.x, -ray.origin.z}, direction{ray.direction.x, ray.direction.z};
  if (direction[0] == 0 && direction[1] == 0) {
    if (!(dot(to_axis, to_axis) < radius_ * radius_)) return std::nullopt;
    return Crossing{};
  }
  const BallCrossing<double> circle = cross_ball<double, 2>(to_axis, direction, radius_, ray.t_min >= 0);
  if (circle.meeting != BallMeeting::crossing) return std::nullopt;
  return Crossing{.enter = circle.first, .leave = circle.second};
}

SurfacePoint Cylinder::side_surface(const glm::dvec3& near_surface) const noexcept {
  const MeridianPlane at = meridian_plane(near_surface);
  const double y = std::clamp(near_surface.y, -half_, half_);
  return {.position = radius_ * at.outwards + glm::dvec3(0, y, 0), .geometric_normal = at.outwards, .normal = at.outwards,
          .tangent = kTurn * radius_ * at.around, .bitangent = {0, -2 * half_, 0}, .texcoord = {at.u, 0.5 - 0.5 * y / half_}};
}

std::optional<Crossing> Cone::cross_side(const Ray& ray) const noexcept {
  const CentredLine line(ray, {0, half_, 0});
  const glm::dvec3 &o = line.origin, &d = line.direction;
  // rho^2 = (k y)^2, rho the distance from the axis and y the height, both from the tip, where o and d are perpendicular.
  const double k = 0.5 * radius_ / half_, across = std::hypot(d.x, d.z), rho = std::hypot(o.x, o.z);
  const double a = (across - k * d.y) * (across + k * d.y), b = 2 * (o.x * d.x + o.z * d.z - k * k * o.y * d.y);
  const double c = (rho - k * o.y) * (rho + k * o.y);
  const QuadraticRoots roots = solve_quadratic(a, b, c);
  if (roots.count == 0) return std::nullopt;

  Crossing crossing;
  if (a > 0) {
    // Flatter than the side: through one half of the double cone, the lower one or its mirror image above the tip.
    if (!(o.y + 0.5 * (roots.first + roots.second) * d.y < 0) || roots.first == roots.second) return std::nullopt;
    crossing = {.enter = line.t_of(roots.first), .leave = line.t_of(roots.second)};
  } else if (a < 0 || (b < 0) == (d.y < 0)) {
    // Steeper: through both, and the part below has no lower end.
    if (d.y < 0)
      crossing.enter = line.t_of(roots.second);
    else
      crossing.leave = line.t_of(roots.first);
  } else {
    return std::nullopt;
  }
  return crossing;
}

SurfacePoint Cone::side_surface(const glm::dvec3& near_surface) const noexcept {
  const MeridianPlane at = meridian_plane(near_surface);
  const double height = 2 * half_, slant = std::hypot(radius_, height);
  // The nearest point of the side's line, from the tip down.
  const double v = std::clamp((at.radius * radius_ + (half_ - near_surface.y) * height) / (slant * slant), 0.0, 1.0);
  const glm::dvec3 up(0, 1, 0), normal = (height * at.outwards + radius_ * up) / slant;
  return {.position = v * radius_ * at.outwards + (half_ - v * height) * up, .geometric_normal = normal, .normal = normal,
          .tangent = kTurn * v * radius_ * at.around, .bitangent = radius_ * at.outwards - height * up, .texcoord = {at.u, v}};
}

}  // namespace tuberia::tracer
