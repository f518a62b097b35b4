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

Refusal check_texels(const glm::vec3& right, const glm::vec3& down) {
  for (int i = 0; i < 3; ++i) {
    if (Refusal refusal = check_finite("texel_right", right[i])) return refusal;
    if (Refusal refusal = check_finite("texel_down", down[i])) return refusal;
  }
  return {};
}

Refusal check(const ShadowMap& map) {
  if (!map.depths) return Error{"the shadow map has no depths"};
  const TextureKind kind = map.depths->kind();
  if (map.depths->format() != TextureFormat::depth32f || (kind != TextureKind::two_dimensional && kind != TextureKind::cube))
    return Error{"the shadow map's depths are not a rectangle or cube of depths (depth32f)"};
  if (map.taps < 1 || map.taps > ShadowMap::kMaxTaps)
    return Error{"taps is " + std::to_string(map.taps) + ", outside 1 to " + std::to_string(ShadowMap::kMaxTaps)};
  if (Refusal refusal = check_matrix("map_from_world", map.map_from_world)) return refusal;
  if (Refusal refusal = check_texels(map.texel_right, map.texel_down)) return refusal;
  if (Refusal refusal = check_finite("cube_depth.x", map.cube_depth.x)) return refusal;
  if (Refusal refusal = check_finite("cube_depth.y", map.cube_depth.y)) return refusal;
  if (Refusal refusal = check_not_negative("depth_error", map.depth_error)) return refusal;
  if (Refusal refusal = check_not_negative("constant_bias", map.constant_bias)) return refusal;
  if (Refusal refusal = check_not_negative("slope_bias", map.slope_bias)) return refusal;
  return check_not_negative("normal_offset", map.normal_offset);
}

Refusal check(const ProjectedTexture& projected) {
  if (!projected.texture) return Error{"the projected texture has no texture"};
  if (projected.texture->kind() != TextureKind::two_dimensional) return Error{"the projected texture is not two-dimensional"};
  if (const char* refusal = refusal_of(projected.sampler)) return Error{refusal};
  return check_matrix("map_from_world", projected.map_from_world);
}

const char* text_of(const Refusal& refusal) {
  static thread_local std::string text;
  if (!refusal) return nullptr;
  text = refusal->message;
  return text.c_str();
}

}  // namespace

const char* refusal_of(const ShadowMap& map) { return text_of(check(map)); }
const char* refusal_of(const ProjectedTexture& projected) { return text_of(check(projected)); }

}  // namespace tuberia
