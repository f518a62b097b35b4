#include "raster/screen_triangle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tuberia {

TriangleExtent extent_of(const ScreenTriangle& t) noexcept {
  const bool is_small = t.is_near != 0 && t.right - t.left < kSmallPixels && t.bottom - t.top < kSmallPixels;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (!is_small) return {t.left, t.top, t.right, t.bottom, -kInfinity, kInfinity};
  // A near triangle's weights are right to some 2^-22 inside it, so no depth there lies farther beyond
  // those of the vertices than the margin.
  const float second = t.depth + t.depth_delta[0], third = t.depth + t.depth_delta[1];
  const float margin = 0x1p-19f * (std::abs(t.depth) + std::abs(t.depth_delta[0]) + std::abs(t.depth_delta[1]));
  return {t.left, t.top, t.right, t.bottom, std::min(std::min(second, third), t.depth) - margin,
          std::max(std::max(second, third), t.depth) + margin};
}

}  // namespace tuberia
