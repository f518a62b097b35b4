#pragma once
// Numbers as colours.

#include <string>

#include "image/image.hpp"

namespace tuberia::cli {

/// From dark to light through blue, violet, red and yellow; t in [0, 1]. sRGB codes.
Rgba8 heat_colour(float t) noexcept;

/// The smallest and largest of the values above `nothing`; both 0 if there are none.
struct ValueRange {
  float low = 0, high = 0, mean = 0;
  std::int64_t count = 0;
};
ValueRange range_of(const Image<float>& values, float nothing = 0);

/// low dark, high light; values up to `nothing` get a dark green that the scale does not have.
/// logarithmic: equal factors look equally far apart.
Image<Rgba8> heat_image(const Image<float>& values, const ValueRange& range, bool logarithmic = false, float nothing = 0);

/// "1 (dark) to 7 (light) fragments, 2.13 in the mean of 71,204 pixels".
std::string legend_of(const ValueRange& range, const std::string& unit, bool logarithmic = false);

}  // namespace tuberia::cli
