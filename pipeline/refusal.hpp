#pragma once
// What stage 0 says of numbers that nothing can be drawn with. The sentences name field and value.

#include <optional>
#include <string>

#include "base/result.hpp"
#include "pipeline/state.hpp"

namespace tuberia {

using Refusal = std::optional<Error>;  // empty: nothing is wrong

/// As short as it can be said: "0.5", "1e+30", "nan".
std::string words_of(float value);

Refusal check_finite(const std::string& field, float value);

/// Not-a-number is out of every range.
Refusal check_range(const std::string& field, float value, float low, float high);

/// Why this lighting cannot be computed: its number of lights, or a number that is not finite, or a
/// negative shininess. Null when it can; the text lasts until the next one on this thread.
const char* refusal_of(const Lighting& lighting);

}  // namespace tuberia
