#pragma once
// What stage 0 says of numbers that nothing can be drawn with. The sentences name field and value.

#include <glm/vec3.hpp>
#include <string>

#include "pipeline/fragment_program.hpp"
#include "pipeline/lighting.hpp"

namespace tuberia {

/// As short as it can be said: "0.5", "1e+30", "nan".
std::string words_of(float value);

Refusal check_finite(const std::string& field, float value);
Refusal check_finite(const std::string& field, const glm::vec3& value);

/// Not-a-number is out of every range.
Refusal check_range(const std::string& field, float value, float low, float high);

/// Why this light cannot be computed with: an unknown kind or falloff, a number that is not finite, a
/// negative d0, or a spot whose cosines are not those of an inner angle within an outer one.
Refusal refusal_of(const Light& light);

/// Why this lighting cannot: its number of lights, one of them, a number that is not finite, or a negative shininess.
Refusal refusal_of(const Lighting& lighting);

}  // namespace tuberia
