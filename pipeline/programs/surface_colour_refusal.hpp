#pragma once
// What patterns, relief and texture access cannot be drawn with.

#include "pipeline/fragment_program.hpp"
#include "pipeline/programs/bump_map.hpp"
#include "pipeline/programs/pattern.hpp"
#include "pipeline/programs/texture_access.hpp"

namespace tuberia {

/// An unknown kind, or a colour, scale, turbulence or matrix that is not finite.
Refusal refusal_of(const Pattern& pattern);
/// An unknown rule, a matrix that is not finite, or a texel_distance outside 1e-30 to 1e30.
Refusal refusal_of(const TextureAccess& access);
/// An unknown kind; a gain or scale that is not finite; where a picture is read, one that is missing, not
/// two-dimensional, of depths, or of sRGB codes, which are no heights or normals, or a sampler that makes no sense.
Refusal refusal_of(const BumpMap& bump);

}  // namespace tuberia
