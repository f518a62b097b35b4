#include "raster/cube_map.hpp"

#include <cmath>

namespace tuberia {
namespace {

/// Into [0, 1]; not-a-number gives 0.
float saturated(float a) { return a > 0 ? (a < 1 ? a : 1.0f) : 0.0f; }

int face_of(const glm::vec3& d) {
  const float x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
  if (z >= x && z >= y) return d.z < 0 ? 5 : 4;
  if (y >= x) return d.y < 0 ? 3 : 2;
  return d.x < 0 ? 1 : 0;
}

}  // namespace

CubePoint cube_point(const glm::vec3& d) noexcept {
  const int face = face_of(d);
  const glm::vec3 across[6] = {{-d.z, -d.y, d.x}, {d.z, -d.y, d.x}, {d.x, d.z, d.y}, {d.x, -d.z, d.y}, {d.x, -d.y, d.z}, {-d.x, -d.y, d.z}};
  const glm::vec3& c = across[face];
  const float size = std::abs(c.z);
  return {face, saturated((c.x / size + 1.0f) * 0.5f), saturated((c.y / size + 1.0f) * 0.5f)};
}

glm::vec3 cube_direction(const CubePoint& point) noexcept {
  const float a = 2 * point.s - 1, b = 2 * point.t - 1;
  switch (point.face) {
    case 0: return {1, -b, -a};
    case 1: return {-1, -b, a};
    case 2: return {a, 1, b};
    case 3: return {a, -1, -b};
    case 4: return {a, -b, 1};
    default: return {-a, -b, -1};
  }
}

}  // namespace tuberia
