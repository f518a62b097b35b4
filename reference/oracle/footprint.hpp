#pragma once
// What a pixel covers of a texture.

#include "reference/oracle/texture.hpp"

namespace tuberia::oracle {

struct Footprint {
  Interval level_of_detail;           // bias and bounds not yet in it
  Interval taps = 1.0;                // how many samples; rounded up
  Interval along_x = 0.0, along_y = 0.0;  // the longer axis, in steps to the next pixels, of length 1; either way round
};

/// For steps in texels of level 0: of a pixel whose longer step (or axis) decides, of one whose longer and
/// shorter step do, and of an ellipse.
Footprint round_footprint(const Steps& texels, FootprintForm form = FootprintForm::usual);
Footprint stepped_footprint(const Steps& texels, float max_anisotropy);
Footprint elliptic_footprint(const Steps& texels, float max_anisotropy);

}  // namespace tuberia::oracle
