#pragma once
// Lights, and the local model's constants, as plain data.

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

namespace tuberia {

/// What a light loses on its way over the distance d.                             [B 2-5, 2.6]
/// none: nothing; linear: its intensity is Ip / (d + d0); inverse_square: Ip / (4 pi d^2). Nearer than
/// kLeastFalloffDistance a light is as bright as there, and exactly at it the surface has no side that
/// it could shine on: both cosines are 0. So every result is finite.
enum class Falloff : std::uint8_t { none, linear, inverse_square };
inline constexpr float kLeastFalloffDistance = 1e-6f;  // world units; for linear, of d + d0

/// A light of the local model [B 2.1]. World space. A spot is a point that shines around an axis: fully
/// within the inner angle, not at all outside the outer one, and smoothly (3 t^2 - 2 t^3) in between.
struct Light {
  enum class Kind : std::uint8_t { directional, point, spot };
  Kind kind = Kind::directional;
  glm::vec3 towards{0, 0, 1};        // directional: unit vector to the light; else its position
  glm::vec3 intensity{1};            // Ip, linear RGB
  Falloff falloff = Falloff::none;   // of points and spots; what is infinitely far away has none
  float falloff_distance = 1;        // d0, >= 0, world units
  glm::vec3 axis{0, 0, -1};          // of a spot: unit vector that it shines along
  float cos_inner = 0.95f, cos_outer = 0.9f;  // of a spot: -1 <= outer <= inner <= 1; equal: a sharp edge
  bool operator==(const Light&) const = default;
};

/// What a program that lights fragments does with the interpolated normal, which is shorter than 1:
/// makes it unit; takes one step of Newton's method towards that, n (3 - n.n) / 2; or leaves it.
enum class NormalInterpolation : std::uint8_t { renormalized, one_step, not_renormalized };

/// The local model's constants [B 2-4, 2-7]: I = ambient + sum over the lights of
/// Ip * (diffuse (N.L) + specular (R.V)^shininess), or (N.H) instead of (R.V).
struct Lighting {
  static constexpr int kMaxLights = 4;
  glm::vec3 ambient{0.1f};           // ka * Ia, linear RGB
  glm::vec3 diffuse{0.8f};           // kd
  glm::vec3 specular{0};             // ks
  float shininess = 32;              // n, >= 0
  float alpha = 1;                   // of the result
  bool halfway = true;               // Blinn's N.H; false: Phong's R.V
  bool two_sided = false;            // light the side that faces the eye
  glm::vec3 eye{0, 0, 1};            // world space
  std::array<Light, kMaxLights> lights{};
  int light_count = 1;               // 0..kMaxLights
  NormalInterpolation normals = NormalInterpolation::renormalized;  // at fragments
  bool operator==(const Lighting&) const = default;
};

}  // namespace tuberia
