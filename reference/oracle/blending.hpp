#pragma once
// How a fragment's colour and a sample's make the new one.

#include <array>

#include "reference/oracle/state.hpp"
#include "reference/oracle/target.hpp"

namespace tuberia::oracle {

/// Blends into what the sample stores, by mode, function or logic operation, under the mask.
void blend(Sample& sample, const Colour& fragment, const Blend&, ColourFormat);

}  // namespace tuberia::oracle
