#include "reference/ray_tracer/shapes/triangle.hpp"

#include <cmath>

#include "reference/ray_tracer/shapes/crossing.hpp"

namespace tuberia::tracer {
namespace {

/// A corner as the ray sees it: x and y across it, 0 on the ray, and t.
glm::dvec3 seen_along(const PreparedRay& ray, const glm::dvec3& corner) noexcept {
  const glm::dvec3 from_origin = corner - ray.ray.origin;
  return {from_origin[ray.x] - ray.shear.x * from_origin[ray.z], from_origin[ray.y] - ray.shear.y * from_origin[ray.z],
          ray.shear.z * from_origin[ray.z]};
}

/// Twice the area of the triangle of the ray and an edge, as seen along the ray.
double edge(const glm::dvec3& from, const glm::dvec3& to) noexcept { return difference_of_products(from.x, to.y, from.y, to.x); }

}  // namespace

double difference_of_products(double a, double b, double c, double d) noexcept {
  const double first = a * b, second = c * d;
  if (first != second) return first - second;
  return std::fma(a, b, -first) - std::fma(c, d, -second);
}

std::optional<ShapeHit> intersect_triangle(const PreparedRay& ray, const std::array<glm::dvec3, 3>& corners) noexcept {
  // Every corner is moved and sheared alone, so that all triangles that share it see it in the same place; from there on
  // signs are exact.
  const glm::dvec3 a = seen_along(ray, corners[0]), b = seen_along(ray, corners[1]), c = seen_along(ray, corners[2]);
  const double of_a = edge(b, c), of_b = edge(c, a), of_c = edge(a, b);
  if ((of_a < 0 || of_b < 0 || of_c < 0) && (of_a > 0 || of_b > 0 || of_c > 0)) return std::nullopt;
  const double area = of_a + of_b + of_c;
  if (area == 0) return std::nullopt;
  const glm::dvec3 weights(of_a / area, of_b / area, of_c / area);
  const double t = weights.x * a.z + weights.y * b.z + weights.z * c.z;
  if (!is_within(ray.ray, t)) return std::nullopt;
  return ShapeHit{.t = t, .face = 0, .at = {weights.y, weights.z}};
}

bool has_area(const std::array<glm::dvec3, 3>& corners) noexcept {
  const glm::dvec3 e = corners[1] - corners[0], f = corners[2] - corners[0];
  const glm::dvec3 area(difference_of_products(e.y, f.z, e.z, f.y), difference_of_products(e.z, f.x, e.x, f.z),
                        difference_of_products(e.x, f.y, e.y, f.x));
  const bool is_finite = std::isfinite(area.x) && std::isfinite(area.y) && std::isfinite(area.z);
  return is_finite && area != glm::dvec3(0);
}

}  // namespace tuberia::tracer
