#pragma once
// Random triangles made to hurt, by class.

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "raster/tile.hpp"
#include "raster/instruction_set.hpp"
#include "reference/rational/screen.hpp"

namespace tuberia::witness {

enum class Class : std::uint8_t {
  slivers,       // some 1/256 pixel thin, up to the length of the guard band
  shared_edges,  // two triangles with a common edge, in one draw
  lattice,       // vertices on pixel centres, on edges between pixels, half way between two snapped places
  small,         // about a pixel large
  guard_band,    // vertices within two pixels of the guard band's end, on either side, or on it
  far,           // coordinates of 1e5 to 1e30
  w_ratios,      // w of one triangle from 1e-4 to 1e3
  near_zero_w,   // w of 1e-30, of 0, just below 0
  behind,        // some vertices behind the eye
  planes,        // vertices exactly on planes of the view volume
  cut,           // across several planes
  denormals,     // coordinates that are denormal floats, or nearly
  powers_of_two, // ordinary triangles times 2^-60 to 2^60
  bit_patterns,  // any finite floats
};
inline constexpr int kClasses = 14;

std::string_view name_of(Class) noexcept;
std::optional<Class> class_named(std::string_view) noexcept;

/// One draw: triangles (three vertices each) on a small target.
struct Case {
  rational::View view;
  int width = 1, height = 1;  // pixels
  DepthFormat format = DepthFormat::d24;
  // Counting draws add up what covers a pixel and keep the last depth; others, with the default state,
  // keep the nearest.
  bool is_counting = false;
  InstructionSet instruction_set = InstructionSet::baseline;
  std::vector<rational::ClipVertex> vertices;

  std::size_t triangle_count() const { return vertices.size() / 3; }
  rational::Triangle triangle(std::size_t i) const { return {vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]}; }
};

/// Case number `number` of a class; the same on every machine but for the instruction set: the widest
/// in seven cases of eight, any other in the rest.
Case random_case(Class, std::uint64_t seed, std::uint64_t number);

}  // namespace tuberia::witness
