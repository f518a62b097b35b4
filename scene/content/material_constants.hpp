#pragma once
// Materials in the terms of math: what their formulas take.

#include "math/patterns.hpp"
#include "math/reflection.hpp"
#include "scene/description/material.hpp"

namespace tuberia {

/// ka is kd where the material does not say it; lambert has no ks.
ReflectionConstants constants_of(const description::Material& material);

Pattern pattern_of(const description::Pattern& pattern);

}  // namespace tuberia
