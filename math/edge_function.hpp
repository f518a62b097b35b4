#pragma once
// The edge functions of a triangle in exact integers, in screen space with y down.

#include <cstdint>

#include "math/fixed_point.hpp"

namespace tuberia {

/// A point of screen space in 24.8 units, within the guard band.
struct SnappedPoint {
  std::int32_t x = 0, y = 0;
  bool operator==(const SnappedPoint&) const = default;
};

/// Twice the signed area in square units; positive when a, b, c run clockwise on the screen.
/// |result| <= 2^49, exact.
constexpr std::int64_t twice_area(SnappedPoint a, SnappedPoint b, SnappedPoint c) noexcept {
  const std::int64_t abx = b.x - a.x, aby = b.y - a.y, acx = c.x - a.x, acy = c.y - a.y;
  return abx * acy - aby * acx;
}

/// The directed line from one point to another: positive on its right (the inner side of a
/// triangle that runs clockwise), zero on it.
struct EdgeFunction {
  std::int64_t per_x, per_y, constant;  // value = per_x * x + per_y * y + constant

  constexpr EdgeFunction(SnappedPoint from, SnappedPoint to) noexcept
      : per_x(static_cast<std::int64_t>(from.y) - to.y),
        per_y(static_cast<std::int64_t>(to.x) - from.x),
        constant(-(per_x * from.x + per_y * from.y)) {}

  constexpr std::int64_t operator()(SnappedPoint p) const noexcept {
    return per_x * p.x + per_y * p.y + constant;
  }

  /// A left edge runs upwards, a top edge runs level to the right. Points exactly on these belong
  /// to the triangle, points on the others to its neighbour: each sample has one owner. [rules R2]
  constexpr bool is_top_left() const noexcept { return per_x > 0 || (per_x == 0 && per_y > 0); }

  /// Whether a sample at p is on the inner side under the top-left rule.
  constexpr bool owns(SnappedPoint p) const noexcept { return (*this)(p) >= (is_top_left() ? 0 : 1); }
};

}  // namespace tuberia
