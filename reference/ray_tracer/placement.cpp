#include <algorithm>
#include <glm/matrix.hpp>

#include "reference/ray_tracer/geometry.hpp"

namespace tuberia::tracer {
namespace {

bool is_finite(const glm::dvec3& v) noexcept { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
bool is_finite(const glm::dmat3& m) noexcept { return is_finite(m[0]) && is_finite(m[1]) && is_finite(m[2]); }

/// 0 times an infinite side is 0: the axis does not matter.
double product(double factor, double side) noexcept { return factor == 0 ? 0 : factor * side; }

}  // namespace

Placement::Placement(const glm::dmat4& world_from_object) noexcept
    : linear(world_from_object), inverse(glm::inverse(linear)), normal_matrix(glm::transpose(inverse)), translation(world_from_object[3]),
      is_regular(is_finite(linear) && is_finite(translation) && is_finite(inverse) && glm::determinant(linear) != 0),
      is_mirrored(glm::determinant(linear) < 0) {}

Ray Placement::to_object(const Ray& ray) const noexcept {
  return {.origin = inverse * (ray.origin - translation), .direction = inverse * ray.direction, .t_min = ray.t_min, .t_max = ray.t_max};
}

glm::dvec3 Placement::normal_to_world(const glm::dvec3& normal) const noexcept {
  const glm::dvec3 turned = normal_matrix * normal;
  // Very large and very small scales would leave the numbers' range when squared.
  const double largest = std::max({std::abs(turned.x), std::abs(turned.y), std::abs(turned.z)});
  return largest > 0 && std::isfinite(largest) ? glm::normalize(turned / largest) : glm::dvec3(0);
}

Box Placement::to_world(const Box& box) const noexcept {
  if (box.empty()) return {};
  Box world{translation, translation};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      const double from = product(linear[column][row], box.lower[column]), to = product(linear[column][row], box.upper[column]);
      world.lower[row] += std::min(from, to);
      world.upper[row] += std::max(from, to);
    }
  // The sums are rounded.
  const double rounding = 1e-15 * magnitude_to_world(std::max({0.0, -box.lower.x, -box.lower.y, -box.lower.z, box.upper.x, box.upper.y, box.upper.z}));
  return std::isfinite(rounding) ? Box{world.lower - rounding, world.upper + rounding} : world;
}

BoundingSphere Placement::to_world(const BoundingSphere& sphere) const noexcept {
  // The square of the longest stretch is an eigenvalue of M^T M, and no larger than its largest row (Gershgorin); where
  // all directions are stretched alike they are equal.
  const glm::dmat3 squares = glm::transpose(linear) * linear;
  double longest = 0;
  for (int row = 0; row < 3; ++row) longest = std::max(longest, std::abs(squares[row].x) + std::abs(squares[row].y) + std::abs(squares[row].z));
  return {.centre = point_to_world(sphere.centre), .radius = std::sqrt(longest) * sphere.radius * (1 + 1e-14)};
}

double Placement::magnitude_to_world(double magnitude) const noexcept {
  double largest = 0;
  for (int row = 0; row < 3; ++row) {
    const double stretch = std::abs(linear[0][row]) + std::abs(linear[1][row]) + std::abs(linear[2][row]);
    largest = std::max(largest, stretch * magnitude + std::abs(translation[row]));
  }
  return largest;
}

}  // namespace tuberia::tracer
