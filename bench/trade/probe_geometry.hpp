#pragma once
// Exact answers about polygons on a grid of pixels.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>

namespace tuberia::bench::trade {

/// Positions in units of 2^-kFineBits pixel, far finer than the machine's grid.
inline constexpr int kFineBits = 13;

struct FinePoint {
  std::int64_t x = 0, y = 0;  // |.| <= 2^29, so that edge functions are exact in 64 bits
};

/// Whether the triangle, of either winding, holds the centre of pixel (x, y); exact. A centre on an edge is
/// outside: what is on an edge at this grid is too seldom to matter.
bool covers_centre(const std::array<FinePoint, 3>& triangle, int x, int y) noexcept;

/// Length of the outline, in pixels.
double perimeter(const std::array<FinePoint, 3>& triangle) noexcept;

/// Area of the part of pixel (x, y) that the convex polygon covers, 0..1. Corners in pixels, of either winding, at
/// most 8.
double covered_area(std::span<const glm::dvec2> polygon, int x, int y) noexcept;

}  // namespace tuberia::bench::trade
