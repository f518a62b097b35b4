#include "math/patterns.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec4.hpp>
#include <numbers>

#include "math/lattice_noise.hpp"

namespace tuberia {

namespace {

constexpr double kNarrowest = 1.0 / 1024;  // narrower boxes count as points

double smooth(double t) noexcept { return t * t * (3 - 2 * t); }

/// The integral from 0 of the wave that is 1 on [0, 1), -1 on [1, 2) and so on.
double triangle_wave(double x) noexcept { return 1 - std::abs(x - 2 * std::floor(x / 2) - 1); }

/// The mean of that wave over a box around x.
double mean_square_wave(double x, double width) noexcept {
  if (width < kNarrowest) return x - 2 * std::floor(x / 2) < 1 ? 1 : -1;
  return (triangle_wave(x + width / 2) - triangle_wave(x - width / 2)) / width;
}

double checker_share(const glm::dvec2& at, const glm::dvec2& width) noexcept {
  return 0.5 - 0.5 * mean_square_wave(at.x, width.x) * mean_square_wave(at.y, width.y);
}

/// The two squares along one axis that a box of at most one square's width reaches.
struct Reach {
  std::int32_t first;
  double weight_of_second;
};

Reach reach_of(double at, double width) noexcept {
  const double box = std::min(std::max(width, kNarrowest), 1.0);
  const double first = std::floor(at - box / 2);
  return {static_cast<std::int32_t>(first), std::clamp((at + box / 2 - first - 1) / box, 0.0, 1.0)};
}

glm::dvec3 square_shares(std::int32_t x, std::int32_t y, std::uint32_t seed) noexcept {
  const std::uint32_t h = lattice_hash(x, y, 0, seed);
  return glm::dvec3(h & 1023, h >> 10 & 1023, h >> 20 & 1023) / 1023.0;
}

glm::dvec3 random_square_shares(const glm::dvec2& at, const glm::dvec2& width, std::uint32_t seed) noexcept {
  const Reach x = reach_of(at.x, width.x), y = reach_of(at.y, width.y);
  const auto row = [&](std::int32_t j) { return glm::mix(square_shares(x.first, j, seed), square_shares(x.first + 1, j, seed), x.weight_of_second); };
  const glm::dvec3 mean = glm::mix(row(y.first), row(y.first + 1), y.weight_of_second);
  return 0.5 + (mean - 0.5) / (std::max(width.x, 1.0) * std::max(width.y, 1.0));
}

double faded(double share, double mean, double band_width) noexcept {
  return mean + (share - mean) * std::clamp(1.5 - band_width, 0.0, 1.0);
}

glm::dvec2 bounded(const glm::dvec2& v) noexcept { return {bounded_lattice_coordinate(v.x), bounded_lattice_coordinate(v.y)}; }

glm::dvec3 shares(const Pattern& pattern, const PatternPlace& place) noexcept {
  const double scale = static_cast<double>(pattern.scale), turbulence = static_cast<double>(pattern.turbulence);
  const glm::dvec2 at = bounded(place.texcoord * scale), width = bounded(place.texcoord_width * scale);
  const glm::dvec3 point = glm::dvec3(glm::dmat4(pattern.pattern_from_world) * glm::dvec4(place.world, 1)) * scale;
  switch (pattern.kind) {
    case Pattern::Kind::none: break;
    case Pattern::Kind::checker: return glm::dvec3(checker_share(at, width));
    case Pattern::Kind::random_squares: return random_square_shares(at, width, pattern.seed);
    case Pattern::Kind::wood: return glm::dvec3(faded(wood_share(point, turbulence, pattern.seed), kMeanWoodShare, place.band_width));
    case Pattern::Kind::marble: return glm::dvec3(faded(marble_share(point, turbulence, pattern.seed), kMeanMarbleShare, place.band_width));
  }
  return glm::dvec3(0);
}

}  // namespace

double wood_share(const glm::dvec3& point, double turbulence, std::uint32_t seed) noexcept {
  // A trunk's rings change slowly along it.
  const double moved = turbulence * gradient_noise(point * glm::dvec3(0.5, 0.125, 0.5), seed);
  const double ring = bounded_lattice_coordinate(std::sqrt(point.x * point.x + point.z * point.z) + moved);
  const double phase = ring - std::floor(ring);
  // Early wood darkens slowly, late wood ends at once.
  return smooth(phase < 0.75 ? phase / 0.75 : (1 - phase) / 0.25);
}

double marble_share(const glm::dvec3& point, double turbulence_in_veins, std::uint32_t seed) noexcept {
  const double vein = bounded_lattice_coordinate(point.x + turbulence_in_veins * turbulence(point, seed));
  const double wave = 0.5 + 0.5 * std::sin(2 * std::numbers::pi * vein);
  return wave * wave;
}

glm::dvec3 pattern_colour(const Pattern& pattern, const PatternPlace& place) noexcept {
  if (pattern.kind == Pattern::Kind::none) return glm::dvec3(1);
  return glm::mix(glm::dvec3(pattern.first), glm::dvec3(pattern.second), shares(pattern, place));
}

}  // namespace tuberia
