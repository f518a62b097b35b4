#pragma once
// What a scene is lit by.                                                        [B 2.1, 2.5] [A 1.3]

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

namespace tuberia::description {

/// How the shadows of a light are found where that is done with a map of depths. Who traces rays needs
/// to know only that the light casts them.
struct Shadow {
  int resolution = 1024;      // texels each way
  double constant_bias = 0;   // in depths of the map, 0..1
  double slope_bias = 2;      // times the tangent of the light's angle to the normal, in texels of the map
  double normal_offset = 0;   // world units, times the sine of that angle
  int taps = 2;               // comparisons each way, whose mean is taken: 1, 2 or 3
  bool operator==(const Shadow&) const = default;
};

/// World space. area: a parallelogram around its position, as samples x samples points of equal parts
/// of its intensity.
struct Light {
  enum class Kind : std::uint8_t { directional, point, spot, area };
  enum class Falloff : std::uint8_t { none, linear, inverse_square };  // I; I / (d + d0); I / (4 pi d^2)
  Kind kind = Kind::directional;
  std::string name;
  glm::vec3 intensity{1};                       // Ip, linear RGB, 0 or more
  glm::dvec3 towards{0, 0, 1};                  // directional: the direction to the light, not 0
  glm::dvec3 position{0, 5, 0};                 // all others
  glm::dvec3 look_at{0};                        // spot: the point that its axis goes through; directional and point lights: where the projected picture's middle falls
  double cone_degrees = 30;                     // spot: from the axis to where its light ends, inside (0, 90)
  double full_cone_degrees = 25;                // spot: up to here it is undiminished, 0..cone_degrees
  glm::dvec3 edge_u{1, 0, 0}, edge_v{0, 0, 1};  // area: its sides
  int samples = 2;                              // area: points each way
  Falloff falloff = Falloff::none;              // of all but directional lights
  double falloff_distance = 1;                  // linear: d0, world units, > 0
  std::optional<Shadow> shadow;                 // unset: nothing stands in its way
  std::string projected_texture;                // a picture that it throws, as a slide projector does; "": none
  bool operator==(const Light&) const = default;
};

}  // namespace tuberia::description
