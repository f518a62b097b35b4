#pragma once
// The vertex attributes that a fragment program may ask for, and how they lie in memory.

#include <array>
#include <bit>
#include <cstdint>

namespace tuberia {

/// A set of attributes; combine with |. Each is a vector of floats interpolated over the triangle.
enum class Attributes : std::uint32_t {
  none = 0,
  position = 1,   // world space, 3 scalars
  normal = 2,     // world space, 3 scalars, unit length at the vertices
  texcoord = 4,   // 2 scalars; (0,0) is the upper left corner of the texture
  colour = 8,     // linear RGBA, 4 scalars
  custom = 16,    // 4 scalars of the application's own
  unit0 = 32, unit1 = 64, unit2 = 128, unit3 = 256,  // (s, t, r, q) of a texture unit, 4 scalars each
  tangent = 512, bitangent = 1024,  // dp/du and dp/dv of the texture coordinates, world space, not unit, 3 scalars each
};
inline constexpr Attributes kLastAttribute = Attributes::bitangent;

inline constexpr int kTextureUnits = 4;
inline constexpr std::array<int, 11> kAttributeScalars{3, 3, 2, 4, 4, 4, 4, 4, 4, 3, 3};
inline constexpr int kMaxAttributeScalars = 38;

constexpr Attributes operator|(Attributes a, Attributes b) noexcept {
  return static_cast<Attributes>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr Attributes operator&(Attributes a, Attributes b) noexcept {
  return static_cast<Attributes>(static_cast<std::uint32_t>(a) & static_cast<std::uint32_t>(b));
}
constexpr bool contains(Attributes set, Attributes one) noexcept { return (set & one) == one; }

/// How many scalars a vertex of this set has; 0..kMaxAttributeScalars.
constexpr int scalar_count(Attributes set) noexcept {
  int count = 0;
  for (std::size_t i = 0; i < kAttributeScalars.size(); ++i)
    if ((static_cast<std::uint32_t>(set) >> i & 1u) != 0) count += kAttributeScalars[i];
  return count;
}

/// Where `one` begins among the scalars of `set`: attributes lie in the order of their bits.
constexpr int scalar_offset(Attributes set, Attributes one) noexcept {
  return scalar_count(set & static_cast<Attributes>(static_cast<std::uint32_t>(one) - 1));
}

/// Floats from one vertex to the next: the scalars, padded to whole groups of four.
constexpr int vertex_stride(Attributes set) noexcept { return (scalar_count(set) + 3) / 4 * 4; }

}  // namespace tuberia
