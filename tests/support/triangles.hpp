#pragma once
// Sets of triangles in 24.8 units that several tests share.

#include <cmath>
#include <vector>

#include "tests/support/coverage.hpp"

namespace tuberia::test {

/// Corners drawn independently from [low, high), x before y.
inline std::vector<Triangle> random_triangles(std::uint64_t seed, int count, std::int64_t low, std::int64_t high) {
  Random random(seed);
  std::vector<Triangle> triangles(static_cast<std::size_t>(count));
  for (Triangle& triangle : triangles)
    for (SnappedPoint& p : triangle) {
      p.x = static_cast<std::int32_t>(low + random.below(high - low));
      p.y = static_cast<std::int32_t>(low + random.below(high - low));
    }
  return triangles;
}

/// Corners at most 300 units from a centre somewhere on the target.
inline std::vector<Triangle> small_triangles(std::uint64_t seed, int count, int width, int height) {
  Random random(seed);
  std::vector<Triangle> triangles(static_cast<std::size_t>(count));
  for (Triangle& triangle : triangles) {
    const std::int64_t centre_x = random.below(width * 256), centre_y = random.below(height * 256);
    for (SnappedPoint& p : triangle) {
      p.x = static_cast<std::int32_t>(centre_x + random.below(601) - 300);
      p.y = static_cast<std::int32_t>(centre_y + random.below(601) - 300);
    }
  }
  return triangles;
}

/// Long and thin: two corners apart by up to `reach`, the third within 5 units of the line.
inline std::vector<Triangle> slivers(std::uint64_t seed, int count, std::int64_t reach) {
  Random random(seed);
  std::vector<Triangle> triangles(static_cast<std::size_t>(count));
  for (Triangle& triangle : triangles) {
    const std::int64_t x0 = random.below(2 * reach) - reach, y0 = random.below(2 * reach) - reach;
    const std::int64_t x1 = random.below(2 * reach) - reach, y1 = random.below(2 * reach) - reach;
    const double t = static_cast<double>(random.below(1001)) / 1000.0;
    const auto along = [&](std::int64_t from, std::int64_t to) {
      return from + std::llround(t * static_cast<double>(to - from)) + random.below(11) - 5;
    };
    const auto x2 = static_cast<std::int32_t>(along(x0, x1)), y2 = static_cast<std::int32_t>(along(y0, y1));
    triangle = {SnappedPoint{static_cast<std::int32_t>(x0), static_cast<std::int32_t>(y0)},
                SnappedPoint{static_cast<std::int32_t>(x1), static_cast<std::int32_t>(y1)}, SnappedPoint{x2, y2}};
  }
  return triangles;
}

/// A grid of quadrilaterals with jittered corners that hides the whole of a 128x96 target, each cut
/// into two triangles along alternating diagonals.                                  [rules, case 12]
inline std::vector<Triangle> jittered_mesh() {
  constexpr int kColumns = 17, kRows = 13, kMargin = 2048, kJitter = 500;
  Random random(11);
  std::vector<SnappedPoint> points;
  for (int j = 0; j <= kRows; ++j)
    for (int i = 0; i <= kColumns; ++i) {
      const auto jitter_x = static_cast<std::int32_t>(random.below(2 * kJitter + 1) - kJitter);
      const auto jitter_y = static_cast<std::int32_t>(random.below(2 * kJitter + 1) - kJitter);
      points.push_back({-kMargin + i * 2168 + jitter_x, -kMargin + j * 2205 + jitter_y});
    }
  const auto point = [&](int i, int j) { return points[static_cast<std::size_t>(j * (kColumns + 1) + i)]; };
  std::vector<Triangle> triangles;
  for (int j = 0; j < kRows; ++j)
    for (int i = 0; i < kColumns; ++i) {
      const SnappedPoint a = point(i, j), b = point(i + 1, j), c = point(i + 1, j + 1), d = point(i, j + 1);
      if ((i + j) % 2 == 0) triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
      else triangles.insert(triangles.end(), {{a, b, d}, {b, c, d}});
    }
  return triangles;
}

/// 64 triangles about the centre of pixel (32, 32), rim at 20 pixels.                [rules, case 11]
inline std::vector<Triangle> fan_about_a_centre() {
  constexpr double kPi = 3.14159265358979323846;
  const SnappedPoint hub{32 * 256 + 128, 32 * 256 + 128};
  const auto rim = [&](int i) {
    const double angle = 2 * kPi * (i % 64) / 64;
    return SnappedPoint{hub.x + static_cast<std::int32_t>(std::lround(20 * 256 * std::cos(angle))),
                        hub.y + static_cast<std::int32_t>(std::lround(20 * 256 * std::sin(angle)))};
  };
  std::vector<Triangle> triangles;
  for (int i = 0; i < 64; ++i) triangles.push_back({hub, rim(i), rim(i + 1)});
  return triangles;
}

}  // namespace tuberia::test
