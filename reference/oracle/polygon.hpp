#pragma once
// What is drawn of a clipped primitive: its inside, its edges or its corners.

#include <vector>

#include "reference/oracle/screen.hpp"

namespace tuberia::oracle {

/// What clipping left of a primitive (a line has 2 corners, a point 1), on the screen.
struct Polygon {
  std::vector<Corner> corners;
  std::vector<ScreenVertex> vertices;  // one a corner
  std::vector<ClipVertex> own;         // the primitive's vertices, the provoking one first
  std::uint32_t number = 0;
};

void add_point(const Polygon&, std::vector<ScreenPrimitive>& out);

/// The counter of the stipple, if lines share one, moves on by the line's length.
void add_line(const Polygon&, std::int64_t* stipple_counter, std::vector<ScreenPrimitive>& out);

/// By facing, culling and polygon mode.
void add_polygon(const Polygon&, const Draw&, DepthFormat, std::vector<ScreenPrimitive>& out);

}  // namespace tuberia::oracle
