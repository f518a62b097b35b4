#pragma once
// From a draw to triangles, lines and points on the screen.

#include <array>
#include <cstdint>
#include <vector>

#include "reference/oracle/clipping.hpp"
#include "reference/oracle/vertices.hpp"

namespace tuberia::oracle {

struct ScreenVertex {
  std::int64_t x = 0, y = 0;  // units of 1/256 pixel
  float depth = 0, w = 1;
  Scalars front{}, back{};
};

struct ScreenPrimitive {
  enum class Kind { triangle, line, point };
  Kind kind = Kind::triangle;
  std::array<ScreenVertex, 3> vertex;  // of a line two, of a point one
  Scalars provoking{};
  bool is_back = false;
  double bias = 0;                  // polygon offset
  std::int64_t stipple_start = 0;
  std::uint32_t number = 0;         // of the primitive in its draw

  const Scalars& scalars(std::size_t i) const { return is_back ? vertex[i].back : vertex[i].front; }
};

/// Twice the area, positive for clockwise triangles.
std::int64_t doubled_area(const ScreenVertex&, const ScreenVertex&, const ScreenVertex&);

struct GeometryResult {
  std::vector<ScreenPrimitive> primitives;  // in the order in which they are drawn
  std::int64_t assembled = 0, clipped = 0, after_clipping = 0;
};
GeometryResult geometry(const Draw&, const Viewport&, DepthFormat);

}  // namespace tuberia::oracle
