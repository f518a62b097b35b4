#include "reference/oracle/vertices.hpp"

#include <algorithm>

#include "reference/oracle/fog.hpp"
#include "reference/oracle/lighting.hpp"
#include "reference/oracle/matrices.hpp"
#include "reference/oracle/texture_coordinates.hpp"

namespace tuberia::oracle {
namespace {

/// What all vertices of a draw have in common.
struct DrawMatrices {
  glm::mat4 clip_from_object;
  glm::mat3 world_normal_from_object;
  std::vector<UnitCoordinates> units;  // of the fixed-function program
};

DrawMatrices matrices_of(const Draw& draw) {
  DrawMatrices matrices{composed(draw.clip_from_world, draw.world_from_object), normal_matrix(draw.world_from_object), {}};
  if (draw.program.kind == ProgramKind::fixed_function)
    for (std::size_t unit = 0; unit < kTextureUnits; ++unit) matrices.units.emplace_back(draw, unit);
  return matrices;
}

void place(const Draw& draw, const InputVertex& in, const DrawMatrices& matrices, ClipVertex& out) {
  glm::vec4 clip = in.position;
  if (draw.space == PositionSpace::object)
    for (int i = 0; i < 4; ++i) clip[i] = row_times(matrices.clip_from_object, i, glm::vec3(in.position));
  out.x = clip.x;
  out.y = clip.y;
  out.z = clip.z;
  out.w = clip.w;
}

/// The surface's colour, lit if there is lighting.
void colour_face(const std::optional<Lighting>& lighting, const glm::vec4& surface, const glm::vec3& point, const glm::vec3& normal,
                 Scalars& out) {
  const Colour light = lighting ? lit(*lighting, point, normal) : Colour{1.0, 1.0, 1.0, 1.0};
  for (std::size_t i = 0; i < 4; ++i) out[kColour + i] = light[i] * Interval(static_cast<double>(surface[static_cast<int>(i)]));
}

void colour(const Draw& draw, const InputVertex& in, const DrawMatrices& matrices, ClipVertex& out) {
  glm::vec3 point(in.position), normal(0);
  if (draw.vertex_lighting || draw.back_lighting) {
    normal = transformed_normal(matrices.world_normal_from_object, in.normal);
    if (draw.space == PositionSpace::object)
      for (int i = 0; i < 3; ++i) point[i] = row_times(draw.world_from_object, i, glm::vec3(in.position));
  }
  const glm::vec4 front = draw.has_colours ? in.colour : glm::vec4(1);
  colour_face(draw.vertex_lighting, front, point, normal, out.front);
  if (!draw.two_sided_colours) std::copy_n(out.front.begin() + kColour, 4, out.back.begin() + kColour);
  else colour_face(draw.back_lighting ? draw.back_lighting : draw.vertex_lighting, draw.has_back_colours ? in.back_colour : front, point, -normal, out.back);
}

ClipVertex transformed(const Draw& draw, const InputVertex& in, const DrawMatrices& matrices) {
  ClipVertex out;
  place(draw, in, matrices, out);
  colour(draw, in, matrices, out);
  out.front[kTexcoord] = out.back[kTexcoord] = static_cast<double>(in.texcoord.x);
  out.front[kTexcoord + 1] = out.back[kTexcoord + 1] = static_cast<double>(in.texcoord.y);
  const Interval coordinate = one_float(draw.has_fog_coordinates ? in.fog_coordinate : out.w);
  const bool has_share = draw.fog.mode != FogMode::off && draw.fog.per_vertex;
  out.front[kFogCoordinate] = out.back[kFogCoordinate] = has_share ? fog_share(draw.fog, absolute(coordinate)) : coordinate;
  for (std::size_t unit = 0; unit < matrices.units.size(); ++unit) {
    const glm::vec4 strq = matrices.units[unit](in);
    for (std::size_t i = 0; i < 4; ++i)
      out.front[kUnitCoordinates + 4 * unit + i] = out.back[kUnitCoordinates + 4 * unit + i] = one_float(strq[static_cast<int>(i)]);
  }
  out.edge_flag = in.edge_flag;
  return out;
}

}  // namespace

std::vector<ClipVertex> transformed(const Draw& draw) {
  std::vector<ClipVertex> vertices;
  const DrawMatrices matrices = matrices_of(draw);
  if (draw.indices.empty())
    for (const InputVertex& vertex : draw.vertices) vertices.push_back(transformed(draw, vertex, matrices));
  else
    for (const std::uint32_t index : draw.indices) vertices.push_back(transformed(draw, draw.vertices[index], matrices));
  return vertices;
}

std::vector<Primitive> assembled(Topology topology, std::size_t n) {
  std::vector<Primitive> list;
  switch (topology) {
    case Topology::triangles:
      for (std::size_t i = 0; i + 2 < n; i += 3) list.push_back({3, {i, i + 1, i + 2}});
      break;
    case Topology::triangle_strip:
      for (std::size_t i = 0; i + 2 < n; ++i)
        list.push_back(i % 2 == 0 ? Primitive{3, {i, i + 1, i + 2}} : Primitive{3, {i, i + 2, i + 1}});
      break;
    case Topology::triangle_fan:
      for (std::size_t i = 0; i + 2 < n; ++i) list.push_back({3, {i + 1, i + 2, 0}});
      break;
    case Topology::lines:
      for (std::size_t i = 0; i + 1 < n; i += 2) list.push_back({2, {i, i + 1, 0}});
      break;
    case Topology::line_strip:
      for (std::size_t i = 0; i + 1 < n; ++i) list.push_back({2, {i, i + 1, 0}});
      break;
    case Topology::line_loop:
      for (std::size_t i = 0; i + 1 < n; ++i) list.push_back({2, {i, i + 1, 0}});
      if (n >= 2) list.push_back({2, {n - 1, 0, 0}});
      break;
    case Topology::points:
      for (std::size_t i = 0; i < n; ++i) list.push_back({1, {i, 0, 0}});
      break;
  }
  return list;
}

}  // namespace tuberia::oracle
