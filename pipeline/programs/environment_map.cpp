#include "pipeline/programs/environment_map.hpp"

#include <cmath>

namespace tuberia {
namespace {

bool is_finite(const glm::mat3& m) noexcept {
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      if (!std::isfinite(m[column][row])) return false;
  return true;
}

}  // namespace

const char* refusal_of(const EnvironmentMap& map) noexcept {
  if (map.kind == EnvironmentMap::Kind::none) return nullptr;
  if (!map.texture) return "its environment map has no texture";
  const bool is_cube = map.kind == EnvironmentMap::Kind::cube;
  if (is_cube && map.texture->kind() != TextureKind::cube) return "its environment map is a cube map, but the texture is not";
  if (!is_cube && map.texture->kind() != TextureKind::two_dimensional) return "its environment map is a picture, but the texture is no rectangle";
  if (map.texture->format() == TextureFormat::depth32f) return "its environment map is a texture of depths";
  if (!is_finite(map.map_from_world)) return "its environment map's matrix is not finite";
  return refusal_of(map.sampler);
}

}  // namespace tuberia
