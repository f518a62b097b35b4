#pragma once
// What is known of a fragment program's colours without running it.

#include "pipeline/draw_call.hpp"
#include "pipeline/programs/fixed_function.hpp"
#include "pipeline/programs/programs.hpp"
#include "raster/render_target.hpp"

namespace tuberia {

/// The programs of the library, and all others.
enum class ProgramKind : std::uint8_t { flat, gouraud, phong, textured, textured_gouraud, textured_lit, fixed_function, other };

ProgramKind kind_of(const FragmentProgram& program);

/// Whether every colour of the mesh's vertices, lit or not, on both sides, has an alpha of exactly 1.
bool has_opaque_vertices(const DrawCall& draw);
/// Whether all fragments of a triangle, and all triangles, get one and the same vertex colour.
bool has_one_vertex_colour(const DrawCall& draw);
/// Whether the program's alpha is exactly 1 at every fragment of a target with so many samples: with several,
/// what is interpolated at a centre beside the triangle may be anything.
bool is_opaque(const DrawCall& draw, int samples);

/// Why the program drops no fragment although it could ("its textures have no holes"); null if it may.
const char* reason_to_drop_nothing(const DrawCall& draw);

/// How many texture units of a fixed-function program are on and change what came before them.
/// Takes those that do not out of the program.
struct UnitsInUse {
  int on = 0, in_use = 0;
};
UnitsInUse remove_idle_units(FragmentProgram& program);

/// The same program without the test that drops nothing.
FragmentProgram without_cut_out(const FragmentProgram& program);

/// Colours of 8 bits are clamped to [0, 1] before they are blended or stored.
constexpr bool has_codes(ColourFormat format) noexcept { return format == ColourFormat::rgba8 || format == ColourFormat::srgb8; }

}  // namespace tuberia
