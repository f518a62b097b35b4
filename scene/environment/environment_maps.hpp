#pragma once
// Environment maps that programs can read, from images.

#include "base/result.hpp"
#include "pipeline/programs/environment_map.hpp"
#include "scene/environment/surroundings.hpp"

namespace tuberia {

// With mipmaps, filtered trilinearly; axes as the world's. Errors: an empty image, a texel that is not
// finite (its place is named), a size that textures cannot have; for the cube those of check_cube.
Result<EnvironmentMap> panorama_map(const Image<Rgba32F>& panorama);
Result<EnvironmentMap> cube_map(const CubeImages& faces);
Result<EnvironmentMap> sphere_map(const Image<Rgba32F>& ball);

}  // namespace tuberia
