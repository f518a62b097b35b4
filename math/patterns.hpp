#pragma once
// Colours that are computed instead of stored (procedural textures), as data and in double precision:
// what references and tests go by. The pipeline's form is pipeline/programs/pattern-inl.hpp.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace tuberia {

/// What a pattern is a function of. texcoord: the surface's own parameters [B 4.1.2]; solid: the point
/// in the pattern's space, as if the object were carved from it.
/// checker, random_squares [B Fig 21]: of the texture coordinates; wood, marble: solid. The trunk's axis is the pattern's y,
/// the marble's veins lie across its x.
struct Pattern {
  enum class Kind : std::uint8_t { none, checker, random_squares, wood, marble };
  Kind kind = Kind::none;
  glm::vec3 first{1}, second{0};   // its two colours, linear RGB; random_squares: the ends of each channel's range
  float scale = 8;                 // squares, rings or veins along one unit of its coordinates
  float turbulence = 0.5f;         // of wood and marble: how far noise moves the rings, in rings
  std::uint32_t seed = 1;          // of whatever is random in it
  glm::mat4 pattern_from_world{1.0f};  // solid patterns: where the block is that the object is carved from
  bool operator==(const Pattern&) const = default;
};

/// Whether a pattern is a function of the texture coordinates.
constexpr bool is_of_texture_coordinates(const Pattern& pattern) noexcept {
  return pattern.kind == Pattern::Kind::checker || pattern.kind == Pattern::Kind::random_squares;
}

/// Where a pattern is asked for, and how much of it the pixel covers.
struct PatternPlace {
  glm::dvec2 texcoord{0};
  glm::dvec3 world{0};
  glm::dvec2 texcoord_width{0};  // sides of the box in texture coordinates that is averaged over
  double band_width = 0;         // rings or veins across the pixel, turbulence left out
};

/// The pattern's colour, linear RGB; `none` is white. checker and random_squares are exact means over the box of
/// texcoord_width (the latter up to one square; wider boxes tend to the mean colour as the inverse of their area);
/// wood and marble fade to their mean colour between half a band and one and a half bands a pixel.
/// Coordinates that are not finite, or are 2^22 squares or bands and more from 0, count as 0.
glm::dvec3 pattern_colour(const Pattern& pattern, const PatternPlace& place) noexcept;

/// The share of the second colour, in [0, 1], at a point of the pattern's space, scale applied; and how far
/// along the bands it is without turbulence.
double wood_share(const glm::dvec3& point, double turbulence, std::uint32_t seed) noexcept;
double marble_share(const glm::dvec3& point, double turbulence, std::uint32_t seed) noexcept;

/// The means of both over a band.
inline constexpr double kMeanWoodShare = 0.5, kMeanMarbleShare = 0.375;

}  // namespace tuberia
