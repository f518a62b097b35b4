#pragma once
// Coverage of points and lines, in exact integers, one pixel at a time: docs/machine.md.

#include <vector>

#include "raster/fragment_block.hpp"

namespace tuberia {

/// Appends the blocks of one tile that a point or line covers, in memory order, with masks, weights
/// and depths. tile.samples says whether the rules of multisampling hold.
void cover_shape(const ScreenTriangle& record, const ScreenShape& shape, const StipplePattern& stipple, const Tile& tile,
                 const PixelRect& clip, std::vector<FragmentBlock>& out);

}  // namespace tuberia
