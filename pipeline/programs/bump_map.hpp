#pragma once
// Relief that only the normals know of.                                          [A 1.2] [B 4.2.1]

#include <cstdint>
#include <memory>

#include "raster/sampler.hpp"
#include "raster/texture.hpp"

namespace tuberia {

/// A height over the surface as a function of its texture coordinates, in world units, or a picture of
/// normals. The surface's tangents t_u, t_v keep their lengths. Formulas: math/bump.hpp.
struct BumpMap {
  /// height_texture: the red of a grey picture (linear codes, or floats), 0 to 1, differentiated by central
  /// differences one texel each way. A few texels, filtered bilinearly, are the notes' table with interpolation.
  /// normal_map: a picture of tangent-space normals, linear codes 0..255 for -1..1: red along the tangent,
  /// green up in the picture (against the bitangent, since v runs down), blue along the normal.
  /// waves, orange, rough: heights in closed form, with analytic derivatives: crossing sine waves; dimples
  /// at random; small random perturbations.
  enum class Kind : std::uint8_t { none, height_texture, normal_map, waves, orange, rough };
  Kind kind = Kind::none;
  std::shared_ptr<const Texture> texture;  // of height_texture and normal_map
  Sampler sampler;
  float gain = 1;            // k: exaggerates (> 1), flattens (< 1), inverts (< 0); heights are gain times the function
  float scale = 8;           // of the closed forms: waves or dimples along one unit of u and of v
  std::uint32_t seed = 1;    // of what is random
};

}  // namespace tuberia
