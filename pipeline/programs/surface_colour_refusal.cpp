#include "pipeline/programs/surface_colour_refusal.hpp"

#include <string>

#include "pipeline/refusal.hpp"

namespace tuberia {
namespace {

Refusal unknown(const std::string& field, int value) { return Error{field + " is " + std::to_string(value) + ", which its enumeration does not have"}; }

Refusal check_matrix(const std::string& field, const glm::mat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (Refusal refusal = check_finite(field + "[" + std::to_string(column) + "][" + std::to_string(row) + "]", matrix[column][row])) return refusal;
  return {};
}

Refusal check_picture(const BumpMap& bump) {
  if (!bump.texture) return Error{"bump has no texture"};
  if (bump.texture->kind() != TextureKind::two_dimensional) return Error{"bump.texture is not two-dimensional"};
  if (bump.texture->format() == TextureFormat::depth32f) return Error{"bump.texture holds depths"};
  if (bump.texture->format() == TextureFormat::rgba8 && bump.texture->encoding() == TextureEncoding::srgb)
    return Error{"bump.texture has sRGB codes; heights and normals are linear"};
  if (const char* refusal = refusal_of(bump.sampler)) return Error{std::string("bump: ") + refusal};
  return {};
}

}  // namespace

Refusal refusal_of(const Pattern& pattern) {
  if (pattern.kind > Pattern::Kind::marble) return unknown("pattern.kind", static_cast<int>(pattern.kind));
  if (Refusal refusal = check_finite("pattern.first", pattern.first)) return refusal;
  if (Refusal refusal = check_finite("pattern.second", pattern.second)) return refusal;
  if (Refusal refusal = check_finite("pattern.scale", pattern.scale)) return refusal;
  if (Refusal refusal = check_finite("pattern.turbulence", pattern.turbulence)) return refusal;
  return check_matrix("pattern.pattern_from_world", pattern.pattern_from_world);
}

Refusal refusal_of(const TextureAccess& access) {
  if (access.coordinates > TextureAccess::Coordinates::sphere) return unknown("access.coordinates", static_cast<int>(access.coordinates));
  if (access.level_rule > TextureAccess::LevelRule::distance) return unknown("access.level_rule", static_cast<int>(access.level_rule));
  if (Refusal refusal = check_range("access.texel_distance", access.texel_distance, 1e-30f, 1e30f)) return refusal;
  return check_matrix("access.globe_from_world", access.globe_from_world);
}

Refusal refusal_of(const BumpMap& bump) {
  using enum BumpMap::Kind;
  if (bump.kind > rough) return unknown("bump.kind", static_cast<int>(bump.kind));
  if (Refusal refusal = check_finite("bump.gain", bump.gain)) return refusal;
  if (Refusal refusal = check_finite("bump.scale", bump.scale)) return refusal;
  return bump.kind == height_texture || bump.kind == normal_map ? check_picture(bump) : Refusal{};
}

}  // namespace tuberia
