#pragma once
// The diamond-exit rule, read literally.

#include <cstdint>

namespace tuberia::oracle {

struct UnitPoint {
  std::int64_t x = 0, y = 0;  // 1/256 pixel
};

/// Whether the segment from a to b, both moved by (+h, +h^2) with h infinitely small, meets the open
/// diamond |x - cx| + |y - cy| < 128 around c without ending in it.
bool leaves_diamond(UnitPoint a, UnitPoint b, UnitPoint c);

}  // namespace tuberia::oracle
