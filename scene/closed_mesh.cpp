#include "scene/closed_mesh.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

namespace tuberia {
namespace {

/// Of each vertex the first one at its place.
std::vector<std::uint32_t> welded(std::span<const glm::vec3> positions) {
  std::vector<std::uint32_t> by_place(positions.size());
  std::iota(by_place.begin(), by_place.end(), 0u);
  const auto place = [&](std::uint32_t i) { return std::tuple(positions[i].x, positions[i].y, positions[i].z); };
  std::sort(by_place.begin(), by_place.end(), [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
  std::vector<std::uint32_t> number(positions.size());
  for (std::size_t i = 0; i < by_place.size(); ++i) {
    const bool same = i > 0 && positions[by_place[i]] == positions[by_place[i - 1]];
    number[by_place[i]] = same ? number[by_place[i - 1]] : by_place[i];
  }
  return number;
}

struct Edge {
  std::uint32_t low, high;
  int direction;  // 1: from low to high, -1: back
};

}  // namespace

bool is_closed(const DrawCall& draw) {
  const MeshView& mesh = draw.mesh;
  if (draw.state.assembly.topology != Topology::triangles || mesh.positions.empty() || mesh.element_count() < 3) return false;
  const std::vector<std::uint32_t> number = welded(mesh.positions);
  const auto vertex = [&](std::size_t element) { return number[mesh.indices.empty() ? element : mesh.indices[element]]; };
  std::vector<Edge> edges;
  for (std::size_t first = 0; first + 2 < mesh.element_count(); first += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = vertex(first + k), to = vertex(first + (k + 1) % 3);
      if (from != to) edges.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return std::tuple(a.low, a.high) < std::tuple(b.low, b.high); });
  for (std::size_t i = 0; i < edges.size();) {
    int sum = 0;
    const Edge edge = edges[i];
    for (; i < edges.size() && edges[i].low == edge.low && edges[i].high == edge.high; ++i) sum += edges[i].direction;
    if (sum != 0) return false;
  }
  return !edges.empty();
}

}  // namespace tuberia
