#pragma once
// What surrounds a scene at a distance that does not matter.                       [A 1.4] [B 4.1.3]

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>

namespace tuberia::description {

/// A clear sky with a sun over a ground, linear RGB.
struct Sky {
  glm::vec3 zenith{0.15f, 0.35f, 0.8f}, horizon{0.7f, 0.8f, 0.95f}, ground{0.25f, 0.22f, 0.18f};
  glm::dvec3 sun_towards{1, 1, 0.5};      // the direction to it, not 0
  double sun_degrees = 4;                 // its diameter, inside (0, 90)
  glm::vec3 sun{20};                      // its radiance
  bool operator==(const Sky&) const = default;
};

/// rendered: the scene's own objects, but for those that are not seen_in_environment, from one point.
struct Environment {
  enum class Source : std::uint8_t { sky, panorama, faces, rendered };
  enum class LookUp : std::uint8_t { cube, sphere, panorama };
  Source source = Source::sky;
  Sky sky;
  std::string file;                   // panorama: .hdr, .pfm or a file of 8-bit sRGB codes, relative to the scene's folder
  std::array<std::string, 6> faces;   // files of +x, -x, +y, -y, +z, -z, as seen from within, see raster/cube_map.hpp
  glm::dvec3 from{0};                 // rendered: the point, world space
  int resolution = 256;               // texels along an edge of the cube that is made
  LookUp look_up = LookUp::cube;      // the kind of map that is looked up; others are converted to it
  double rotation_degrees = 0;        // of the surroundings about the world's y axis, counter-clockwise from above
  bool shown = true;                  // behind the objects, too, not only in them
  bool operator==(const Environment&) const = default;
};

}  // namespace tuberia::description
