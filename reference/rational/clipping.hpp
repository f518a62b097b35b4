#pragma once
// What is left of a triangle within the view volume, in exact arithmetic.

#include <array>
#include <vector>

#include "reference/rational/number.hpp"

namespace tuberia::rational {

/// A clip position: the four floats.
struct ClipVertex {
  float x = 0, y = 0, z = 0, w = 1;
};
using Triangle = std::array<ClipVertex, 3>;

struct Viewport {
  int x = 0, y = 0, width = 1, height = 1;  // pixels
};

/// Inside are lowest_z w <= z <= w, |x| <= guard_x w, |y| <= guard_y w. The guards are the floats of the
/// contract: (32767 - |centre|) / half the size in double, rounded to float.
struct Volume {
  float guard_x = 1, guard_y = 1;
  int lowest_z = -1;  // or 0
};
Volume volume_of(const Viewport&, int lowest_z) noexcept;

/// A number that the contract computes in double: somewhere within `error` of `value`, as the truth is.
struct Estimate {
  double value = 0, error = 0;
};

/// A corner of the polygon: (x, y, z, w) / divisor in units of 2^Polygon::unit, divisor > 0.
struct Corner {
  Integer x, y, z, w, divisor{1};
  int vertex = -1;                       // which of the triangle's own vertices; -1: a new one
  std::array<Estimate, 4> computed{};    // x, y, z, w; never decides anything
};

struct Polygon {
  std::vector<Corner> corners;  // in the triangle's order; none, or three and more, all with w > 0
  int unit = 0;
  bool is_cut = false;          // it crossed a plane (whether or not something is left)
  // A new corner lies so near to another plane, or its w to 0, that the contract's doubles may see it on
  // either side.
  bool is_doubtful = false;
};

/// Which planes cut is decided by the contract's comparisons of floats; all else is exact: a corner
/// lies where the edge meets the plane. Corners whose w is 0 as a float are left out.
Polygon clipped(const Triangle&, const Volume&);

/// A coordinate of a corner.
inline Quotient quotient(const Polygon& polygon, const Corner& corner, Integer Corner::*coordinate) {
  return {corner.*coordinate, corner.divisor, polygon.unit};
}

}  // namespace tuberia::rational
