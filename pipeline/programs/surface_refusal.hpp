#pragma once
// Why a surface cannot be drawn.

#include "pipeline/programs/surface.hpp"

namespace tuberia {

/// A sentence that names field and value, as in "lights[2].falloff_distance is -1; ...".
Refusal refusal_of(const SurfaceUniforms& uniforms);

}  // namespace tuberia
