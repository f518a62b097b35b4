#pragma once
// Stage 0's part for what comes after the fragment program: state that no target, or not this one,
// can be drawn with.

#include <optional>

#include "base/result.hpp"
#include "pipeline/state.hpp"
#include "raster/render_target.hpp"

namespace tuberia {

/// The first refusal of fog, alpha test, stencil and blend state, naming field and value.
std::optional<Error> output_refusal(const PipelineState& state, const RenderTarget& target);

}  // namespace tuberia
