#pragma once
// The texture units of the fixed-function fragment.

#include "reference/oracle/state.hpp"

namespace tuberia::oracle {

/// The colour that a unit hands on.
Colour combined(const TextureUnit&, const Colour& texel, const Colour& primary, const Colour& previous);

}  // namespace tuberia::oracle
