#pragma once
// What a pixel covers of a texture.

#include "reference/oracle/texture.hpp"

namespace tuberia::oracle {

/// The level of detail, bias and bounds not yet in it, for steps in texels of level 0.
Interval level_of_detail(const Steps& texels);

}  // namespace tuberia::oracle
