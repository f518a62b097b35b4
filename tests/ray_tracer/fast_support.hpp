#pragma once
// What the tests of the fast kernel share: nets of triangles in floats, rays, and the same question to the tracer in doubles.

#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "reference/ray_tracer/accelerators/accelerator.hpp"
#include "reference/ray_tracer/fast/fast_triangles.hpp"
#include "reference/ray_tracer/geometry.hpp"
#include "tests/support/random.hpp"

namespace tuberia::tracer::fast_test {

using tuberia::test::Random;

inline float uniform(Random& random, double low, double high) {
  return static_cast<float>(low + (high - low) * (static_cast<double>(random.u64() >> 11) * 0x1p-53));
}

inline glm::vec3 in_box(Random& random, double half) {
  const float x = uniform(random, -half, half), y = uniform(random, -half, half);
  return {x, y, uniform(random, -half, half)};
}

/// Not unit, not short.
inline glm::vec3 any_direction(Random& random) {
  for (;;)
    if (const glm::vec3 v = in_box(random, 1); glm::length(v) > 0.1f && glm::length(v) < 1) return v;
}

/// Moved and scaled, each rounded to floats.
inline Mesh placed(Mesh mesh, float scale, const glm::vec3& position = glm::vec3(0)) {
  for (glm::vec3& p : mesh.positions) p = p * scale + position;
  return mesh;
}

/// A closed net around the origin whose vertices are 1 to 1 + `roughness` away by chance; 2 * side * side triangles.
inline Mesh closed_net(int side, double roughness, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  for (int row = 0; row <= side; ++row) {
    glm::vec3 first(0);
    for (int column = 0; column <= side; ++column) {
      const double polar = std::numbers::pi * row / side, turn = 2 * std::numbers::pi * column / side;
      const glm::dvec3 direction(std::sin(polar) * std::cos(turn), std::cos(polar), std::sin(polar) * std::sin(turn));
      glm::vec3 position(direction * (1.0 + uniform(random, 0, roughness)));
      if (column == 0) first = position;
      if (column == side || row == 0 || row == side) position = first;
      mesh.positions.push_back(position);
    }
  }
  const auto number = [side](int row, int column) { return static_cast<std::uint32_t>(row * (side + 1) + column); };
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column)
      for (const std::uint32_t vertex : {number(row, column), number(row + 1, column), number(row + 1, column + 1), number(row, column),
                                         number(row + 1, column + 1), number(row, column + 1)})
        mesh.indices.push_back(vertex);
  return mesh;
}

/// Triangles anywhere in a cube of half side 1, of sizes from 1/1000 to 1, some flat along an axis, some slivers.
inline Mesh soup(int triangles, std::uint64_t seed) {
  Random random(seed);
  Mesh mesh;
  for (int i = 0; i < triangles; ++i) {
    const glm::vec3 middle = in_box(random, 1);
    const double size = std::pow(10.0, uniform(random, -3, 0)), height = i % 7 == 0 ? 0 : i % 11 == 0 ? 1e-6 : 1;
    for (int corner = 0; corner < 3; ++corner) {
      glm::vec3 offset = in_box(random, size);
      offset[i % 3] *= static_cast<float>(height);
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.push_back(middle + offset);
    }
  }
  return mesh;
}

/// A camera's at `eye` that looks at the origin: width x height pixels in squares of 4 x 4.
inline std::vector<FastRay> camera_rays(const glm::vec3& eye, int width, int height) {
  const glm::vec3 forward = glm::normalize(-eye), right = glm::normalize(glm::cross(forward, {0, 1, 0})), up = glm::cross(right, forward);
  std::vector<FastRay> rays;
  for (int row = 0; row < height; row += 4)
    for (int column = 0; column < width; column += 4)
      for (int i = 0; i < 16; ++i) {
        const float x = (static_cast<float>(column + i % 4) + 0.5f) / static_cast<float>(width) - 0.5f;
        const float y = (static_cast<float>(row + i / 4) + 0.5f) / static_cast<float>(height) - 0.5f;
        rays.push_back({.origin = eye, .direction = glm::normalize(forward + x * right - y * up)});
      }
  return rays;
}

inline std::vector<FastRay> random_rays(int count, double half, std::uint64_t seed) {
  Random random(seed);
  std::vector<FastRay> rays;
  for (int i = 0; i < count; ++i) {
    const glm::vec3 origin = in_box(random, half);
    rays.push_back({.origin = origin, .direction = any_direction(random)});
  }
  return rays;
}

inline Ray in_doubles(const FastRay& ray) { return {glm::dvec3(ray.origin), glm::dvec3(ray.direction), ray.t_min, ray.t_max}; }

/// What a hit in doubles is in floats.
inline FastHit in_floats(const Hit& hit) {
  if (!hit) return {};
  return {static_cast<float>(hit.t), static_cast<std::uint32_t>(hit.item), static_cast<float>(hit.at.x), static_cast<float>(hit.at.y)};
}

/// The same triangles in doubles, each of which is asked.
class InDoubles {
 public:
  explicit InDoubles(const Mesh& mesh) { geometry_.add_mesh(mesh, glm::dmat4(1), 0); }
  const Geometry& geometry() const { return geometry_; }

  FastHit nearest(const FastRay& ray) const {
    Hit hit;
    if (is_sound(in_doubles(ray))) {
      const PreparedRay prepared(in_doubles(ray));
      for (std::int64_t item = 0; item < geometry_.count(); ++item) geometry_.intersect(item, prepared, hit);
    }
    return in_floats(hit);
  }

 private:
  Geometry geometry_;
};

inline FastTriangles triangles_of(const Mesh& mesh, int threads = 2) {
  Workers workers(threads);
  return FastTriangles::create(mesh.positions, mesh.indices, workers).value();
}

/// How many hits are others than `expected`, asked one by one and all together, with every instruction set.
inline int differences(FastTriangles& triangles, const std::vector<FastRay>& rays, const std::vector<FastHit>& expected) {
  int count = 0;
  for (const std::string_view set : FastTriangles::instruction_sets()) {
    triangles.use_instruction_set(set);
    std::vector<FastHit> together(rays.size());
    triangles.nearest(rays, together);
    for (std::size_t i = 0; i < rays.size(); ++i) count += (triangles.nearest(rays[i]) == expected[i] ? 0 : 1) + (together[i] == expected[i] ? 0 : 1);
  }
  return count;
}

}  // namespace tuberia::tracer::fast_test
