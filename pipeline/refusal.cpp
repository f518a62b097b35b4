#include "pipeline/refusal.hpp"

#include <cmath>
#include <sstream>

namespace tuberia {
namespace {

Refusal check_vector(const std::string& field, const glm::vec3& v) {
  if (Refusal refusal = check_finite(field + ".x", v.x)) return refusal;
  if (Refusal refusal = check_finite(field + ".y", v.y)) return refusal;
  return check_finite(field + ".z", v.z);
}

Refusal check_lighting(const Lighting& lighting) {
  if (lighting.light_count < 0 || lighting.light_count > Lighting::kMaxLights)
    return Error{"its number of lights is " + std::to_string(lighting.light_count) + ", outside 0 to " + std::to_string(Lighting::kMaxLights)};
  if (Refusal refusal = check_vector("ambient", lighting.ambient)) return refusal;
  if (Refusal refusal = check_vector("diffuse", lighting.diffuse)) return refusal;
  if (Refusal refusal = check_vector("specular", lighting.specular)) return refusal;
  if (Refusal refusal = check_vector("eye", lighting.eye)) return refusal;
  if (Refusal refusal = check_finite("alpha", lighting.alpha)) return refusal;
  if (!(lighting.shininess >= 0) || !std::isfinite(lighting.shininess))
    return Error{"shininess is " + words_of(lighting.shininess) + "; it must be finite and not negative"};
  if (lighting.normals > NormalInterpolation::not_renormalized)
    return Error{"normals is " + std::to_string(static_cast<int>(lighting.normals)) + "; its enumeration ends with 2"};
  for (int i = 0; i < lighting.light_count; ++i) {
    const Light& light = lighting.lights[static_cast<std::size_t>(i)];
    const std::string name = "lights[" + std::to_string(i) + "]";
    if (Refusal refusal = check_vector(name + ".towards", light.towards)) return refusal;
    if (Refusal refusal = check_vector(name + ".intensity", light.intensity)) return refusal;
  }
  return {};
}

}  // namespace

std::string words_of(float value) {
  std::ostringstream words;
  words << value;
  return words.str();
}

Refusal check_finite(const std::string& field, float value) {
  if (std::isfinite(value)) return {};
  return Error{field + " is " + words_of(value) + "; it must be finite"};
}

Refusal check_range(const std::string& field, float value, float low, float high) {
  if (value >= low && value <= high) return {};
  return Error{field + " is " + words_of(value) + ", outside " + words_of(low) + " to " + words_of(high)};
}

const char* refusal_of(const Lighting& lighting) {
  static thread_local std::string text;
  const Refusal refusal = check_lighting(lighting);
  if (!refusal) return nullptr;
  text = refusal->message;
  return text.c_str();
}

}  // namespace tuberia
