#include "raster/shape_coverage.hpp"

namespace tuberia {

void cover_shape(const ScreenTriangle&, const ScreenShape&, const StipplePattern&, const Tile&, const PixelRect&,
                 std::vector<FragmentBlock>&) {}

}  // namespace tuberia
