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
