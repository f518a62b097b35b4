#pragma once
// The surroundings of an object as pictures, looked up by a direction.                 [A 1.4] [B 4.1.3]

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <memory>

#include "raster/sampler.hpp"
#include "raster/texture.hpp"

namespace tuberia {

/// Radiance by direction, linear RGB. cube: a cube texture. sphere: one picture for all directions, as
/// seen in a small mirror ball by a distant eye on +z of its own axes; panorama: u is the azimuth, v the
/// polar angle, 2 pi by pi (equirectangular).
struct EnvironmentMap {
  enum class Kind : std::uint8_t { none, cube, sphere, panorama };
  Kind kind = Kind::none;
  std::shared_ptr<const Texture> texture;
  Sampler sampler;
  glm::mat3 map_from_world{1.0f};  // a rotation; for a sphere map, of the view that it was made for
};

}  // namespace tuberia
