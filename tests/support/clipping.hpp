#pragma once
// Clipped polygons as tests look at them.

#include <array>
#include <cmath>
#include <vector>

#include "pipeline/clipping.hpp"

namespace tuberia::test {

using ClipCorners = std::array<std::array<double, 4>, 3>;  // x, y, z, w each

inline constexpr std::uint32_t kAllPlanes = 63;

/// The volumes with nothing to spare beyond the screen.
inline constexpr ClipLimits kTightGl{.guard_x = 1, .guard_y = 1, .z_low = -1};
inline constexpr ClipLimits kTightD3d{.guard_x = 1, .guard_y = 1, .z_low = 0};

struct NdcPoint {
  double x, y;
};

inline std::vector<NdcPoint> ndc_of(const ClippedPolygon& polygon) {
  std::vector<NdcPoint> points;
  for (int i = 0; i < polygon.count; ++i) {
    const double* p = polygon.corner[static_cast<std::size_t>(i)].position;
    points.push_back({p[0] / p[3], p[1] / p[3]});
  }
  return points;
}

/// Without sign.
inline double ndc_area(const ClippedPolygon& polygon) {
  const std::vector<NdcPoint> p = ndc_of(polygon);
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const NdcPoint& next = p[(i + 1) % p.size()];
    twice += p[i].x * next.y - p[i].y * next.x;
  }
  return std::abs(twice) / 2;
}

}  // namespace tuberia::test
