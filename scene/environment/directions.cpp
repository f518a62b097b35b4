#include "scene/environment/directions.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace tuberia {
namespace {

/// The unit vector; the zero vector counts as +z.
glm::dvec3 unit_direction(const glm::dvec3& d) noexcept {
  const double length = glm::length(d);
  return length > 0 ? d / length : glm::dvec3(0, 0, 1);
}

}  // namespace

glm::dvec2 panorama_point(const glm::dvec3& direction) noexcept {
  const glm::dvec3 d = unit_direction(direction);
  const double around = std::hypot(d.x, d.z);
  const double azimuth = around > 0 ? std::atan2(d.x, -d.z) : 0.0;
  // An arc tangent keeps the digits next to the poles that an arc cosine loses.
  return {0.5 + azimuth / (2 * std::numbers::pi), std::atan2(around, d.y) / std::numbers::pi};
}

glm::dvec3 panorama_direction(const glm::dvec2& point) noexcept {
  const double azimuth = (point.x - 0.5) * 2 * std::numbers::pi, polar = point.y * std::numbers::pi;
  return {std::sin(azimuth) * std::sin(polar), std::cos(polar), -std::cos(azimuth) * std::sin(polar)};
}

glm::dvec2 sphere_map_point(const glm::dvec3& direction) noexcept {
  const glm::dvec3 r = unit_direction(direction);
  const double m = 2 * glm::length(r + glm::dvec3(0, 0, 1));
  if (!(m > 0)) return {1, 0.5};
  return {0.5 + r.x / m, 0.5 - r.y / m};
}

glm::dvec3 sphere_map_direction(const glm::dvec2& point) noexcept {
  const double x = 2 * point.x - 1, y = 1 - 2 * point.y, squared = x * x + y * y;
  if (squared >= 1) return {0, 0, -1};
  const double z = std::sqrt(1 - squared);
  return {2 * z * x, 2 * z * y, 2 * z * z - 1};
}

CubeFacePoint cube_face_point(const glm::dvec3& direction) noexcept {
  const glm::dvec3 d = unit_direction(direction), size = glm::abs(d);
  const auto point = [](int face, double across, double down, double out) {
    return CubeFacePoint{face, {(across / out + 1) / 2, (down / out + 1) / 2}};
  };
  if (size.z >= size.x && size.z >= size.y) return d.z < 0 ? point(5, -d.x, -d.y, size.z) : point(4, d.x, -d.y, size.z);
  if (size.y >= size.x) return d.y < 0 ? point(3, d.x, -d.z, size.y) : point(2, d.x, d.z, size.y);
  return d.x < 0 ? point(1, d.z, -d.y, size.x) : point(0, -d.z, -d.y, size.x);
}

glm::dvec3 cube_face_direction(const CubeFacePoint& point) noexcept {
  const double across = 2 * point.at.x - 1, down = 2 * point.at.y - 1;
  switch (point.face) {
    case 0: return {1, -down, -across};
    case 1: return {-1, -down, across};
    case 2: return {across, 1, down};
    case 3: return {across, -1, -down};
    case 4: return {across, -down, 1};
    default: return {-across, -down, -1};
  }
}

}  // namespace tuberia
