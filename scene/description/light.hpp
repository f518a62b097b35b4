#pragma once
// What a scene is lit by.                                                        [B 2.1, 2.5] [A 1.3]

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

namespace tuberia::description {

/// How the shadows of a light are found where that is done with a map of depths, see docs/shadows.md. Who
/// traces rays needs to know only that the light casts them.
struct Shadow {
  int resolution = 1024;      // texels each way
  double constant_bias = 0;   // world units towards the light, 0 or more
  double slope_bias = 1;      // towards the light, and
  double normal_offset = 0;   // along the normal, in heights that clear the depths of a texel, 0 or more
  int taps = 2;               // texels each way that are compared, whose mean is taken: 1..8
  bool operator==(const Shadow&) const = default;
};

/// A picture that a light throws, as a slide projector does. Its middle falls on the light's look_at.
struct Projection {
  std::string texture;
  glm::dvec3 up{0, 1, 0};     // the picture's, world space; not along the light's axis
  double fovy_degrees = 40;   // point, spot: its vertical opening, inside (0, 180)
  double height = 4;          // directional: world units, > 0
  bool operator==(const Projection&) const = default;
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
  glm::dvec3 look_at{0};                        // all but area: the point that a spot's axis, or a projection's, goes through
  double cone_degrees = 30;                     // spot: from the axis to where its light ends, inside (0, 90)
  double full_cone_degrees = 25;                // spot: up to here it is undiminished, 0..cone_degrees
  glm::dvec3 edge_u{1, 0, 0}, edge_v{0, 0, 1};  // area: its sides
  int samples = 2;                              // area: points each way
  Falloff falloff = Falloff::none;              // of all but directional lights
  double falloff_distance = 1;                  // linear: d0, world units, > 0
  std::optional<Shadow> shadow;                 // unset: nothing stands in its way
  std::optional<Projection> projection;         // of all but area lights; unset: the same colour everywhere
  bool operator==(const Light&) const = default;
};

}  // namespace tuberia::description
