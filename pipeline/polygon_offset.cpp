#include "pipeline/polygon_offset.hpp"

#include <algorithm>
#include <cmath>

#include "math/edge_function.hpp"

namespace tuberia {
namespace {

/// The smallest difference of depths that the format tells apart around the largest of three.
double resolution(DepthFormat format, const double (&z)[3]) {
  if (format == DepthFormat::d16) return 0x1p-16;
  if (format == DepthFormat::d24) return 0x1p-24;
  const double largest = std::max({std::abs(z[0]), std::abs(z[1]), std::abs(z[2])});
  const int exponent = largest > 0 ? std::max(std::ilogb(largest), -126) : -126;
  return std::ldexp(1.0, exponent - 23);
}

}  // namespace

bool PolygonOffsetting::applies_to(PolygonMode mode) const noexcept {
  const bool chosen = mode == PolygonMode::fill ? state_.fill : mode == PolygonMode::line ? state_.line : state_.point;
  return chosen && (state_.factor != 0 || state_.units != 0);
}

double PolygonOffsetting::bias(const VertexBatch& vertices, std::uint32_t a, std::uint32_t b, std::uint32_t c) const noexcept {
  const std::uint32_t slot[3] = {a, b, c};
  SnappedPoint p[3];
  double z[3];
  for (int k = 0; k < 3; ++k) {
    p[k] = {vertices.screen[slot[k]].x, vertices.screen[slot[k]].y};
    z[k] = static_cast<double>(vertices.screen[slot[k]].depth);
  }
  double bias = 0;
  const auto area = static_cast<double>(twice_area(p[0], p[1], p[2]));
  if (state_.factor != 0 && area != 0) {
    const double x1 = p[1].x - p[0].x, x2 = p[2].x - p[0].x, y1 = p[1].y - p[0].y, y2 = p[2].y - p[0].y;
    const double z1 = z[1] - z[0], z2 = z[2] - z[0];
    const double per_x = (z1 * y2 - z2 * y1) / area * kSubpixelUnits, per_y = (z2 * x1 - z1 * x2) / area * kSubpixelUnits;
    bias = static_cast<double>(state_.factor) * std::max(std::abs(per_x), std::abs(per_y));
  }
  if (state_.units != 0) bias += static_cast<double>(state_.units) * resolution(format_, z);
  if (state_.clamp > 0) bias = std::min(bias, static_cast<double>(state_.clamp));
  if (state_.clamp < 0) bias = std::max(bias, static_cast<double>(state_.clamp));
  return bias;
}

void PolygonOffsetting::move(const VertexBatch& vertices, std::span<ScreenTriangle> triangles) const noexcept {
  for (ScreenTriangle& t : triangles)
    t.depth = static_cast<float>(static_cast<double>(t.depth) + bias(vertices, t.vertex[0], t.vertex[1], t.vertex[2]));
}

}  // namespace tuberia
