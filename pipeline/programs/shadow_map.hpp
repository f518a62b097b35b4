#pragma once
// What a light sees, for programs that ask what it does not see.                        [A 1.3, C 4.7]

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <memory>

#include "raster/texture.hpp"

namespace tuberia {

/// Depths as seen from a light, and how they are compared. Outside the light's view all is lit.
struct ShadowMap {
  std::shared_ptr<const Texture> depths;    // depth32f, window depth 0 (near) to 1 (far)
  glm::mat4 map_from_world{1.0f};           // to (s, t, depth) times the fourth coordinate, s and t in [0, 1]
  float constant_bias = 0;                  // subtracted from the fragment's depth, in depths
  float slope_bias = 0;                     // the same, times the tangent of the light's angle to the normal
  float normal_offset = 0;                  // moves the point along its normal before, world units times sin of that angle
  int taps = 1;                             // 1, 2 or 3: as many comparisons each way are averaged (percentage closer)
  bool operator==(const ShadowMap&) const = default;
};

/// A picture that a light throws, as a slide projector does; its colour times the light's intensity.
struct ProjectedTexture {
  std::shared_ptr<const Texture> texture;
  glm::mat4 map_from_world{1.0f};           // as of ShadowMap; black outside and behind
};

}  // namespace tuberia
