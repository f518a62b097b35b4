#include "scene/environment/sky.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace tuberia {
namespace {

/// A number in [0, 1) for each point of a lattice, mixed from its coordinates as hash tables mix keys.
double lattice_value(std::int64_t x, std::int64_t y, std::uint32_t seed) noexcept {
  std::uint64_t z = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15u ^ static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fu ^ seed;
  z = (z ^ z >> 31) * 0xbf58476d1ce4e5b9u;
  z = (z ^ z >> 29) * 0x94d049bb133111ebu;
  return static_cast<double>((z ^ z >> 32) >> 11) * 0x1p-53;
}

double smooth(double t) noexcept { return t * t * (3 - 2 * t); }

/// Random values at whole numbers, smoothly joined; in [0, 1).
double value_noise(double x, double y, std::uint32_t seed) noexcept {
  const double left = std::floor(x), top = std::floor(y);
  const auto i = static_cast<std::int64_t>(left), j = static_cast<std::int64_t>(top);
  const double u = smooth(x - left), v = smooth(y - top);
  return glm::mix(glm::mix(lattice_value(i, j, seed), lattice_value(i + 1, j, seed), u),
                  glm::mix(lattice_value(i, j + 1, seed), lattice_value(i + 1, j + 1, seed), u), v);
}

/// Noise of ever finer grain: each octave has twice the frequency and half the weight; in [0, 1).
double fractal_noise(double x, double y, std::uint32_t seed) noexcept {
  double sum = 0, weight = 0.5;
  for (std::uint32_t octave = 0; octave < 5; ++octave, weight /= 2) {
    sum += weight * value_noise(x, y, seed + octave);
    x *= 2;
    y *= 2;
  }
  return sum / (1 - 1.0 / 32);
}

double smoothstep(double low, double high, double a) noexcept { return smooth(std::clamp((a - low) / (high - low), 0.0, 1.0)); }

/// How much of a cloud layer, flat and one unit above, a direction above the horizon meets; 0 to 1.
double cloud_cover(const Sky& sky, const glm::dvec3& d) noexcept {
  if (!(sky.cloudiness > 0) || !(d.y > 0.02)) return 0;
  const double noise = fractal_noise(1.6 * d.x / d.y + 17, 1.6 * d.z / d.y + 5, sky.seed);
  const double edge = 0.75 - 0.5 * sky.cloudiness;  // the noise keeps to the middle of its range
  return smoothstep(edge, edge + 0.2, noise) * smoothstep(0.02, 0.25, d.y);  // haze hides far clouds
}

}  // namespace

glm::dvec3 sky_radiance(const Sky& sky, const glm::dvec3& direction) noexcept {
  const double length = glm::length(direction);
  const glm::dvec3 d = length > 0 ? direction / length : glm::dvec3(0, 1, 0);
  const double to_sun = std::clamp(glm::dot(d, glm::normalize(sky.towards_sun)), -1.0, 1.0);
  const double angle = std::acos(to_sun);

  // Pale at the horizon, deep blue above; the ground darkens downwards.
  const double height = std::max(d.y, 0.0);
  const glm::dvec3 clear = glm::mix(sky.horizon, sky.zenith, std::pow(height, 0.55)) + sky.glow * std::exp(-6 * angle);
  const double cover = cloud_cover(sky, d);
  const glm::dvec3 cloud = sky.horizon * (0.85 + 0.35 * std::exp(-2 * angle)) + glm::dvec3(0.12);
  glm::dvec3 above = glm::mix(clear, cloud, 0.9 * cover);
  // The disc's edge is soft over a tenth of its radius.
  const double disc = 1 - smoothstep(0.9 * sky.sun_radius_radians, sky.sun_radius_radians, angle);
  above += sky.sun * (disc * (1 - 0.97 * cover));

  const glm::dvec3 below = sky.ground * (1 - 0.6 * std::max(-d.y, 0.0));
  return glm::mix(below, above, smoothstep(-0.01, 0.01, d.y));
}

Surroundings sky_surroundings(const Sky& sky) {
  return {[sky](const glm::dvec3& direction) { return sky_radiance(sky, direction); }, std::clamp(sky.sun_radius_radians / 4, 0.002, 0.05)};
}

}  // namespace tuberia
