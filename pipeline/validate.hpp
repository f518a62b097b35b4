#pragma once
// Stage 0: the only place that refuses a draw; after it nothing fails.

#include "base/parallel_for.hpp"
#include "base/result.hpp"
#include "pipeline/draw_call.hpp"
#include "raster/render_target.hpp"

namespace tuberia {

/// A draw call that was accepted, with what every stage derives from its state.
struct AcceptedDraw {
  Viewport viewport;
  PixelRect clip;            // target, viewport and scissor
  OutputState output;
  bool is_everyday = true;   // the fused tile loops can draw it
  Attributes attributes = Attributes::none;  // of the vertices, that some fragment's colour is made from
};

/// Error naming the culprit: an index beyond the vertices, attribute arrays of the wrong length, a
/// program without its attributes, a viewport or depth range out of bounds, bad lighting; sizes, widths
/// and offsets out of range, numbers that are not finite, fog without an extent.
/// Or a precision that the program has no kernels for.
Result<AcceptedDraw> validate(const DrawCall& draw, const RenderTarget& target, Workers& workers, Precision precision = Precision::exact);

}  // namespace tuberia
