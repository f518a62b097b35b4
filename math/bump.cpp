#include "math/bump.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace tuberia {

namespace {

/// n'' times any positive number, from slopes times `flatness`; or n itself.
glm::dvec3 tilted(const SurfaceFrame& frame, const glm::dvec2& slope, double flatness) noexcept {
  const auto& [t_u, t_v, n] = frame;
  const glm::dvec3 across_v = glm::cross(n, t_v), across_u = glm::cross(t_u, n);
  const double area = glm::dot(glm::cross(t_u, t_v), n);
  const bool is_frame = std::abs(area) > 1e-6 * glm::length(across_u) * glm::length(across_v) && std::isfinite(area);
  const bool is_tilted = (slope.x != 0 || slope.y != 0) && std::isfinite(slope.x) && std::isfinite(slope.y);
  if (!is_frame || !is_tilted) return n;
  const glm::dvec3 tilt = slope.x * across_v + slope.y * across_u;
  return glm::normalize(flatness * std::abs(area) * n + (area < 0 ? -tilt : tilt));
}

}  // namespace

glm::dvec3 perturbed_normal(const SurfaceFrame& frame, const glm::dvec2& slope) noexcept { return tilted(frame, slope, 1); }

glm::dvec3 mapped_normal(const SurfaceFrame& frame, const glm::dvec3& tangent_space_normal, double gain) noexcept {
  const glm::dvec2 slope{-gain * tangent_space_normal.x * glm::length(frame.tangent), gain * tangent_space_normal.y * glm::length(frame.bitangent)};
  return tilted(frame, slope, std::max(tangent_space_normal.z, 0.0));
}

double relief_period(double scale) noexcept {
  return scale >= 1 && scale == std::floor(scale) ? scale : 2 * static_cast<double>(kLargestLatticeCoordinate);
}

HeightAndSlope waves(const glm::dvec2& uv, double scale) noexcept {
  const auto turns = [](double x) { return std::isfinite(x) ? 2 * std::numbers::pi * (x - std::floor(x)) : 0.0; };
  const double u = turns(uv.x * scale), v = turns(uv.y * scale), both = turns((uv.x + uv.y) * scale);
  const double slope = 2 * std::numbers::pi * scale / 3;
  return {(std::sin(u) + std::sin(v) + std::sin(both)) / 3, {slope * (std::cos(u) + std::cos(both)), slope * (std::cos(v) + std::cos(both))}};
}

HeightAndSlope orange(const glm::dvec2& uv, double scale, std::uint32_t seed) noexcept {
  const double period = relief_period(scale);
  const glm::dvec2 at{bounded_lattice_coordinate(uv.x * scale), bounded_lattice_coordinate(uv.y * scale)};
  const auto number = [&](double cell) { return static_cast<std::int32_t>(cell - period * std::floor(cell / period)); };
  HeightAndSlope sum;
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i) {
      const glm::dvec2 cell{std::floor(at.x) + i, std::floor(at.y) + j};
      const std::uint32_t h = lattice_hash(number(cell.x), number(cell.y), 0, seed);
      const glm::dvec2 centre = cell + glm::dvec2(h & 1023, h >> 10 & 1023) / 1024.0;
      const double radius = 0.35 + 0.3 * (h >> 20 & 1023) / 1024.0;
      const glm::dvec2 away = at - centre;
      const double inside = 1 - glm::dot(away, away) / (radius * radius);
      if (!(inside > 0)) continue;
      sum.height -= inside * inside;
      sum.slope += away * (4 * inside / (radius * radius) * scale);
    }
  return sum;
}

HeightAndSlope rough(const glm::dvec2& uv, double scale, std::uint32_t seed) noexcept {
  const double period = relief_period(scale);
  const HeightAndSlope coarse = gradient_noise(uv * scale, period, seed), fine = gradient_noise(uv * (2 * scale), 2 * period, seed + 1);
  // By half as high bumps at twice as many places the slopes grow as much as the first octave's.
  return {(coarse.height + 0.5 * fine.height) / 1.5, (coarse.slope + fine.slope) * (scale / 1.5)};
}

}  // namespace tuberia
