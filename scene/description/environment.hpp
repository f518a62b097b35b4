#pragma once
// What surrounds a scene at a distance that does not matter.                       [A 1.4] [B 4.1.3]

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

namespace tuberia::description {

/// A sky with a sun over a ground, radiances linear RGB.
struct Sky {
  glm::dvec3 sun_towards{0.3, 0.5, -0.8};         // the direction to it, not 0
  double sun_degrees = 2.3;                       // its diameter as it is seen, inside (0, 90); the real one's is 0.54
  glm::vec3 sun{160, 140, 105};
  glm::vec3 glow{1.1f, 0.85f, 0.55f};             // around the sun, falling off with the angle
  glm::vec3 zenith{0.1f, 0.22f, 0.55f}, horizon{0.62f, 0.72f, 0.85f}, ground{0.16f, 0.13f, 0.1f};
  double cloudiness = 0.45;                       // share of the sky under clouds, about, 0..1
  std::uint32_t seed = 1;                         // of the clouds
  bool operator==(const Sky&) const = default;
};

/// rendered: the scene's own objects, but for those that are not seen_in_environment, from one point.
struct Environment {
  enum class Source : std::uint8_t { sky, panorama, faces, rendered };
  enum class LookUp : std::uint8_t { cube, sphere, panorama };
  Source source = Source::sky;
  Sky sky;
  std::string file;                   // panorama: .hdr, .pfm or a file of 8-bit sRGB codes, relative to the scene's folder
  std::array<std::string, 6> faces;   // files of +x, -x, +y, -y, +z, -z, as raster/cube_map.hpp arranges them: seen from outside
  glm::dvec3 from{0};                 // rendered: the point, world space
  int resolution = 256;               // texels along an edge of the cube that is made
  LookUp look_up = LookUp::cube;      // the kind of map that is looked up; others are converted to it
  double rotation_degrees = 0;        // of the surroundings about the world's y axis, counter-clockwise from above
  bool shown = true;                  // behind the objects, too, not only in them
  bool operator==(const Environment&) const = default;
};

}  // namespace tuberia::description
