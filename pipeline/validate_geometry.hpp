#pragma once
// Stage 0, for the state of the geometry stages.

#include "pipeline/validate_mesh.hpp"

namespace tuberia {

/// Matrices, planes, sizes, widths and offsets within their ranges, and finite.
Refusal check_geometry(const PipelineState& state);

/// The viewport that the draw has in the end, and its depth range.
Refusal check_viewport(const Viewport& viewport, const DepthRange& range);

}  // namespace tuberia
