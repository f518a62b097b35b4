#pragma once
// Colours that are computed instead of stored: procedural textures.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace tuberia {

/// What a pattern is a function of. texcoord: the surface's own parameters [B 4.1.2]; solid: the point
/// in the pattern's space, as if the object were carved from it.
/// checker, random_squares: of the texture coordinates; wood, marble: solid.
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

}  // namespace tuberia
