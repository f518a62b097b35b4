#include "pipeline/programs/shadow_map.hpp"

#include <cmath>
#include <string>

#include "pipeline/refusal.hpp"

namespace tuberia {
namespace {

Refusal check_not_negative(const std::string& field, float value) {
  if (value >= 0 && std::isfinite(value)) return {};
  return Error{field + " is " + words_of(value) + "; it must be finite and not negative"};
}

Refusal check_matrix(const std::string& field, const glm::mat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (Refusal refusal = check_finite(field, matrix[column][row])) return refusal;
  return {};
}

Refusal check_depths(const std::shared_ptr<const Texture>& depths) {
  if (!depths) return Error{"depths is missing"};
  if (depths->format() == TextureFormat::depth32f && (depths->kind() == TextureKind::two_dimensional || depths->kind() == TextureKind::cube)) return {};
  return Error{"depths is not a rectangle or cube of depths (depth32f)"};
}

}  // namespace

Refusal refusal_of(const ShadowMap& map) {
  if (Refusal refusal = check_depths(map.depths)) return refusal;
  if (map.taps < 1 || map.taps > ShadowMap::kMaxTaps)
    return Error{"taps is " + std::to_string(map.taps) + ", outside 1 to " + std::to_string(ShadowMap::kMaxTaps)};
  if (Refusal refusal = check_matrix("map_from_world", map.map_from_world)) return refusal;
  if (Refusal refusal = check_finite("texel_right", map.texel_right)) return refusal;
  if (Refusal refusal = check_finite("texel_down", map.texel_down)) return refusal;
  if (Refusal refusal = check_finite("cube_depth", glm::vec3(map.cube_depth, 0))) return refusal;
  if (Refusal refusal = check_not_negative("depth_error", map.depth_error)) return refusal;
  if (Refusal refusal = check_not_negative("constant_bias", map.constant_bias)) return refusal;
  if (Refusal refusal = check_not_negative("slope_bias", map.slope_bias)) return refusal;
  return check_not_negative("normal_offset", map.normal_offset);
}

Refusal refusal_of(const ProjectedTexture& projected) {
  if (!projected.texture) return Error{"texture is missing"};
  if (projected.texture->kind() != TextureKind::two_dimensional) return Error{"texture is not two-dimensional"};
  if (projected.texture->format() == TextureFormat::depth32f) return Error{"texture is one of depths"};
  if (const char* refusal = refusal_of(projected.sampler)) return Error{refusal};
  return check_matrix("map_from_world", projected.map_from_world);
}

}  // namespace tuberia
