#pragma once
// What surfaces do with light, and the pictures that tell it.                       [B 2, 4] [A 1.2, 1.4]

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/description/transform.hpp"

namespace tuberia::description {

/// A picture that materials, lights and height fields name.
struct Texture {
  enum class Source : std::uint8_t { file, checker, random_squares, gradient, planet, planet_heights, bricks, brick_heights, stud_heights };
  enum class Encoding : std::uint8_t { srgb, linear };
  enum class Filter : std::uint8_t { nearest, bilinear, mipmap_nearest, trilinear };
  enum class Wrap : std::uint8_t { repeat, clamp, mirror };
  enum class LevelRule : std::uint8_t { derivatives, distance };
  std::string name;
  Source source = Source::file;
  std::string file;                       // relative to the scene's folder
  Encoding encoding = Encoding::srgb;     // of a file's 8-bit codes
  int size = 256;                         // texels each way of a picture that is made; planets are twice as wide
  int squares = 8;                        // or bricks (an even number), or studs: how many, each way
  glm::vec3 first{1}, second{0};          // of checker, random_squares and gradient, linear RGB in [0, 1]; random_squares: the ends of each channel's range
  std::uint32_t seed = 1;                 // of random_squares, planets and bricks
  bool level_colours = false;             // each mipmap level in a colour of its own, which shows which one is read
  Filter filter = Filter::trilinear;
  double anisotropy = 1;                  // 1..16
  LevelRule level_rule = LevelRule::derivatives;  // which mipmap level: by a pixel's size on the texture, or log2(d / texel_distance) [A 1.1]
  double texel_distance = 1;              // distance: where a texel is as large as a pixel, world units, > 0
  Wrap wrap = Wrap::repeat;
  bool operator==(const Texture&) const = default;
};

/// A colour that is computed. checker, random_squares: of the texture coordinates; wood, marble: of the
/// point in space, as if the object were carved from a block.
struct Pattern {
  enum class Kind : std::uint8_t { checker, random_squares, wood, marble };
  Kind kind = Kind::checker;
  glm::vec3 first{1}, second{0};          // linear RGB; random_squares: the ends of each channel's range
  double scale = 8;                       // squares, rings or veins along one unit, > 0
  double turbulence = 0.5;                // wood and marble: how far noise moves the rings, in rings
  std::uint32_t seed = 1;
  std::vector<Transform> placement;       // of the block in the world: wood and marble
  bool operator==(const Pattern&) const = default;
};

/// Where the texture coordinates of a surface come from: itself, or the direction of its normal
/// [B 4-2..4-5], whose pole is the upper edge of the picture.
struct Mapping {
  enum class Kind : std::uint8_t { surface, sphere };
  Kind kind = Kind::surface;
  glm::dvec3 pole{0, 1, 0}, equator{1, 0, 0};  // sphere: perpendicular directions of object space, not 0
  bool of_positions = false;                   // sphere: the direction from the origin instead, for what is not round
  glm::dvec2 repeat{1, 1};                     // not 0; texture coordinates are multiplied with it
  bool operator==(const Mapping&) const = default;
};

/// Relief that only normals know of, a function of the texture coordinates.
struct Bump {
  enum class Kind : std::uint8_t { height_texture, normal_map, waves, orange, rough };
  Kind kind = Kind::waves;
  std::string texture;     // height_texture: its red is the height; normal_map: codes 0..255 for -1..1
  double gain = 1;         // > 1 exaggerates, < 1 flattens, < 0 inverts; heights in world units are gain times the function
  double scale = 8;        // waves, orange, rough: waves or dimples along one unit of u and v, > 0
  std::uint32_t seed = 1;  // orange, rough
  bool operator==(const Bump&) const = default;
};

/// How light is reflected. Formulas: math/reflection.hpp.
enum class Reflection : std::uint8_t { lambert, phong, blinn_phong, weighted_phong, cook_torrance };

/// How many facets of a rough surface are tilted by an angle.
enum class Facets : std::uint8_t { beckmann, gaussian };

/// Constants are linear RGB.
struct Material {
  std::string name;
  Reflection model = Reflection::phong;
  std::optional<glm::vec3> ambient;   // ka; unset: as diffuse
  glm::vec3 diffuse{0.8f};            // kd, times the pattern or texture
  glm::vec3 specular{0};              // ks; cook_torrance: what its D G F is multiplied with
  double exponent = 32;               // n of phong, blinn_phong and weighted_phong, >= 0
  double roughness = 0.3;             // m of cook_torrance, 1e-3..1e3
  glm::vec3 refractive_index{1.5f};   // of weighted_phong and cook_torrance, 1e-3..1e3; its mean bends rays that go through
  Facets facets = Facets::beckmann;   // of cook_torrance
  bool divided_by_pi = true;          // cook_torrance as the notes print it; false: the later 4 [FIX 12]
  std::string texture;                // of kd; "": none
  std::optional<Pattern> pattern;     // of kd, where there is no texture
  Mapping mapping;
  std::optional<Bump> bump;
  glm::vec3 mirror{0};                // kps: times the environment in the mirror direction; of traced rays, times what they meet there
  glm::vec3 transmission{0};          // kt: times the light from the refracted direction           [B 5-2]
  double shadow_density = 0;          // where kt > 0: light that goes straight through is multiplied by exp(-density * world units inside)
  double alpha = 1;                   // opacity
  bool two_sided = false;             // the side that faces the eye is lit
  bool operator==(const Material&) const = default;
};

}  // namespace tuberia::description
