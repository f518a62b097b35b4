#include "bench/trace/ray_sets.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "bench/figures/page.hpp"
#include "bench/peers/meshes.hpp"

namespace tuberia::bench {

TriangleSoup bunny(int subdivisions) {
  constexpr int kSegments = 187;  // 2 * 187 * 187 triangles are about the bunny's 69,666
  Result<WorkloadMesh> mesh = model_of_height_2("/usr/share/glmark2/models/bunny.obj");
  const char* const name = mesh ? "bunny" : "sphere (there is no bunny)";
  WorkloadMesh split = mesh ? *std::move(mesh) : unit_sphere(kSegments);
  for (int i = 0; i < subdivisions; ++i) split = subdivided(split);
  const double triangles = static_cast<double>(split.indices.size()) / 3;
  return {std::string(name) + ", " + count_text(triangles) + " triangles", std::move(split.positions), std::move(split.indices)};
}

RaySet primary_rays(int width_pixels, int height_pixels) {
  constexpr int kSquare = 4;
  constexpr glm::vec3 kEye(0, 0, 2.9f);
  const double half_height = std::tan(std::numbers::pi / 8), pixel = 2 * half_height / height_pixels;
  RaySet set{.name = "primary, " + std::to_string(width_pixels) + " x " + std::to_string(height_pixels), .rays = {}};
  for (int row = 0; row < height_pixels; row += kSquare)
    for (int column = 0; column < width_pixels; column += kSquare)
      for (int i = 0; i < kSquare * kSquare; ++i) {
        const double x = column + i % kSquare + 0.5 - 0.5 * width_pixels, y = row + i / kSquare + 0.5 - 0.5 * height_pixels;
        set.rays.push_back({.origin = kEye, .direction = glm::vec3(glm::normalize(glm::dvec3(x * pixel, -y * pixel, -1)))});
      }
  return set;
}

RaySet incoherent_rays(int count) {
  std::mt19937 random(1);
  const auto in = [&random](double low, double high) { return static_cast<float>(low + (high - low) * static_cast<double>(random()) * 0x1p-32); };
  const auto in_box = [&in] {
    const float x = in(-1, 1), y = in(-1, 1);
    return glm::vec3(x, y, in(-0.75, 0.75));
  };
  RaySet set{.name = "incoherent, " + count_text(count), .rays = {}};
  while (set.rays.size() < static_cast<std::size_t>(count)) {
    const glm::vec3 from = in_box(), along = in_box() - from;
    if (const float length = glm::length(along); length > 1e-3f) set.rays.push_back({.origin = from, .direction = along / length});
  }
  return set;
}

}  // namespace tuberia::bench
