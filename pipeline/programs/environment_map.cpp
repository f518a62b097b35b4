#include "pipeline/programs/environment_map.hpp"

#include <string>

#include "pipeline/refusal.hpp"

namespace tuberia {
namespace {

Refusal check_texture(const EnvironmentMap& map) {
  if (!map.texture) return Error{"the environment map has no texture"};
  const bool is_cube = map.kind == EnvironmentMap::Kind::cube;
  if (map.texture->kind() != (is_cube ? TextureKind::cube : TextureKind::two_dimensional))
    return Error{is_cube ? "the environment map's texture is no cube" : "the environment map's texture is no rectangle"};
  if (map.texture->format() == TextureFormat::depth32f) return Error{"the environment map's texture holds depths"};
  return {};
}

}  // namespace

Refusal refusal_of(const EnvironmentMap& map) {
  using Kind = EnvironmentMap::Kind;
  if (map.kind == Kind::none) return {};
  if (map.kind > Kind::panorama)
    return Error{"the environment map's kind is " + std::to_string(static_cast<int>(map.kind)) + "; its enumeration ends with " +
                 std::to_string(static_cast<int>(Kind::panorama))};
  if (Refusal refusal = check_texture(map)) return refusal;
  for (int column = 0; column < 3; ++column)
    if (Refusal refusal = check_finite("map_from_world[" + std::to_string(column) + "]", map.map_from_world[column])) return refusal;
  if (const char* refusal = refusal_of(map.sampler)) return Error{refusal};
  return {};
}

}  // namespace tuberia
