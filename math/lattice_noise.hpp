#pragma once
// Noise: smooth functions that look random and are the same on every machine, since they are made of
// the hashes of whole numbers. The wide forms are in pipeline/programs/noise-inl.hpp.        [Noise]

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace tuberia {

/// What the number of a lattice cell along each axis, and the seed, are multiplied with before they are
/// added (all modulo 2^32): odd, otherwise arbitrary.
inline constexpr std::array<std::uint32_t, 3> kLatticeFactors{0xd574532f, 0xd956936f, 0x45066ef5};
inline constexpr std::uint32_t kSeedFactor = 0x53aac6f7;

/// From this size on a coordinate counts as 0, as one does that is no number: cells of smaller ones have
/// numbers that floats hold exactly, with some digits left for the place within the cell.
inline constexpr float kLargestLatticeCoordinate = 4194304;

/// A number as random as its argument is not.                                                [Wellons]
constexpr std::uint32_t scrambled(std::uint32_t h) noexcept {
  h = (h ^ h >> 16) * 0x7feb352du;
  h = (h ^ h >> 15) * 0x846ca68bu;
  return h ^ h >> 16;
}

/// The hash of a lattice cell.
constexpr std::uint32_t lattice_hash(std::int32_t x, std::int32_t y, std::int32_t z, std::uint32_t seed) noexcept {
  return scrambled(static_cast<std::uint32_t>(x) * kLatticeFactors[0] + static_cast<std::uint32_t>(y) * kLatticeFactors[1] +
                   static_cast<std::uint32_t>(z) * kLatticeFactors[2] + seed * kSeedFactor);
}

double bounded_lattice_coordinate(double x) noexcept;

/// A function of the plane and its derivatives.
struct HeightAndSlope {
  double height = 0;
  glm::dvec2 slope{0};  // by u and by v
};

/// Gradient noise: 0 at the corners of the unit lattice, within [-1, 1], two derivatives continuous. The
/// gradients at the corners are the diagonals (+-1, +-1, +-1), by the upper three bits of the corner's hash.
double gradient_noise(const glm::dvec3& point, std::uint32_t seed) noexcept;

/// The same of the plane, with its derivatives; it repeats after `period` cells, a whole number, each way.
HeightAndSlope gradient_noise(const glm::dvec2& point, double period, std::uint32_t seed) noexcept;

/// The sum over four octaves i of |gradient_noise(2^i point)| / 2^i, with seed + i: in [0, 1.875].
double turbulence(const glm::dvec3& point, std::uint32_t seed) noexcept;

}  // namespace tuberia
