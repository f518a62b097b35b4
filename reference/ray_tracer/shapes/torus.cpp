#include "reference/ray_tracer/shapes/torus.hpp"

#include <algorithm>

#include "reference/ray_tracer/shapes/crossing.hpp"
#include "reference/ray_tracer/shapes/polynomial.hpp"
#include "reference/ray_tracer/shapes/revolution.hpp"

namespace tuberia::tracer {

std::optional<ShapeHit> Torus::intersect(const Ray& ray) const noexcept {
  if (!(tube_ > 0 && ring_ > tube_)) return std::nullopt;
  const CentredLine line(ray);
  // In units of the sphere around the torus, on whose far side of both ends of the line there is nothing.
  const double size = ring_ + tube_, ring = ring_ / size, tube = tube_ / size;
  const glm::dvec3 o = line.origin / size, &d = line.direction;
  const double reach_square = 1.01 - glm::dot(o, o);
  if (!(reach_square > 0)) return std::nullopt;
  const double reach = std::sqrt(reach_square);

  // (|p|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2) with p = o + s d, o and d perpendicular.
  const double power = glm::dot(o, o) + (ring - tube) * (ring + tube), four = 4 * ring * ring;
  const double c2 = 2 * power - four * (d.x * d.x + d.z * d.z), c1 = -2 * four * (o.x * d.x + o.z * d.z);
  const double c0 = power * power - four * (o.x * o.x + o.z * o.z);
  const PolynomialRoots roots = sign_changes(std::array{c0, c1, c2, 0.0, 1.0}, -reach, reach);
  for (const double root : roots.all()) {
    const double t = line.t_of(refined(line, root * size));
    if (is_within(ray, t)) return ShapeHit{.t = t};
  }
  return std::nullopt;
}

/// The quartic's roots are good to a few 2^-53 of the torus divided by the thickness of the tube; Newton's step on the distance from
/// the tube brings what was lost of it.
double Torus::refined(const CentredLine& line, double s) const noexcept {
  const auto distance = [&](double at) {
    const glm::dvec3 p = line.at(at);
    return std::hypot(std::hypot(p.x, p.z) - ring_, p.y) - tube_;
  };
  for (int i = 0; i < 2; ++i) {
    const glm::dvec3 p = line.at(s);
    const MeridianPlane at = meridian_plane(p);
    const glm::dvec3 from_ring = p - ring_ * at.outwards;
    const double slope = glm::dot(from_ring, line.direction) / glm::length(from_ring);
    const double next = s - distance(s) / slope;
    if (!(std::abs(distance(next)) < std::abs(distance(s)))) break;
    s = next;
  }
  return s;
}

SurfacePoint Torus::surface(const Ray& ray, const ShapeHit& hit) const noexcept {
  const glm::dvec3 near_surface = ray.at(hit.t);
  const MeridianPlane at = meridian_plane(near_surface);
  const glm::dvec3 up(0, 1, 0), middle = ring_ * at.outwards, normal = glm::normalize(near_surface - middle);
  const double inwards = -glm::dot(normal, at.outwards);
  return {.position = middle + tube_ * normal, .geometric_normal = normal, .normal = normal,
          .tangent = kTurn * (ring_ - tube_ * inwards) * at.around, .bitangent = kTurn * tube_ * (inwards * up + normal.y * at.outwards),
          .texcoord = {at.u, turns_of(inwards, normal.y)}, .magnitude = ring_ + tube_};
}

}  // namespace tuberia::tracer
