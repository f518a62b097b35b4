#pragma once
// Where projection leaves a vertex, and where geometry that was transformed elsewhere enters.

#include <cstdint>

namespace tuberia {

/// A vertex of the screen. One load brings all of it, wherever it lies.
struct ScreenVertex {
  std::int32_t x = 0, y = 0;  // 24.8 units, within the guard band of +-2^23
  float depth = 0;            // [0, 1]
  float w = 1;                // clip w, > 0, for perspective-correct interpolation
};
static_assert(sizeof(ScreenVertex) == 16);

}  // namespace tuberia
