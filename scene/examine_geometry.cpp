// What happens between the vertices and the fragments.

#include <algorithm>
#include <string>

#include "math/transforms.hpp"
#include "pipeline/polygon_modes.hpp"
#include "scene/examination.hpp"
#include "scene/program_facts.hpp"

namespace tuberia {
namespace {

std::string count_of(int count, const char* things) { return std::to_string(count) + " " + things; }

/// Texture units that change nothing, colours that are one colour.
void simplify_program(Examination& e, UnitsInUse& units) {
  FragmentProgram& program = e.smallest.program;
  units = remove_idle_units(program);
  // The fixed-function fragment clamps its colour, which storing codes does as well; but fog comes before that.
  if (program.interface().name == "fixed_function_0" && has_codes(e.target.colour) && !e.found.needs(Feature::fog)) program = gouraud();
  const bool one_colour = e.smallest.state.rasterization.flat_shading || (has_one_vertex_colour(e.smallest) && e.target.samples == 1);
  if (kind_of(program) == ProgramKind::gouraud && one_colour) program = flat();
}

bool has_equal_w(const Examination& e) {
  const MeshView& mesh = e.smallest.mesh;
  if (!mesh.screen_positions.empty())
    return std::all_of(mesh.screen_positions.begin(), mesh.screen_positions.end(), [&](const ScreenVertex& v) { return v.w == mesh.screen_positions[0].w; });
  if (!mesh.clip_positions.empty())
    return std::all_of(mesh.clip_positions.begin(), mesh.clip_positions.end(), [&](const glm::vec4& p) { return p.w == mesh.clip_positions[0].w; });
  const glm::mat4 clip_from_object = compose(e.smallest.state.transform.clip_from_world, e.smallest.state.transform.world_from_object);
  return clip_from_object[0].w == 0 && clip_from_object[1].w == 0 && clip_from_object[2].w == 0;
}

void examine_interpolation(Examination& e) {
  const bool was_on = e.smallest.program.interface().interpolated != Attributes::none;
  UnitsInUse units;
  simplify_program(e, units);
  const ProgramInterface& program = e.smallest.program.interface();
  if (program.interpolated == Attributes::none) e.smallest.state.rasterization.flat_shading = false;
  const bool varies = program.interpolated != Attributes::none && !e.smallest.state.rasterization.flat_shading;
  e.say(Feature::interpolation, varies, was_on || varies,
        varies                            ? "The program reads " + words_of(program.interpolated) + " at every fragment."
        : !e.found.needs(Feature::shading) ? "No colour is made."
                                          : "Each triangle has one colour.");
  const bool equal_w = has_equal_w(e);
  e.say(Feature::perspective, varies && !equal_w, varies,
        !varies ? "Nothing is interpolated but depth, which is linear on the screen."
        : equal_w ? "All vertices have the same w: nothing is divided."
                  : "w differs between vertices.");
  const ProgramKind kind = kind_of(e.smallest.program);
  const bool reads_one = kind == ProgramKind::textured || kind == ProgramKind::textured_gouraud || kind == ProgramKind::textured_lit;
  e.say(Feature::textures, reads_one || units.in_use > 0, reads_one || units.on > 0,
        reads_one          ? "The program reads a texture."
        : units.in_use > 0 ? count_of(units.in_use, "of ") + count_of(units.on, "texture units change the colour.")
        : units.on > 0     ? "The texture units pass on the colour that they get."
        : kind == ProgramKind::other ? "It is not known what the program reads."
                                     : "The program reads none.");
}

void examine_culling(Examination& e) {
  const bool culls = e.smallest.state.culling.cull != CullFace::none && makes_triangles(e.smallest.state.assembly.topology);
  e.say(Feature::culling, culls, e.smallest.state.culling.cull != CullFace::none,
        culls ? std::string(e.smallest.state.culling.cull == CullFace::back ? "Back" : "Front") + " faces are left out."
              : "Both faces are drawn.");
}

void examine_polygon_modes(Examination& e) {
  RasterizationState& raster = e.smallest.state.rasterization;
  const bool triangles = makes_triangles(e.smallest.state.assembly.topology), was_on = !only_fills(raster);
  const CullFace cull = e.smallest.state.culling.cull;
  if (!triangles || cull == CullFace::front) raster.front_mode = PolygonMode::fill;
  if (!triangles || cull == CullFace::back) raster.back_mode = PolygonMode::fill;
  e.say(Feature::polygon_modes, !only_fills(raster), was_on,
        !only_fills(raster) ? "Edges or corners are drawn." : triangles ? "The triangles that are left are filled." : "There are no polygons.");

  PolygonOffset& offset = raster.polygon_offset;
  const bool moves = offset.factor != 0 || offset.units != 0;
  const bool matters = triangles && (e.found.needs(Feature::depth_test) || e.found.needs(Feature::depth_write));
  e.say(Feature::polygon_offset, moves && matters, moves,
        !moves ? "Depths stay where they are." : matters ? "Depths are moved." : "Nobody looks at the depths of polygons.");
  if (!matters) offset = {};
}

void examine_scissor(Examination& e) {
  std::optional<PixelRect>& scissor = e.smallest.state.rasterization.scissor;
  const PixelRect all{0, 0, e.target.width, e.target.height};
  const bool cuts = scissor && intersection(*scissor, all) != all;
  e.say(Feature::scissor, cuts, scissor.has_value(),
        cuts ? "It leaves out some of the target." : scissor ? "The whole target lies in it." : "The whole target is open.");
  if (!cuts) scissor.reset();
  const bool samples = e.target.samples > 1;
  e.say(Feature::multisampling, samples, samples, samples ? count_of(e.target.samples, "samples a pixel.") : "One sample a pixel.");
}

void examine_clipping(Examination& e) {
  const bool on_screen = !e.smallest.mesh.screen_positions.empty(), inside = e.bounds.are_inside();
  e.say(Feature::clipping, !inside, true,
        on_screen ? "Vertices are given on the screen."
        : inside  ? "All vertices lie between the near and far plane and in the guard band."
                  : "Some vertices may lie beyond the near or far plane or the guard band.");
  ClippingState& clipping = e.smallest.state.clipping;
  const int asked = clipping.user_plane_count;
  int kept = 0;
  for (int k = 0; k < asked; ++k) {
    const glm::dvec4 plane = clipping.user_planes[static_cast<std::size_t>(k)];
    const bool keeps_all = on_screen || plane == glm::dvec4(0) || (e.bounds.are_known() && e.bounds.range_of(plane).lowest >= 0);
    if (!keeps_all) clipping.user_planes[static_cast<std::size_t>(kept++)] = plane;
  }
  clipping.user_plane_count = kept;
  std::fill(clipping.user_planes.begin() + kept, clipping.user_planes.end(), glm::dvec4(0));
  e.say(Feature::user_planes, kept > 0, asked > 0,
        kept > 0 ? count_of(kept, "of ") + count_of(asked, "may cut something.") : asked > 0 ? "All vertices are inside all of them." : "There are none.");
}

}  // namespace

void examine_program(Examination& e) { examine_interpolation(e); }

void examine_geometry(Examination& e) {
  examine_culling(e);
  examine_polygon_modes(e);
  examine_scissor(e);
  examine_clipping(e);
}

}  // namespace tuberia
