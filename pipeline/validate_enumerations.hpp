#pragma once
// Stage 0, for what arrives as numbers from files and other languages: values that their enumerations
// do not have.

#include "pipeline/refusal.hpp"
#include "pipeline/state.hpp"

namespace tuberia {

/// Every enumeration of the state holds one of its own values.
Refusal check_enumerations(const PipelineState& state);

}  // namespace tuberia
