#pragma once
// What a light sees, for programs that ask what it does not see.                            [A 1.3]

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>

#include "pipeline/fragment_program.hpp"
#include "raster/sampler.hpp"
#include "raster/texture.hpp"

namespace tuberia {

/// Depths as seen from a light, and how a fragment is compared with them; draw_shadow_map makes one. Outside
/// the light's view all is lit, and so is what lies before or beyond all that was drawn.
///
/// A texel holds the depth of one point of what it covers, so a surface that is not square to the light would
/// shade itself in stripes: its points are moved before they are compared. Let h be the height over its
/// tangent plane that clears all depths which the filter may read, in world units: half the filter's width
/// times the tilt of the plane; h follows from the normal. slope_bias moves a point towards the light until
/// it is slope_bias h above the plane, normal_offset moves it along the normal by normal_offset h: a factor
/// of 1 in one of them is enough on a plane. Both, and constant_bias, let go of shadows that begin within
/// that distance of what casts them.                                         [FIX 13] docs/shadows.md
struct ShadowMap {
  static constexpr int kMaxTaps = 8;
  std::shared_ptr<const Texture> depths;       // depth32f, a rectangle or a cube: 0 near the light, 1 far or nothing
  glm::mat4 map_from_world{1.0f};              // to (s, t, depth, 1) times w, w > 0 before the light; s, t as of textures
  glm::vec3 texel_right{0}, texel_down{0};     // what a texel's sides span where w is 1, world units
  // Of a cube, for lights that shine all around, map_from_world gives the point seen from the light, in the
  // world's directions; with m the largest of its coordinates the depth is cube_depth.x + cube_depth.y / m.
  glm::vec2 cube_depth{0};
  float depth_error = 0x1p-22f;                // depths that differ by no more count as equal: roundings
  float constant_bias = 0;                     // world units towards the light
  float slope_bias = 1;                        // in heights h
  float normal_offset = 0;                     // in heights h
  int taps = 1;                                // 1..kMaxTaps: as many texels each way are compared, and the results filtered
  bool operator==(const ShadowMap&) const = default;
};

/// A picture that a light throws, as a slide projector does: its colours times the light's intensity. Black
/// outside of the picture and behind the projector.
struct ProjectedTexture {
  std::shared_ptr<const Texture> texture;      // two-dimensional
  glm::mat4 map_from_world{1.0f};              // as of ShadowMap
  Sampler sampler{.wrap_u = Wrap::clamp, .wrap_v = Wrap::clamp};
};

/// Why nothing can be compared with this map, or thrown: no texture or one of another kind, a number that is
/// not finite, a negative bias, taps out of range. Names the field first.
Refusal refusal_of(const ShadowMap& map);
Refusal refusal_of(const ProjectedTexture& projected);

}  // namespace tuberia
