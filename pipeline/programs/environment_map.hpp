#pragma once
// The surroundings of an object as pictures, looked up by a direction.                 [A 1.4] [B 4.1.3]

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <memory>

#include "pipeline/fragment_program.hpp"
#include "raster/sampler.hpp"
#include "raster/texture.hpp"

namespace tuberia {

/// Radiance by direction, linear RGB. Where a direction stands in the texture, v down, directions in the
/// map's own axes, y up (the definitions in double: scene/environment/directions.hpp):
/// cube: raster/cube_map.hpp; without seams. sphere: a small mirror ball as a distant eye on +z sees it,
/// u = 1/2 + r.x / m, v = 1/2 - r.y / m, m = 2 |r + (0, 0, 1)| of the unit direction r. panorama
/// (equirectangular): u = 1/2 + atan2(x, -z) / 2 pi, v = acos(y) / pi, the zenith at the top.
struct EnvironmentMap {
  enum class Kind : std::uint8_t { none, cube, sphere, panorama };
  Kind kind = Kind::none;
  std::shared_ptr<const Texture> texture;  // codes or floats: a cube, or a rectangle for the other kinds
  // Its wraps are not read: panoramas repeat along u, and end at their poles. Cube maps choose their level of
  // detail as textures do; the others by the angle between neighbouring fragments' directions, so that
  // neither a panorama's seam and poles nor a ball's rim blur, and with one sample.
  Sampler sampler;
  glm::mat3 map_from_world{1.0f};  // a rotation; for a sphere map, of the view that it was made for
};

/// Why nothing can be looked up in this map: an unknown kind; a texture that is missing, of another kind, or of
/// depths; a matrix that is not finite; a sampler that is refused. Empty when it can, and for kind none.
Refusal refusal_of(const EnvironmentMap& map);

/// The radiance that the map has in the direction of the custom attribute's x, y, z, in world space, alpha 1;
/// black without a map. What is seen where nothing else is: scene/environment/background.hpp.
FragmentProgram environment_background(EnvironmentMap map);

}  // namespace tuberia
