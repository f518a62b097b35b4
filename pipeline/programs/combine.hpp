#pragma once
// Why texture units cannot be combined.

#include "pipeline/programs/fixed_function.hpp"

namespace tuberia {

/// A sentence that names unit, field and value, or null. It stays as it is until the next refusal on
/// the same thread.
const char* refusal_of(const FixedFunctionUniforms& uniforms);

}  // namespace tuberia
