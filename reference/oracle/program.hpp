#pragma once
// The fragment programs.

#include "reference/oracle/fragments.hpp"

namespace tuberia::oracle {

/// The colour of the fragment at pixel (x, y), before it may be dropped and before the fog.
Colour program_colour(const Shape&, const FragmentWeights&, const Draw&, int x, int y);

}  // namespace tuberia::oracle
