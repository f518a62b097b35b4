#include "pipeline/refusal.hpp"

#include <cmath>
#include <sstream>

namespace tuberia {
std::string words_of(float value) {
  std::ostringstream words;
  words << value;
  return words.str();
}

Refusal check_finite(const std::string& field, float value) {
  if (std::isfinite(value)) return {};
  return Error{field + " is " + words_of(value) + "; it must be finite"};
}

Refusal check_finite(const std::string& field, const glm::vec3& value) {
  if (Refusal refusal = check_finite(field + ".x", value.x)) return refusal;
  if (Refusal refusal = check_finite(field + ".y", value.y)) return refusal;
  return check_finite(field + ".z", value.z);
}

Refusal check_range(const std::string& field, float value, float low, float high) {
  if (value >= low && value <= high) return {};
  return Error{field + " is " + words_of(value) + ", outside " + words_of(low) + " to " + words_of(high)};
}

Refusal refusal_of(const Light& light) {
  if (light.kind > Light::Kind::spot) return Error{"kind is " + std::to_string(static_cast<int>(light.kind)) + "; its enumeration ends with 2"};
  if (light.falloff > Falloff::inverse_square)
    return Error{"falloff is " + std::to_string(static_cast<int>(light.falloff)) + "; its enumeration ends with 2"};
  if (Refusal refusal = check_finite("towards", light.towards)) return refusal;
  if (Refusal refusal = check_finite("intensity", light.intensity)) return refusal;
  if (!(light.falloff_distance >= 0) || !std::isfinite(light.falloff_distance))
    return Error{"falloff_distance is " + words_of(light.falloff_distance) + "; it must be finite and not negative"};
  if (light.kind != Light::Kind::spot) return {};
  if (Refusal refusal = check_finite("axis", light.axis)) return refusal;
  if (Refusal refusal = check_range("cos_outer", light.cos_outer, -1, 1)) return refusal;
  return check_range("cos_inner", light.cos_inner, light.cos_outer, 1);
}

Refusal refusal_of(const Lighting& lighting) {
  if (lighting.light_count < 0 || lighting.light_count > Lighting::kMaxLights)
    return Error{"its number of lights is " + std::to_string(lighting.light_count) + ", outside 0 to " + std::to_string(Lighting::kMaxLights)};
  if (Refusal refusal = check_finite("ambient", lighting.ambient)) return refusal;
  if (Refusal refusal = check_finite("diffuse", lighting.diffuse)) return refusal;
  if (Refusal refusal = check_finite("specular", lighting.specular)) return refusal;
  if (Refusal refusal = check_finite("eye", lighting.eye)) return refusal;
  if (Refusal refusal = check_finite("alpha", lighting.alpha)) return refusal;
  if (!(lighting.shininess >= 0) || !std::isfinite(lighting.shininess))
    return Error{"shininess is " + words_of(lighting.shininess) + "; it must be finite and not negative"};
  if (lighting.normals > NormalInterpolation::not_renormalized)
    return Error{"normals is " + std::to_string(static_cast<int>(lighting.normals)) + "; its enumeration ends with 2"};
  for (int i = 0; i < lighting.light_count; ++i)
    if (const Refusal refusal = refusal_of(lighting.lights[static_cast<std::size_t>(i)]))
      return Error{"lights[" + std::to_string(i) + "]." + refusal->message};
  return {};
}

}  // namespace tuberia
