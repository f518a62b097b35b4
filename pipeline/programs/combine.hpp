#pragma once
// Why texture units cannot be combined.

#include "pipeline/programs/fixed_function.hpp"

namespace tuberia {

/// A sentence that names unit, field and value.
Refusal refusal_of(const FixedFunctionUniforms& uniforms);

}  // namespace tuberia
