#pragma once
// In which order the tiles had better meet a draw's triangles.

#include "pipeline/draw_call.hpp"
#include "pipeline/validate.hpp"
#include "raster/tile_visibility.hpp"

namespace tuberia {

/// Last first where that cannot change the picture and promises more hidden surfaces: where later
/// triangles tend to be nearer, judged by a few vertices from all over the draw, or where the last
/// fragment of a pixel wins anyway. A bad guess costs time, never a bit.
DrawOrder choose_draw_order(const DrawCall& draw, const AcceptedDraw& accepted);

}  // namespace tuberia
