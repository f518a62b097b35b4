#pragma once
// The state of a draw, as plain data: each stage's part holds only what that stage reads.

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <optional>

#include "math/fixed_point.hpp"
#include "math/spaces.hpp"
#include "pipeline/lighting.hpp"
#include "raster/attributes.hpp"
#include "raster/blend_state.hpp"
#include "raster/block.hpp"
#include "raster/depth_state.hpp"
#include "raster/fragment_state.hpp"
#include "raster/screen_shape.hpp"
#include "raster/screen_triangle.hpp"
#include "raster/stencil_state.hpp"

namespace tuberia {

/// How a draw's vertices join into primitives [C 3.6]. A strip's triangles n share two vertices
/// with their predecessors and keep its winding; a fan's share the first vertex of all. A line
/// strip's lines share one vertex; a loop has one line more, from the last vertex to the first.
enum class Topology : std::uint8_t { triangles, triangle_strip, triangle_fan, lines, line_strip, line_loop, points };

constexpr bool makes_triangles(Topology topology) noexcept { return topology <= Topology::triangle_fan; }

/// Where a texture coordinate comes from. object_linear and eye_linear: the product of `plane` with
/// the object- or view-space position (x, y, z, 1). The maps use the unit vector u from the eye to
/// the vertex and the unit normal n, in view space: reflection r = u - 2 (n.u) n; sphere_map (only s
/// and t): r.x / m + 1/2 and r.y / m + 1/2 with m = 2 |r + (0, 0, 1)|; reflection_map and normal_map
/// (only s, t, r): the components of r and n.
enum class TexCoordSource : std::uint8_t { vertex, object_linear, eye_linear, sphere_map, reflection_map, normal_map };

/// The texture coordinates (s, t, r, q) of one unit: each from its source, then all times the matrix.
struct TexCoordUnit {
  std::array<TexCoordSource, 4> source{};
  std::array<glm::vec4, 4> plane{};
  glm::mat4 matrix{1.0f};
  bool operator==(const TexCoordUnit&) const = default;
};

struct TransformState {
  glm::mat4 world_from_object{1.0f};
  glm::mat4 clip_from_world{1.0f};
  std::optional<Lighting> vertex_lighting{};  // when set, light times the mesh's colours (Gouraud)
  // When set, in place of the mesh's custom attribute: the cosines of this lighting's first two lights,
  // (n.l, n.h) or (n.l, r.v) each, for the program dot_product.
  std::optional<Lighting> vertex_cosines{};
  // Triangles that are turned away take other colours: MeshView::back_colours (or its colours if it
  // has none), lit by back_lighting (or vertex_lighting) with the normals turned round.
  bool two_sided_colours = false;
  std::optional<Lighting> back_lighting{};
  glm::mat4 view_from_world{1.0f};          // only texture coordinate generation reads it
  std::array<TexCoordUnit, kTextureUnits> texture_units{};
  bool operator==(const TransformState&) const = default;
};

struct AssemblyState {
  Topology topology = Topology::triangles;
  bool operator==(const AssemblyState&) const = default;
};

struct ClippingState {
  static constexpr int kMaxUserPlanes = 8;
  ClipVolume volume = ClipVolume::minus_w_to_w;
  // Inside where plane . (x, y, z, w) >= 0 in clip space, in double; clip_plane_from_world makes one.
  std::array<glm::dvec4, kMaxUserPlanes> user_planes{};
  int user_plane_count = 0;          // 0..8
  bool operator==(const ClippingState&) const = default;
};

struct ViewportState {
  std::optional<Viewport> viewport{};  // the whole target unless set
  DepthRange depth_range{};            // near_depth > far_depth reverses the buffer
  bool operator==(const ViewportState&) const = default;
};

enum class Winding : std::uint8_t { counter_clockwise, clockwise };  // as seen on the screen
enum class CullFace : std::uint8_t { none, back, front };

struct CullingState {
  Winding front_face = Winding::counter_clockwise;
  CullFace cull = CullFace::none;
  bool operator==(const CullingState&) const = default;
};

/// How triangles are drawn: their inside, their edges (those whose flag is set), or their corners
/// (those where such an edge begins).
enum class PolygonMode : std::uint8_t { fill, line, point };

/// Pushes a polygon's depth: factor * m + units * r, where m is its steepest slope, max(|dz/dx|,
/// |dz/dy|) per pixel, and r the smallest difference that the depth format resolves. [rules Z3]
struct PolygonOffset {
  float factor = 0, units = 0;
  float clamp = 0;                               // the most that is added (> 0), or the least (< 0); 0: no limit
  bool fill = true, line = true, point = true;   // the polygon modes that it applies to
  bool operator==(const PolygonOffset&) const = default;
};

struct PointState {
  float size_pixels = 1;             // side or diameter, 1/256..2048, rounded to 1/256
  bool round = false;
  bool operator==(const PointState&) const = default;
};

struct LineState {
  float width_pixels = 1;            // 1..2048; rounded to whole pixels unless multisampled
  std::optional<StipplePattern> stipple{};
  bool operator==(const LineState&) const = default;
};

/// Where weights are divided to follow 1/w: at each pixel; at the ends of segments of a row that begin
/// at multiples of so many pixels, and linearly in between; or nowhere. Of triangles; lines divide always.
enum class PerspectiveCorrection : std::uint8_t { each_pixel, every_8_pixels, every_16_pixels, every_32_pixels, none };

struct RasterizationState {
  std::optional<PixelRect> scissor{};  // pixels outside stay untouched
  bool flat_shading = false;         // every attribute as at the primitive's first vertex
  int subpixel_bits = kSubpixelBits;  // 0..8: vertices are rounded to 2^-subpixel_bits pixels, given screen positions are not
  PerspectiveCorrection perspective = PerspectiveCorrection::each_pixel;  // of attributes and fog; depth needs none
  EdgeArithmetic edge_arithmetic = EdgeArithmetic::exact;  // of triangles; others than exact need one sample a pixel
  PolygonMode front_mode = PolygonMode::fill, back_mode = PolygonMode::fill;
  PolygonOffset polygon_offset{};
  PointState point{};
  LineState line{};
  bool operator==(const RasterizationState&) const = default;
};

struct PipelineState {
  TransformState transform{};
  AssemblyState assembly{};
  ClippingState clipping{};
  ViewportState viewport{};
  CullingState culling{};
  RasterizationState rasterization{};
  FogState fog{};
  AlphaTest alpha_test{};
  SampleState multisampling{};       // how many samples there are is the target's affair
  StencilState stencil{};
  DepthState depth{};
  BlendState blend{};
  bool operator==(const PipelineState&) const = default;
};

/// The clip-space form of a plane of world space, for ClippingState. The matrix must be invertible.
glm::dvec4 clip_plane_from_world(const glm::dvec4& world_plane, const glm::mat4& clip_from_world) noexcept;

}  // namespace tuberia
