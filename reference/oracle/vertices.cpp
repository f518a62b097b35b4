#include "reference/oracle/vertices.hpp"

namespace tuberia::oracle {
namespace {

/// ((m0 x + m1 y) + m2 z) + m3 in float, with m a row of the matrix.
float row_times(const glm::mat4& m, int row, const glm::vec4& p) {
  const float first = m[0][row] * p.x;
  const float second = m[1][row] * p.y;
  const float third = m[2][row] * p.z;
  return ((first + second) + third) + m[3][row];
}

Interval product(const glm::vec4& plane, const std::array<Interval, 4>& p) {
  const auto factor = [&](int i) { return Interval(static_cast<double>(plane[i])); };
  return ((factor(0) * p[0] + factor(1) * p[1]) + factor(2) * p[2]) + factor(3) * p[3];
}

glm::vec4 matrix_row(const glm::mat4& m, int row) { return {m[0][row], m[1][row], m[2][row], m[3][row]}; }

/// (s, t, r, q) of a unit: each from its source, then all times the matrix.
std::array<Interval, 4> unit_coordinates(const Draw& draw, const InputVertex& in, std::size_t unit) {
  const TexCoordUnit& state = draw.texcoord_units[unit];
  const auto exact = [](float x) { return Interval(static_cast<double>(x)); };
  const std::array<Interval, 4> object{exact(in.position.x), exact(in.position.y), exact(in.position.z), 1.0};
  std::array<Interval, 4> eye{0.0, 0.0, 0.0, 1.0}, made;
  for (int i = 0; i < 3; ++i) eye[static_cast<std::size_t>(i)] = product(matrix_row(draw.view_from_object, i), object);
  const glm::vec4 own = draw.has_unit_texcoords ? in.unit_texcoord[unit] : glm::vec4(in.texcoord.x, in.texcoord.y, 0, 1);
  for (std::size_t i = 0; i < 4; ++i) {
    if (state.source[i] == TexCoordSource::vertex) made[i] = exact(own[static_cast<int>(i)]);
    else made[i] = product(state.plane[i], state.source[i] == TexCoordSource::object_linear ? object : eye);
  }
  std::array<Interval, 4> coordinates;
  for (int i = 0; i < 4; ++i) coordinates[static_cast<std::size_t>(i)] = product(matrix_row(state.matrix, i), made);
  return coordinates;
}

ClipVertex transformed(const Draw& draw, const InputVertex& in) {
  ClipVertex out;
  if (draw.space == PositionSpace::object) {
    out.x = row_times(draw.clip_from_object, 0, in.position);
    out.y = row_times(draw.clip_from_object, 1, in.position);
    out.z = row_times(draw.clip_from_object, 2, in.position);
    out.w = row_times(draw.clip_from_object, 3, in.position);
  } else {
    out.x = in.position.x;
    out.y = in.position.y;
    out.z = in.position.z;
    out.w = in.position.w;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    out.front[kColour + i] = static_cast<double>(in.colour[static_cast<int>(i)]);
    out.back[kColour + i] = static_cast<double>((draw.two_sided_colours ? in.back_colour : in.colour)[static_cast<int>(i)]);
  }
  out.front[kTexcoord] = out.back[kTexcoord] = static_cast<double>(in.texcoord.x);
  out.front[kTexcoord + 1] = out.back[kTexcoord + 1] = static_cast<double>(in.texcoord.y);
  out.front[kFogCoordinate] = out.back[kFogCoordinate] =
      static_cast<double>(draw.has_fog_coordinates ? in.fog_coordinate : out.w);
  if (draw.program.kind == ProgramKind::fixed_function)
    for (std::size_t unit = 0; unit < kTextureUnits; ++unit) {
      const std::array<Interval, 4> coordinates = unit_coordinates(draw, in, unit);
      for (std::size_t i = 0; i < 4; ++i) out.front[kUnitCoordinates + 4 * unit + i] = out.back[kUnitCoordinates + 4 * unit + i] = coordinates[i];
    }
  out.edge_flag = in.edge_flag;
  return out;
}

}  // namespace

std::vector<ClipVertex> transformed(const Draw& draw) {
  std::vector<ClipVertex> vertices;
  if (draw.indices.empty())
    for (const InputVertex& vertex : draw.vertices) vertices.push_back(transformed(draw, vertex));
  else
    for (const std::uint32_t index : draw.indices) vertices.push_back(transformed(draw, draw.vertices[index]));
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
