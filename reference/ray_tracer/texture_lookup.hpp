#pragma once
// Textures as rays read them: the same texels as the pipeline's, weighted in double.           [A 1.1] [B 4.1]

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "image/image.hpp"
#include "reference/ray_tracer/ray.hpp"
#include "scene/content/texture_picture.hpp"
#include "scene/description/material.hpp"

namespace tuberia::tracer {

/// How far texture coordinates move from one pixel to the next, to the right and down; 0: unknown, the finest level is read.
struct TextureFootprint {
  glm::dvec2 right{0}, down{0};
};

/// How far a point moves on its surface from one pixel to the next, to the right and down, world units; 0: unknown, and pictures are
/// read at their finest level.
struct PointFootprint {
  glm::dvec3 right{0}, down{0};
};

/// That of a footprint in texture coordinates, along the surface's tangents.
inline PointFootprint point_footprint(const SurfacePoint& at, const TextureFootprint& footprint) noexcept {
  return {.right = footprint.right.x * at.tangent + footprint.right.y * at.bitangent, .down = footprint.down.x * at.tangent + footprint.down.y * at.bitangent};
}

/// How a texture is read; what docs/conventions.md says of it.
struct TextureRules {
  enum class Mipmaps : std::uint8_t { none, nearest, linear };
  bool is_nearest = false;                      // within a level: one texel, or the four around
  Mipmaps mipmaps = Mipmaps::linear;
  description::Texture::Wrap wrap = description::Texture::Wrap::repeat;
  double anisotropy = 1;                        // 1..16
};

TextureRules rules_of(const description::Texture& texture) noexcept;

/// A picture with its smaller levels, each the mean of the one before over equal parts of its area, in linear
/// light; levels of codes are rounded to codes.                                                           [rules T6]
class TextureLookup {
 public:
  TextureLookup(const TexturePicture& picture, const TextureRules& rules);

  /// Each level in one colour of its own: red, yellow, green, cyan, blue, magenta, and darker ones of the same. [A 1.1]
  void colour_levels();

  /// Linear RGB, and alpha; (0, 0) is the upper left corner of the picture. Coordinates that are not finite count as 0.
  glm::dvec4 at(const glm::dvec2& uv, const TextureFootprint& footprint) const noexcept;
  /// At a level of detail, 0 being the finest, whatever the footprint.
  glm::dvec4 at_level(const glm::dvec2& uv, double level_of_detail) const noexcept;

  glm::ivec2 size() const noexcept { return {levels_[0].width(), levels_[0].height()}; }
  int level_count() const noexcept { return static_cast<int>(levels_.size()); }
  const Image<Rgba32F>& level(int index) const noexcept { return levels_[static_cast<std::size_t>(index)]; }

 private:
  glm::dvec4 within_level(const Image<Rgba32F>& level, const glm::dvec2& uv) const noexcept;

  std::vector<Image<Rgba32F>> levels_;
  TextureRules rules_;
};

}  // namespace tuberia::tracer
