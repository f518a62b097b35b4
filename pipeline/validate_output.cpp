#include "pipeline/validate_output.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "pipeline/refusal.hpp"

namespace tuberia {
namespace {

Refusal check_colour(const std::string& field, const Rgba32F& colour) {
  for (const auto& [channel, value] : {std::pair{".r", colour.r}, {".g", colour.g}, {".b", colour.b}, {".a", colour.a}})
    if (Refusal refusal = check_finite(field + channel, value)) return refusal;
  return {};
}

Refusal check_fog(const FogState& fog) {
  if (fog.mode == FogMode::off) return {};
  for (const auto& [channel, value] : {std::pair{".r", fog.colour.r}, {".g", fog.colour.g}, {".b", fog.colour.b}})
    if (Refusal refusal = check_finite(std::string("fog.colour") + channel, value)) return refusal;
  if (fog.mode == FogMode::linear) {
    if (Refusal refusal = check_finite("fog.start", fog.start)) return refusal;
    return check_finite("fog.end", fog.end);
  }
  if (!(fog.density >= 0) || !std::isfinite(fog.density))
    return Error{"fog.density is " + words_of(fog.density) + "; it must be finite and not negative"};
  return {};
}

Refusal check_alpha_test(const AlphaTest& test) {
  if (test.test == Compare::always || (test.reference >= 0 && test.reference <= 1)) return {};
  return Error{"alpha_test.reference is " + words_of(test.reference) + ", outside [0, 1]"};
}

/// Without the buffer nothing could be counted.
Refusal check_stencil(const StencilState& stencil, const RenderTarget& target) {
  if (!stencil.enabled || target.has_stencil()) return {};
  return Error{"stencil.enabled is true, but the target has no stencil buffer"};
}

/// Only centres have edge functions in other arithmetic.
Refusal check_edges(EdgeArithmetic edges, const RenderTarget& target) {
  if (edges == EdgeArithmetic::exact || target.samples() == 1) return {};
  return Error{"rasterization.edge_arithmetic is " + std::to_string(static_cast<int>(edges)) + ", which a target of " +
               std::to_string(target.samples()) + " samples a pixel does not allow; only exact (0) is possible there"};
}

Refusal check_blend(const BlendState& blend, ColourFormat format) {
  if (blend.logic != LogicOperation::off && format != ColourFormat::rgba8)
    return Error{"blend.logic is operation " + std::to_string(static_cast<int>(blend.logic)) +
                 ", but logic operations need a target of rgba8"};
  if (blend.mode != BlendMode::function) return {};
  return check_colour("blend.constant", blend.constant);
}

}  // namespace

std::optional<Error> output_refusal(const PipelineState& state, const RenderTarget& target) {
  if (Refusal refusal = check_fog(state.fog)) return refusal;
  if (Refusal refusal = check_alpha_test(state.alpha_test)) return refusal;
  if (Refusal refusal = check_stencil(state.stencil, target)) return refusal;
  if (Refusal refusal = check_edges(state.rasterization.edge_arithmetic, target)) return refusal;
  return check_blend(state.blend, target.colour_format());
}

}  // namespace tuberia
