#pragma once
// The definition of perspective-correct interpolation, for references and tests; the
// rasterizer's wide form is in raster/simd/interpolation-inl.hpp.

#include <array>

namespace tuberia {

/// The value of an attribute inside a projected triangle [C 4.3], rules P1.
/// barycentric: the point's weights IN THE PROJECTION, sum 1.
/// value: the attribute at the vertices.   w: the vertices' clip w (or view z), not 0.
inline double perspective_correct(const std::array<double, 3>& barycentric,
                                  const std::array<double, 3>& value,
                                  const std::array<double, 3>& w) noexcept {
  double weighted_value = 0, weight = 0;
  for (std::size_t vertex = 0; vertex < 3; ++vertex) {
    weighted_value += barycentric[vertex] / w[vertex] * value[vertex];
    weight += barycentric[vertex] / w[vertex];
  }
  return weighted_value / weight;
}

}  // namespace tuberia
