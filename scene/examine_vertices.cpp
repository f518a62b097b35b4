// What is fetched of the vertices, and what is computed for them.

#include "pipeline/polygon_modes.hpp"
#include "scene/examination.hpp"

namespace tuberia {
namespace {

constexpr Attributes kUnits = Attributes::unit0 | Attributes::unit1 | Attributes::unit2 | Attributes::unit3;

bool reads(const DrawCall& draw, Attributes one) { return (draw.program.interface().attributes() & one) != Attributes::none; }

void examine_two_sides(Examination& e) {
  TransformState& transform = e.smallest.state.transform;
  const bool was_on = transform.two_sided_colours;
  const bool same = !transform.vertex_lighting && !transform.back_lighting && e.smallest.mesh.back_colours.empty();
  const char* reason = !was_on                                                 ? "Both faces have the same colours."
                       : !e.found.needs(Feature::shading)                      ? "No colour is made."
                       : !reads(e.smallest, Attributes::colour)                ? "The program does not read the vertices' colours."
                       : !makes_triangles(e.smallest.state.assembly.topology)  ? "Points and lines have a front only."
                       : e.smallest.state.culling.cull == CullFace::back       ? "Back faces are left out."
                       : same                                                  ? "Both faces have the same colours."
                                                                               : nullptr;
  e.say(Feature::two_sided_colours, reason == nullptr, was_on, reason != nullptr ? reason : "Faces that are turned away have other colours.");
  if (reason == nullptr) return;
  transform.two_sided_colours = false;
  transform.back_lighting.reset();
}

void examine_lighting(Examination& e) {
  std::optional<Lighting>& lighting = e.smallest.state.transform.vertex_lighting;
  const bool was_on = lighting.has_value(), needed = was_on && reads(e.smallest, Attributes::colour) && e.found.needs(Feature::shading);
  e.say(Feature::vertex_lighting, needed, was_on,
        needed ? "Vertices are lit, and their colours read." : was_on ? "The program does not read the vertices' colours." : "Vertices are not lit.");
  if (!needed) lighting.reset();
}

/// Leaves out the arrays, and the state, that nobody reads.
void examine_arrays(Examination& e) {
  MeshView& mesh = e.smallest.mesh;
  const bool lights = e.found.needs(Feature::vertex_lighting) || e.smallest.state.transform.back_lighting.has_value();
  const bool reads_units = reads(e.smallest, kUnits);
  if (!reads(e.smallest, Attributes::normal) && !lights && !reads_units) mesh.normals = {};
  if (!reads(e.smallest, Attributes::texcoord) && !reads_units) mesh.texcoords = {};
  if (!reads(e.smallest, Attributes::colour) || !e.found.needs(Feature::shading)) mesh.colours = {};
  if (!reads(e.smallest, Attributes::custom)) mesh.custom = {};
  if (!reads(e.smallest, Attributes::tangent)) mesh.tangents = {};
  if (!reads(e.smallest, Attributes::bitangent)) mesh.bitangents = {};
  if (!e.found.needs(Feature::two_sided_colours)) mesh.back_colours = {};
  if (!reads_units) {
    mesh.unit_texcoords = {};
    e.smallest.state.transform.texture_units = {};
    e.smallest.state.transform.view_from_world = glm::mat4(1);
  }
  if (!e.found.needs(Feature::fog)) mesh.fog_coordinates = {};
  if (only_fills(e.smallest.state.rasterization)) mesh.edge_flags = {};
  const Attributes wanted = e.found.needs(Feature::shading) ? e.smallest.program.interface().attributes() : Attributes::none;
  e.found.attributes = wanted;
  const bool needed = wanted != Attributes::none;
  e.say(Feature::vertex_attributes, needed, true,
        needed ? "The program reads " + words_of(wanted) + ": " + std::to_string(scalar_count(wanted)) + " numbers a vertex."
               : "Only positions: nothing else of a vertex is read.");
}

}  // namespace

void examine_vertices(Examination& e) {
  examine_two_sides(e);
  examine_lighting(e);
  examine_arrays(e);
}

}  // namespace tuberia
