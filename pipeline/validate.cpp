#include "pipeline/validate.hpp"

#include <algorithm>

#include "pipeline/polygon_modes.hpp"
#include "pipeline/texture_coordinates.hpp"
#include "pipeline/validate_enumerations.hpp"
#include "pipeline/validate_geometry.hpp"
#include "pipeline/validate_mesh.hpp"
#include "pipeline/validate_output.hpp"

namespace tuberia {

Result<AcceptedDraw> validate(const DrawCall& draw, const RenderTarget& target, Workers& workers, Precision precision) {
  const PipelineState& state = draw.state;
  const Viewport viewport = state.viewport.viewport.value_or(Viewport{0, 0, target.width(), target.height()});
  const DepthRange& range = state.viewport.depth_range;
  if (auto refusal = check_enumerations(state)) return *std::move(refusal);
  if (auto refusal = check_mesh(draw.mesh, workers)) return *std::move(refusal);
  if (auto refusal = check_program(draw)) return *std::move(refusal);
  if (auto refusal = check_precision(draw.program.interface(), precision)) return *std::move(refusal);
  if (auto refusal = check_texture_coordinates(draw.mesh, state.transform, draw.program.interface().attributes())) return *std::move(refusal);
  if (auto refusal = check_viewport(viewport, range)) return *std::move(refusal);
  if (auto refusal = check_geometry(state)) return *std::move(refusal);
  if (auto refusal = output_refusal(state, target)) return *std::move(refusal);

  AcceptedDraw accepted;
  accepted.viewport = viewport;
  accepted.clip = intersection(target.bounds(), {viewport.x, viewport.y, viewport.x + viewport.width_pixels,
                                                 viewport.y + viewport.height_pixels});
  if (state.rasterization.scissor) accepted.clip = intersection(accepted.clip, *state.rasterization.scissor);
  accepted.output = {.depth = state.depth,
                     .blend = state.blend,
                     .depth_format = target.depth_format(),
                     .colour_format = target.colour_format(),
                     .min_depth = std::min(range.near_depth, range.far_depth),
                     .max_depth = std::max(range.near_depth, range.far_depth),
                     .clip = accepted.clip,
                     .stencil = state.stencil,
                     .alpha_test = state.alpha_test,
                     .fog = state.fog,
                     .multisampling = state.multisampling,
                     .stipple = state.rasterization.line.stipple.value_or(StipplePattern{})};
  accepted.output.samples = target.samples();
  if (shades(draw.program.interface(), accepted.output)) accepted.attributes = draw.program.interface().attributes();
  accepted.is_everyday = is_everyday(accepted.output) && makes_triangles(state.assembly.topology) && only_fills(state.rasterization);
  return accepted;
}

}  // namespace tuberia
