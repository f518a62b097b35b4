#pragma once
// A sky with a sun, made of formulas: surroundings for those who have no photographs.

#include <cstdint>
#include <glm/vec3.hpp>

#include "scene/environment/surroundings.hpp"

namespace tuberia {

/// World space, y up; radiances linear RGB, of the sun far above 1.
struct Sky {
  glm::dvec3 towards_sun{0.3, 0.5, -0.8};      // of any length but 0
  double sun_radius_radians = 0.02;             // of the disc; the real one's is 0.0047
  glm::dvec3 sun{160, 140, 105};
  glm::dvec3 glow{1.1, 0.85, 0.55};             // around the sun, falling off with the angle
  glm::dvec3 zenith{0.10, 0.22, 0.55};
  glm::dvec3 horizon{0.62, 0.72, 0.85};
  glm::dvec3 ground{0.16, 0.13, 0.10};
  double cloudiness = 0.45;                     // share of the sky under clouds, about; 0: none, 1: overcast
  std::uint32_t seed = 1;                       // of the clouds
};

/// The radiance from a unit direction. Not-a-number nowhere, whatever the direction.
glm::dvec3 sky_radiance(const Sky& sky, const glm::dvec3& direction) noexcept;

Surroundings sky_surroundings(const Sky& sky);

}  // namespace tuberia
