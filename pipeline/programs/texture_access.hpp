#pragma once
// Where on its texture a surface looks, and at which level of detail.

#include <cmath>
#include <cstdint>
#include <glm/mat4x4.hpp>

namespace tuberia {

struct TextureAccess {
  /// vertices: the mesh's texture coordinates [B 4.1.2]. sphere: those of the direction of the fragment's
  /// point from the centre of a globe, texture rows from the north pole down [B 4-2 to 4-5]; the texture
  /// repeats along u and ends at the poles, whatever the sampler's wraps.
  enum class Coordinates : std::uint8_t { vertices, sphere };
  /// derivatives: log2 of the texels from a fragment to the next; on a globe as many as at its equator, since u's own
  /// derivatives grow beyond bounds at the poles. distance: log2(d / texel_distance) with the distance d from the
  /// eye, whatever the surface's slant [A 1.1]. Globes and distances are not filtered anisotropically.
  enum class LevelRule : std::uint8_t { derivatives, distance };

  Coordinates coordinates = Coordinates::vertices;
  glm::mat4 globe_from_world{1.0f};  // of sphere: centre to the origin, north pole to +y, u = 0 to +x
  LevelRule level_rule = LevelRule::derivatives;
  float texel_distance = 1;          // of distance: where a texel is as large as a pixel; > 0
  bool operator==(const TextureAccess&) const = default;
};

/// How far from the eye a texel of this size (world units) covers one pixel of a picture so many pixels
/// high, seen by a camera with this vertical opening in radians.
inline double texel_distance(double texel_size, double vertical_opening, int height_pixels) noexcept {
  return texel_size * height_pixels / (2 * std::tan(vertical_opening / 2));
}

}  // namespace tuberia
