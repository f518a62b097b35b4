#pragma once
// Everything a draw of the oracle depends on, as plain data with the documents' names. These types
// are the oracle's own: a witness shares no code with the accused.

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "reference/oracle/texture.hpp"

namespace tuberia::oracle {

enum class Topology { triangles, triangle_strip, triangle_fan, lines, line_strip, line_loop, points };
enum class ClipVolume { minus_w_to_w, zero_to_w };
enum class Winding { counter_clockwise, clockwise };
enum class CullFace { none, back, front };
enum class PolygonMode { fill, line, point };
enum class EdgeArithmetic { exact, exact_64, float_anchored, float_plane };
enum class PerspectiveCorrection { each_pixel, every_8_pixels, every_16_pixels, every_32_pixels, none };
enum class StencilOperation { keep, zero, replace, increment, decrement, invert, increment_wrap, decrement_wrap };
enum class FogMode { off, linear, exp, exp2 };
enum class DepthFormat { d16, d24, d32f };
enum class ColourFormat { rgba8, srgb8, rgba32f, rgba16f };
enum class BlendMode { replace, source_over, additive, function };
enum class BlendFactor {
  zero, one,
  source_colour, one_minus_source_colour, destination_colour, one_minus_destination_colour,
  source_alpha, one_minus_source_alpha, destination_alpha, one_minus_destination_alpha,
  constant_colour, one_minus_constant_colour, constant_alpha, one_minus_constant_alpha,
  source_alpha_saturate,
};
enum class BlendEquation { add, subtract, reverse_subtract, min, max };
enum class LogicOperation {
  off, clear, and_, and_reverse, copy, and_inverted, noop, xor_, or_, nor, equivalent, invert,
  or_reverse, copy_inverted, or_inverted, nand, set,
};

struct Rectangle {  // pixels; left and top belong to it, right and bottom do not
  int left = 0, top = 0, right = 0, bottom = 0;
};
struct Viewport {
  int x = 0, y = 0, width = 0, height = 0;
};

struct PolygonOffset {
  float factor = 0, units = 0, clamp = 0;
  bool fill = true, line = true, point = true;
};

struct Stipple {
  std::uint16_t bits = 0xffff;
  int factor = 1;
};

struct StencilFace {
  Compare test = Compare::always;
  std::uint8_t reference = 0, read_mask = 0xff, write_mask = 0xff;
  StencilOperation fail = StencilOperation::keep, depth_fail = StencilOperation::keep, pass = StencilOperation::keep;
};

struct Stencil {
  bool enabled = false;
  StencilFace front, back;
};

struct Fog {
  FogMode mode = FogMode::off;
  glm::vec4 colour{0};
  float density = 1, start = 0, end = 1;
  bool per_vertex = false;
};

struct BlendFunction {
  BlendFactor source = BlendFactor::one, destination = BlendFactor::zero;
  BlendEquation equation = BlendEquation::add;
};

struct Blend {
  BlendMode mode = BlendMode::replace;
  bool write = true;
  BlendFunction colour, alpha;
  glm::vec4 constant{0};
  LogicOperation logic = LogicOperation::off;
  std::array<bool, 4> mask{true, true, true, true};
};

/// How a texture unit makes its colour (or alpha); see pipeline/programs/fixed_function.hpp.
enum class CombineFunction { replace, modulate, add, add_signed, interpolate, subtract, dot3_rgb, dot3_rgba };
enum class CombineSource { texture, constant, primary, previous };
enum class CombineOperand { colour, one_minus_colour, alpha, one_minus_alpha };
struct CombineArgument {
  CombineSource source = CombineSource::texture;
  CombineOperand operand = CombineOperand::colour;
};
struct Combine {
  CombineFunction function = CombineFunction::modulate;
  std::array<CombineArgument, 3> argument{{{CombineSource::texture, CombineOperand::colour},
                                           {CombineSource::previous, CombineOperand::colour},
                                           {CombineSource::constant, CombineOperand::alpha}}};
  int scale = 1;
};
struct TextureUnit {
  const Texture* texture = nullptr;  // null: off
  Sampler sampler;
  Combine colour, alpha;
  glm::vec4 constant{0};
};
inline constexpr std::size_t kTextureUnits = 4;

/// flat: the first vertex's colour; gouraud: the interpolated one; textured: texture times tint,
/// dropped below the cutoff where `cut_out`; textured_gouraud: texture times the interpolated colour;
/// fixed_function: the colour through the texture units.
enum class ProgramKind { flat, gouraud, textured, textured_gouraud, fixed_function };
struct Program {
  ProgramKind kind = ProgramKind::gouraud;
  const Texture* texture = nullptr;
  Sampler sampler;
  glm::vec4 tint{1};
  float alpha_cutoff = 0;
  bool cut_out = false;
  std::array<TextureUnit, kTextureUnits> units;

  bool may_discard() const { return kind == ProgramKind::textured && cut_out; }
};

/// Where a texture coordinate comes from; the linear ones: plane . (x, y, z, 1). The maps need normals:
/// a sphere map makes s and t only, the others s, t and r.
enum class TexCoordSource { vertex, object_linear, eye_linear, sphere_map, reflection_map, normal_map };
struct TexCoordUnit {
  std::array<TexCoordSource, 4> source{};
  std::array<glm::vec4, 4> plane{};
  glm::mat4 matrix{1};
};

/// A light: a direction to it, as given, or its position; world space. A point's intensity may fall off
/// by 1/(d + falloff_distance) or 1/(4 pi d^2), and be kept within a cone around an axis.
enum class Falloff { none, linear, inverse_square };
struct Light {
  bool is_point = false, is_spot = false;  // a spot is a point, too
  glm::vec3 towards{0, 0, 1}, intensity{1};
  Falloff falloff = Falloff::none;
  float falloff_distance = 1;
  glm::vec3 axis{0, 0, -1};
  float cos_inner = 1, cos_outer = 1;
};

/// The local model at the vertices.
struct Lighting {
  glm::vec3 ambient{0}, diffuse{1}, specular{0}, eye{0, 0, 1};
  float shininess = 1, alpha = 1;
  bool halfway = true, two_sided = false;
  std::vector<Light> lights;
};

/// How vertices arrive: in object space, in clip space, or already on the screen.
enum class PositionSpace { object, clip, screen };

struct InputVertex {
  glm::vec4 position{0, 0, 0, 1};      // object (w unused), or clip
  std::int32_t screen_x = 0, screen_y = 0;  // units; PositionSpace::screen only, as the next
  float screen_depth = 0;                   // and position.w is its w
  glm::vec3 normal{0};                      // object space
  glm::vec4 colour{1}, back_colour{1};
  glm::vec2 texcoord{0};
  std::array<glm::vec4, kTextureUnits> unit_texcoord{};  // (s, t, r, q)
  float fog_coordinate = 0;
  bool edge_flag = true;
};

struct Draw {
  Topology topology = Topology::triangles;
  PositionSpace space = PositionSpace::clip;
  std::vector<InputVertex> vertices;
  std::vector<std::uint32_t> indices;  // empty: in order of arrival
  bool has_fog_coordinates = false, has_normals = false;
  bool has_colours = true, has_back_colours = true;  // else white; else as the front
  glm::mat4 world_from_object{1}, clip_from_world{1};
  glm::mat4 view_from_world{1};  // only generated texture coordinates read it
  std::optional<Lighting> vertex_lighting, back_lighting;  // back: with two_sided_colours; else as the front's
  std::array<TexCoordUnit, kTextureUnits> texcoord_units;
  bool has_unit_texcoords = false;  // else (texcoord, 0, 1)

  ClipVolume volume = ClipVolume::minus_w_to_w;
  std::vector<glm::dvec4> user_planes;
  std::optional<Viewport> viewport;
  float near_depth = 0, far_depth = 1;

  Winding front_face = Winding::counter_clockwise;
  CullFace cull = CullFace::none;
  bool two_sided_colours = false;
  PolygonMode front_mode = PolygonMode::fill, back_mode = PolygonMode::fill;
  PolygonOffset polygon_offset;
  std::optional<Rectangle> scissor;
  bool flat_shading = false;
  int subpixel_bits = 8;
  PerspectiveCorrection perspective = PerspectiveCorrection::each_pixel;
  EdgeArithmetic edge_arithmetic = EdgeArithmetic::exact;
  float point_size_pixels = 1;
  bool round_points = false;
  float line_width_pixels = 1;
  std::optional<Stipple> stipple;

  Program program;
  Fog fog;
  Compare alpha_test = Compare::always;
  float alpha_reference = 0;
  bool alpha_to_coverage = false;
  Stencil stencil;
  Compare depth_test = Compare::less;
  bool depth_write = true;
  Blend blend;
};

}  // namespace tuberia::oracle
