#pragma once
// The state of a draw, as plain data: each stage's part holds only what that stage reads.

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "math/spaces.hpp"
#include "raster/blend_state.hpp"
#include "raster/block.hpp"
#include "raster/depth_state.hpp"

namespace tuberia {

/// How a draw's vertices join into triangles [C 3.6]. A strip's triangles n share two vertices
/// with their predecessors and keep its winding; a fan's share the first vertex of all.
enum class Topology : std::uint8_t { triangles, triangle_strip, triangle_fan };

/// A light of the local model [B 2.1].
struct Light {
  enum class Kind : std::uint8_t { directional, point };
  Kind kind = Kind::directional;
  glm::vec3 towards{0, 0, 1};        // directional: unit vector to the light; point: its position; world space
  glm::vec3 intensity{1};            // Ip, linear RGB
  bool operator==(const Light&) const = default;
};

/// The local model's constants [B 2-4, 2-7]: I = ambient + sum over the lights of
/// Ip * (diffuse (N.L) + specular (R.V)^shininess), or (N.H) instead of (R.V).
struct Lighting {
  static constexpr int kMaxLights = 4;
  glm::vec3 ambient{0.1f};           // ka * Ia, linear RGB
  glm::vec3 diffuse{0.8f};           // kd
  glm::vec3 specular{0};             // ks
  float shininess = 32;              // n, >= 0
  float alpha = 1;                   // of the result
  bool halfway = true;               // Blinn's N.H; false: Phong's R.V
  bool two_sided = false;            // light the side that faces the eye
  glm::vec3 eye{0, 0, 1};            // world space
  std::array<Light, kMaxLights> lights{};
  int light_count = 1;               // 0..kMaxLights
  bool operator==(const Lighting&) const = default;
};

struct TransformState {
  glm::mat4 world_from_object{1.0f};
  glm::mat4 clip_from_world{1.0f};
  std::optional<Lighting> vertex_lighting;  // when set, light times the mesh's colours (Gouraud)
  bool operator==(const TransformState&) const = default;
};

struct AssemblyState {
  Topology topology = Topology::triangles;
  bool operator==(const AssemblyState&) const = default;
};

struct ClippingState {
  ClipVolume volume = ClipVolume::minus_w_to_w;
  bool operator==(const ClippingState&) const = default;
};

struct ViewportState {
  std::optional<Viewport> viewport;  // the whole target unless set
  DepthRange depth_range;            // near_depth > far_depth reverses the buffer
  bool operator==(const ViewportState&) const = default;
};

enum class Winding : std::uint8_t { counter_clockwise, clockwise };  // as seen on the screen
enum class CullFace : std::uint8_t { none, back, front };

struct CullingState {
  Winding front_face = Winding::counter_clockwise;
  CullFace cull = CullFace::none;
  bool operator==(const CullingState&) const = default;
};

struct RasterizationState {
  std::optional<PixelRect> scissor;  // pixels outside stay untouched
  bool flat_shading = false;         // every attribute as at the triangle's first vertex
  bool operator==(const RasterizationState&) const = default;
};

struct PipelineState {
  TransformState transform;
  AssemblyState assembly;
  ClippingState clipping;
  ViewportState viewport;
  CullingState culling;
  RasterizationState rasterization;
  DepthState depth;
  BlendState blend;
  bool operator==(const PipelineState&) const = default;
};

}  // namespace tuberia
