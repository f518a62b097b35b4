#pragma once
// Cutting triangles, lines and polygons with planes, in clip space and in double: the geometry of
// stage 3, which can be used alone.

#include <array>
#include <span>
#include <vector>

#include "math/spaces.hpp"
#include "pipeline/state.hpp"
#include "raster/geometry_kernels.hpp"

namespace tuberia {

/// The volume of a viewport: z by the ClipVolume; x and y as far as the guard band of +-32768
/// pixels reaches, so that most triangles which leave the screen stay whole, and exact. [rules C7]
ClipLimits clip_limits(const Viewport& viewport, ClipVolume volume) noexcept;
/// The same with the user's planes.
ClipLimits clip_limits(const Viewport& viewport, const ClippingState& state) noexcept;

/// Which planes of the limits a position (x, y, z, w; clip space) is outside of: outcode bits.
std::uint32_t outcode_of(const glm::vec4& position, const ClipLimits& limits) noexcept;
/// The user's planes alone.
std::uint32_t user_outcode_of(const glm::vec4& position, const ClipLimits& limits) noexcept;

/// A corner of a clipped polygon.
struct ClippedCorner {
  double position[4];  // x, y, z, w in clip space
  double weight[3];    // of the triangle's vertices
};

/// A triangle cut by 6 planes has at most 3 + 6 corners; one more for each user plane. [C 3.7, FIX 3]
struct ClippedPolygon {
  std::array<ClippedCorner, 9 + ClipLimits::kMaxUserPlanes> corner;
  int count = 0;
};

/// Cuts a triangle (3 positions x, y, z, w; clip space, finite) with the planes named in `planes`
/// (outcode bits). Returns a convex polygon of 0 or 3..17 corners, all with w > 0 and within the
/// planes; a corner on a plane lies on it exactly, but for user planes. Cuts are computed from the inside to the
/// outside, so that both triangles of an edge get the same vertex.       [rules C1, C2, C4, C6]
ClippedPolygon clip_triangle(std::span<const std::array<double, 4>, 3> triangle, std::uint32_t planes,
                             const ClipLimits& limits) noexcept;

/// A line as two corners, or none; the third weight of each is 0.
struct ClippedLine {
  ClippedCorner corner[2];
  bool is_empty = false;
};

/// Cuts a line in the same way.
ClippedLine clip_line(std::span<const std::array<double, 4>, 2> line, std::uint32_t planes, const ClipLimits& limits) noexcept;

/// Cuts a convex polygon of any number of corners (x, y, z, w; clip space, finite) with all planes of
/// the limits, in the same way. Returns its corners, all with w > 0: none, or three and more.
std::vector<glm::dvec4> clip_polygon(std::span<const glm::dvec4> corners, const ClipLimits& limits);

}  // namespace tuberia
