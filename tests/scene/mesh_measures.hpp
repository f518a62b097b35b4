#pragma once
// What a mesh comes to as a body: edges, volume, area.

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <map>
#include <vector>

#include "scene/mesh.hpp"

namespace tuberia::test {

struct LessByPosition {
  bool operator()(const glm::vec3& a, const glm::vec3& b) const {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  }
};

/// A directed edge between two positions.
using Edge = std::array<glm::vec3, 2>;
struct LessByEdge {
  bool operator()(const Edge& a, const Edge& b) const {
    const LessByPosition less;
    return less(a[0], b[0]) || (!less(b[0], a[0]) && less(a[1], b[1]));
  }
};

inline std::array<glm::dvec3, 3> corners_of(const Mesh& mesh, std::size_t triangle) {
  const std::uint32_t* index = &mesh.indices[3 * triangle];
  return {glm::dvec3(mesh.positions[index[0]]), glm::dvec3(mesh.positions[index[1]]), glm::dvec3(mesh.positions[index[2]])};
}

/// The edges that no triangle walks in the other direction; vertices at one position, to the bit, are one.
inline std::vector<Edge> border_edges(const Mesh& mesh) {
  std::map<Edge, int, LessByEdge> balance;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::vec3 from = mesh.positions[mesh.indices[i + k]], to = mesh.positions[mesh.indices[i + (k + 1) % 3]];
      ++balance[{from, to}];
      --balance[{to, from}];
    }
  std::vector<Edge> border;
  for (const auto& [edge, count] : balance)
    for (int i = 0; i < count; ++i) border.push_back(edge);
  return border;
}

/// By the divergence theorem: positive when the triangles are counter-clockwise from outside.
inline double volume(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size() / 3; ++i) {
    const auto [a, b, c] = corners_of(mesh, i);
    sum += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return sum;
}

inline double area(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size() / 3; ++i) {
    const auto [a, b, c] = corners_of(mesh, i);
    sum += glm::length(glm::cross(b - a, c - a)) / 2;
  }
  return sum;
}

}  // namespace tuberia::test
