#pragma once
// What the tests of the shapes share.

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "reference/ray_tracer/geometry.hpp"
#include "tests/support/random.hpp"

namespace tuberia::tracer::shapes_test {

using tuberia::test::Random;

inline double uniform(Random& random, double low, double high) { return low + (high - low) * (static_cast<double>(random.u64() >> 11) * 0x1p-53); }

inline glm::dvec3 in_box(Random& random, double half) {
  const double x = uniform(random, -half, half), y = uniform(random, -half, half);
  return {x, y, uniform(random, -half, half)};
}

inline glm::dvec3 unit_vector(Random& random) {
  const double z = uniform(random, -1, 1), angle = uniform(random, 0, 2 * std::numbers::pi), across = std::sqrt(1 - z * z);
  return {across * std::cos(angle), across * std::sin(angle), z};
}

/// The scales at which everything has to work.
inline const std::vector<double> kScales{1e-3, 1, 1e3, 1e6};

inline glm::dmat4 scaled(double scale, const glm::dvec3& position = glm::dvec3(0)) {
  glm::dmat4 matrix(scale);
  matrix[3] = glm::dvec4(position, 1);
  return matrix;
}

inline glm::dmat4 turned(double radians, const glm::dvec3& axis) {
  const glm::dvec3 a = glm::normalize(axis);
  const double c = std::cos(radians), s = std::sin(radians);
  glm::dmat4 matrix(1);
  for (int column = 0; column < 3; ++column) {
    glm::dvec3 e(0);
    e[column] = 1;
    matrix[column] = glm::dvec4(c * e + s * glm::cross(a, e) + (1 - c) * glm::dot(a, e) * a, 0);
  }
  return matrix;
}

/// The nearest of all items.
inline Hit nearest_hit(const Geometry& geometry, const Ray& ray) {
  Hit hit;
  if (!is_sound(ray)) return hit;
  const PreparedRay prepared(ray);
  for (std::int64_t item = 0; item < geometry.count(); ++item) geometry.intersect(item, prepared, hit);
  return hit;
}

}  // namespace tuberia::tracer::shapes_test
