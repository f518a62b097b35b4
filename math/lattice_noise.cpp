#include "math/lattice_noise.hpp"

#include <cmath>

namespace tuberia {

namespace {

/// Where a coordinate lies: in which cell, how far from its lower end, and the weight of the upper end
/// with that weight's derivative.
struct Place {
  double cell, within, weight, slope;
};

Place place_of(double coordinate) noexcept {
  const double x = bounded_lattice_coordinate(coordinate);
  const double cell = std::floor(x), t = x - cell;
  return {cell, t, t * t * t * (t * (t * 6 - 15) + 10), 30 * t * t * (t - 1) * (t - 1)};
}

double mixed(double a, double b, double t) noexcept { return a + (b - a) * t; }

double signed_by(std::uint32_t bit, double x) noexcept { return bit != 0 ? -x : x; }

std::int32_t wrapped(double cell, double period) noexcept { return static_cast<std::int32_t>(cell - period * std::floor(cell / period)); }

}  // namespace

double bounded_lattice_coordinate(double x) noexcept { return std::abs(x) < static_cast<double>(kLargestLatticeCoordinate) ? x : 0.0; }

double gradient_noise(const glm::dvec3& point, std::uint32_t seed) noexcept {
  const Place x = place_of(point.x), y = place_of(point.y), z = place_of(point.z);
  const auto corner = [&](int i, int j, int k) {
    const std::uint32_t h = lattice_hash(static_cast<std::int32_t>(x.cell) + i, static_cast<std::int32_t>(y.cell) + j,
                                         static_cast<std::int32_t>(z.cell) + k, seed);
    return signed_by(h >> 31, x.within - i) + signed_by(h >> 30 & 1, y.within - j) + signed_by(h >> 29 & 1, z.within - k);
  };
  const auto edge = [&](int j, int k) { return mixed(corner(0, j, k), corner(1, j, k), x.weight); };
  const auto face = [&](int k) { return mixed(edge(0, k), edge(1, k), y.weight); };
  return mixed(face(0), face(1), z.weight) * (2.0 / 3);
}

HeightAndSlope gradient_noise(const glm::dvec2& point, double period, std::uint32_t seed) noexcept {
  const Place x = place_of(point.x), y = place_of(point.y);
  struct Corner {
    double value;
    glm::dvec2 gradient;
  };
  const auto corner = [&](int i, int j) {
    const std::uint32_t h = lattice_hash(wrapped(x.cell + i, period), wrapped(y.cell + j, period), 0, seed);
    const glm::dvec2 gradient{signed_by(h >> 31, 1), signed_by(h >> 30 & 1, 1)};
    return Corner{gradient.x * (x.within - i) + gradient.y * (y.within - j), gradient};
  };
  const Corner a = corner(0, 0), b = corner(1, 0), c = corner(0, 1), d = corner(1, 1);
  const auto interpolated = [&](double p, double q, double r, double s) { return mixed(mixed(p, q, x.weight), mixed(r, s, x.weight), y.weight); };
  return {interpolated(a.value, b.value, c.value, d.value),
          {interpolated(a.gradient.x, b.gradient.x, c.gradient.x, d.gradient.x) + x.slope * mixed(b.value - a.value, d.value - c.value, y.weight),
           interpolated(a.gradient.y, b.gradient.y, c.gradient.y, d.gradient.y) + y.slope * mixed(c.value - a.value, d.value - b.value, x.weight)}};
}

double turbulence(const glm::dvec3& point, std::uint32_t seed) noexcept {
  double sum = 0, scale = 1;
  for (std::uint32_t octave = 0; octave < 4; ++octave, scale *= 2) sum += std::abs(gradient_noise(point * scale, seed + octave)) / scale;
  return sum;
}

}  // namespace tuberia
