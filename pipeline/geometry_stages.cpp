#include "pipeline/geometry_stages.hpp"

namespace tuberia {

GeometryStages::GeometryStages(const DrawCall& draw, const AcceptedDraw& accepted, InstructionSet isa, Precision precision)
    : draw_(draw), accepted_(accepted), limits_(clip_limits(accepted.viewport, draw.state.clipping)),
      vertex_transform_(draw.state.transform, limits_, isa), primitive_assembly_(draw.state.assembly), clipping_(limits_),
      perspective_divide_(screen_map(accepted.viewport, draw.state.viewport.depth_range, draw.state.clipping.volume,
                                     draw.state.rasterization.subpixel_bits), isa),
      culling_(draw.state.culling, accepted.clip, isa, accepted.output.samples),
      polygon_modes_(draw.state, accepted.clip, accepted.output.samples, accepted.output.depth_format, draw.mesh.edge_flags),
      rasterization_(accepted.clip, isa, precision, accepted.output.samples, draw.state.rasterization.edge_arithmetic),
      shape_set_up_(draw.state.rasterization, accepted.output.samples),
      offset_(draw.state.rasterization.polygon_offset, accepted.output.depth_format),
      only_fills_(only_fills(draw.state.rasterization)) {}

void GeometryStages::fetch(Chunk& chunk) const {
  chunk.fetch(draw_.mesh, draw_.state.assembly.topology, chunk.range, chunk.vertices, chunk.slots);
  chunk.statistics = {.triangles_in = chunk.range.count, .vertices = static_cast<std::int64_t>(chunk.vertices.source.size())};
  // What the chunk's last draw left behind. (Triangles are assembled over it.)
  if (!makes_triangles(draw_.state.assembly.topology)) chunk.triangles.clear();
  chunk.lines.clear();
  chunk.points.clear();
}

void GeometryStages::assemble(Chunk& chunk) const {
  const Topology topology = draw_.state.assembly.topology;
  if (makes_triangles(topology)) primitive_assembly_(chunk.slots, chunk.range, chunk.triangles);
  else if (topology == Topology::points) primitive_assembly_(chunk.slots, chunk.range, chunk.points);
  else primitive_assembly_(chunk.slots, chunk.range, chunk.lines);
}

void GeometryStages::clip(Chunk& chunk) const {
  const Topology topology = draw_.state.assembly.topology;
  std::int64_t& cut = chunk.statistics.triangles_clipped;
  if (topology == Topology::points) cut = clipping_(chunk.vertices, chunk.points);
  else if (!makes_triangles(topology)) cut = clipping_(chunk.vertices, chunk.lines);
  else if (only_fills_) cut = clipping_(chunk.vertices, chunk.triangles);
  else cut = clipping_(chunk.vertices, chunk.triangles, chunk.polygons);
  chunk.statistics.triangles_after_clipping = chunk.primitives();
}

void GeometryStages::place(VertexBatch& vertices) const {
  if (draw_.mesh.screen_positions.empty()) perspective_divide_(vertices);
  else PerspectiveDivide::take(draw_.mesh.screen_positions, vertices);
}

void GeometryStages::cull(Chunk& chunk) const {
  int uncovered = 0;
  if (accepted_.clip.empty()) {
    chunk.triangles.clear();
    chunk.lines.clear();
    chunk.points.clear();
  } else if (makes_triangles(draw_.state.assembly.topology)) {
    if (only_fills_) uncovered = culling_(chunk.vertices, chunk.triangles);
    else polygon_modes_(chunk.vertices, chunk.polygons, chunk.triangles, chunk.lines, chunk.points);
  }
  chunk.statistics.triangles_drawn = chunk.primitives() + uncovered;
}

void GeometryStages::fill_in_attributes(Chunk& chunk) const {
  // A pass that makes no colours needs positions only.
  vertex_transform_.attributes(draw_.mesh, accepted_.attributes, chunk.triangles, chunk.vertices, chunk.lines, chunk.points);
  const FogState& fog = draw_.state.fog;
  if (fog.mode == FogMode::off || !shades(draw_.program.interface(), accepted_.output)) chunk.vertices.fog_coordinates.clear();
  else if (fog.per_vertex) vertex_transform_.fog_shares(draw_.mesh, fog, chunk.vertices);
  else vertex_transform_.fog_coordinates(draw_.mesh, chunk.vertices);
}

void GeometryStages::set_up(Chunk& chunk) const {
  rasterization_.set_up(chunk.triangles, chunk.vertices, chunk.screen_triangles);
  Rasterization::choose_perspective(draw_.state.rasterization.perspective, chunk.screen_triangles);
  if (offset_.applies_to(PolygonMode::fill)) offset_.move(chunk.vertices, chunk.screen_triangles);
  shape_set_up_(chunk);
  rasterization_.choose_faces(chunk.vertices, chunk.screen_triangles);
  rasterization_.measure(chunk.screen_triangles, chunk.extents);
}

std::uint32_t GeometryStages::continue_stipple(Chunk& chunk, std::uint32_t start) const noexcept {
  const Topology topology = draw_.state.assembly.topology;
  const bool continues = topology == Topology::line_strip || topology == Topology::line_loop;
  const auto& stipple = draw_.state.rasterization.line.stipple;
  return continues && stipple ? continue_pattern(chunk, start, *stipple) : 0;
}

}  // namespace tuberia
