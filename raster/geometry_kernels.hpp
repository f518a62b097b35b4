#pragma once
// The wide loops of the geometry stages, on plain arrays; one table per instruction set. All are
// exact: every set gives the same bits.

#include <cstdint>
#include <span>

#include "math/fixed_point.hpp"
#include "raster/block.hpp"
#include "raster/fragment_state.hpp"
#include "raster/instruction_set.hpp"
#include "raster/screen_triangle.hpp"
#include "raster/screen_vertex.hpp"

namespace tuberia {

/// Arrays that kernels read or write may be touched up to this many elements beyond their count.
inline constexpr std::size_t kKernelPadding = 16;

/// Where a clip-space vertex lies: one bit for every plane it is outside of.
namespace outcode {
inline constexpr std::uint32_t left = 1, right = 2, bottom = 4, top = 8;  // the guard band's planes
inline constexpr std::uint32_t near = 16, far = 32;                       // the two ends of z
inline constexpr std::uint32_t behind = 64;    // w <= 0
inline constexpr std::uint32_t invalid = 128;  // not finite: the primitive is dropped
inline constexpr std::uint32_t user = 256;     // the first user plane; plane k has user << k
}  // namespace outcode

/// Clip-space vertices, an array for each coordinate.
struct ClipArrays {
  float *x, *y, *z, *w;
  std::uint32_t* outcode;
};

/// The volume that outcodes and clipping refer to: |x| <= guard_x * w, |y| <= guard_y * w, and
/// z_low * w <= z <= w (z_low is -1 or 0); and the user's planes, inside where
/// ((a x + b y) + c z) + d w >= 0 in double.
struct ClipLimits {
  static constexpr int kMaxUserPlanes = 8;
  float guard_x = 1, guard_y = 1, z_low = -1;
  int user_plane_count = 0;
  double user_planes[kMaxUserPlanes][4] = {};
};

/// Affine maps from ndc to the screen: pixels and depth, e.g. x_pixels = ndc.x * x_scale + x_offset;
/// and the fineness of the grid of places there, 2^-subpixel_bits pixels.
struct ScreenMap {
  double x_scale, x_offset, y_scale, y_offset, depth_scale, depth_offset;
  int subpixel_bits = kSubpixelBits;  // 0..8
};

/// Triangles as three arrays of vertex slots, with what else must stay with them.
struct TriangleArrays {
  std::uint32_t *v0, *v1, *v2, *provoking, *primitive;
  std::uint8_t* is_back;  // culling writes it, setup copies it
};

/// Which triangles stay, and what they are called.
struct CullOptions {
  bool keep_clockwise = true, keep_counter_clockwise = true;
  bool counter_clockwise_is_back = false;  // else the clockwise ones are
  int margin_pixels = 0;                   // 1 where samples may lie beside the centres
};

struct CullResult {
  int kept = 0;
  int uncovered = 0;  // dropped only because they cover none of the centres within their bounds
};

/// Vectors of a mesh, three floats each.
struct Triples {
  const float* first;
  std::size_t count;
};

struct GeometryKernels {
  /// Clip position and outcode of `count` vertices: column-major matrix * (position, 1).
  /// source: their numbers in `positions`.
  void (*transform_positions)(const float* matrix, const Triples& positions, const std::uint32_t* source, int count,
                              const ClipLimits& limits, const ClipArrays& out);

  /// Divides by w, maps to the screen and snaps to the grid, round to nearest even, in 24.8 units;
  /// vertices with w <= 0 get the viewport's centre. In double.                                                     [rules R1]
  void (*project)(const ClipArrays& clip, int count, const ScreenMap& map, ScreenVertex* out);

  /// Keeps, in place and in order, the triangles with an area whose face is wanted and whose bounds
  /// hold a pixel centre of `clip`, except small ones that cover none; their vertices then run clockwise.
  CullResult (*cull)(const TriangleArrays& triangles, int count, const ScreenVertex* vertices, const CullOptions& options,
                     const PixelRect& clip);

  /// Sets up culled triangles; w of their vertices is > 0. With several samples a pixel the
  /// remainders are filled in (else 0), and the bounds reach a pixel beyond the centres they hold.
  void (*set_up)(const TriangleArrays& triangles, int count, const ScreenVertex* vertices, bool has_samples,
                 ScreenTriangle* out);

  /// World positions (affine, column-major 4x4) and unit normals (column-major 3x3) of vertices.
  /// out: x, y, z arrays one after the other, `count` rounded up to kKernelPadding long each.
  void (*transform_points)(const float* matrix, const Triples& positions, const std::uint32_t* source, int count, float* out);
  void (*transform_normals)(const float* matrix, const Triples& normals, const std::uint32_t* source, int count, float* out);

  /// Fog coordinates, in place, to the shares of colour that the fog leaves; its mode is not off.
  void (*fog_shares)(const FogState& fog, int count, float* coordinates);
};

const GeometryKernels& geometry_kernels(InstructionSet) noexcept;

}  // namespace tuberia
