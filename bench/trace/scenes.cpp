#include "bench/trace/scenes.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include "reference/ray_tracer/shapes/sphere.hpp"

namespace tuberia::bench {
namespace {

constexpr glm::dvec3 kEye(1.8, 1.5, 2.4);

/// splitmix64 (Steele, Lea and Flood 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept : state_(seed) {}
  double below_one() noexcept {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ z >> 31) >> 11) * 0x1p-53;
  }
  glm::dvec3 in_cube() noexcept {
    const double x = below_one(), y = below_one(), z = below_one();
    return 2.0 * glm::dvec3(x, y, z) - 1.0;
  }

 private:
  std::uint64_t state_;
};

/// x and y in [0, 1), from the upper left corner.
tracer::Ray eye_ray(double x, double y) {
  const glm::dvec3 forward = -glm::normalize(kEye), right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0))), up = glm::cross(right, forward);
  return {.origin = kEye, .direction = glm::normalize(forward + 0.8 * ((x - 0.5) * right + (0.5 - y) * up))};
}

/// The factor of n next to its root, from below.
std::int64_t middle_factor(std::int64_t n) {
  auto factor = static_cast<std::int64_t>(std::sqrt(static_cast<double>(n)));
  while (n % factor != 0) --factor;
  return factor;
}

}  // namespace

tracer::Geometry random_spheres(std::int64_t count) {
  tracer::Geometry geometry;
  Random random(1);
  // Their shadows on a side of the cube, put side by side, would cover it.
  const double radius = std::sqrt(4 / (std::numbers::pi * static_cast<double>(count)));
  const auto sphere = std::make_shared<tracer::Sphere>(radius);
  for (std::int64_t i = 0; i < count; ++i) {
    glm::dmat4 world_from_object(1);
    world_from_object[3] = glm::dvec4(random.in_cube(), 1);
    geometry.add_shape(sphere, world_from_object, 0);
  }
  return geometry;
}

tracer::Geometry hills(std::int64_t triangle_count) {
  const std::int64_t rows = middle_factor(triangle_count / 2), columns = triangle_count / 2 / rows;
  Random random(2);
  Mesh mesh;
  const double roughness = 0.5 / static_cast<double>(columns);
  for (std::int64_t row = 0; row <= rows; ++row)
    for (std::int64_t column = 0; column <= columns; ++column) {
      const double x = 2 * static_cast<double>(column) / static_cast<double>(columns) - 1, z = 2 * static_cast<double>(row) / static_cast<double>(rows) - 1;
      mesh.positions.push_back(glm::dvec3(x, 0.3 * std::sin(5 * x + 2 * z) * std::cos(4 * z) + roughness * random.below_one(), z));
    }
  const auto vertex = [columns](std::int64_t row, std::int64_t column) { return static_cast<std::uint32_t>(row * (columns + 1) + column); };
  for (std::int64_t row = 0; row < rows; ++row)
    for (std::int64_t column = 0; column < columns; ++column) {
      const std::uint32_t a = vertex(row, column), b = vertex(row, column + 1), c = vertex(row + 1, column), d = vertex(row + 1, column + 1);
      mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
    }
  tracer::Geometry geometry;
  geometry.add_mesh(mesh, glm::dmat4(1), 0);
  return geometry;
}

std::vector<tracer::Ray> mixed_rays(int count) {
  Random random(3);
  std::vector<tracer::Ray> rays;
  for (int i = 0; i < count; ++i)
    if (i % 2 == 0) {
      const double x = random.below_one(), y = random.below_one();
      rays.push_back(eye_ray(x, y));
    } else {
      const glm::dvec3 from = random.in_cube();
      rays.push_back({.origin = from, .direction = glm::normalize(random.in_cube() - from)});
    }
  return rays;
}

std::vector<tracer::Ray> eye_rays(int pixels_wide) {
  std::vector<tracer::Ray> rays;
  for (int y = 0; y < pixels_wide; ++y)
    for (int x = 0; x < pixels_wide; ++x) rays.push_back(eye_ray((x + 0.5) / pixels_wide, (y + 0.5) / pixels_wide));
  return rays;
}

}  // namespace tuberia::bench
