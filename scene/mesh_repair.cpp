#include "scene/mesh_repair.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <glm/ext/vector_double3.hpp>

#include "scene/float_bits.hpp"
#include "scene/mesh_vertices.hpp"

namespace tuberia {
namespace {

using VertexBits = Bits<18>;

/// All attributes of one vertex; zeros for those that the mesh does not have.
VertexBits vertex_bits(const Mesh& mesh, std::uint32_t vertex) {
  VertexBits words{};
  std::size_t next = 0;
  for_each_attribute(mesh, [&](const auto& attribute) {
    using Value = typename std::remove_reference_t<decltype(attribute)>::value_type;
    for (int i = 0; i < Value::length(); ++i) words[next++] = attribute.empty() ? 0 : bits_of(attribute[vertex][i]);
  });
  return words;
}

glm::vec3 unit_or_z(const glm::dvec3& sum) {
  const double length = std::sqrt(sum.x * sum.x + sum.y * sum.y + sum.z * sum.z);
  return length > 0.0 && std::isfinite(length) ? glm::vec3(sum / length) : glm::vec3(0, 0, 1);
}

}  // namespace

void make_smooth_normals(Mesh& mesh) {
  const std::vector<std::uint32_t> number_of_vertex = position_numbers(mesh);
  const std::size_t numbers = number_of_vertex.empty() ? 0 : *std::max_element(number_of_vertex.begin(), number_of_vertex.end()) + 1u;

  // The cross product of two sides is as long as twice the area: the weight comes for nothing.
  std::vector<glm::dvec3> sums(numbers, glm::dvec3(0));
  for (std::size_t corner = 0; corner + 2 < mesh.indices.size(); corner += 3) {
    const std::uint32_t* vertex = &mesh.indices[corner];
    const glm::dvec3 a = mesh.positions[vertex[0]], b = mesh.positions[vertex[1]],
                     c = mesh.positions[vertex[2]];
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    for (int i = 0; i < 3; ++i) sums[number_of_vertex[vertex[i]]] += normal;
  }

  mesh.normals.resize(mesh.positions.size());
  for (std::size_t vertex = 0; vertex < mesh.normals.size(); ++vertex) {
    mesh.normals[vertex] = unit_or_z(sums[number_of_vertex[vertex]]);
  }
}

void join_identical_vertices(Mesh& mesh) {
  std::unordered_map<VertexBits, std::uint32_t, HashBits> numbers;
  std::vector<std::uint32_t> kept;
  for (std::uint32_t& index : mesh.indices) {
    const auto next = static_cast<std::uint32_t>(kept.size());
    const auto [entry, is_new] = numbers.try_emplace(vertex_bits(mesh, index), next);
    if (is_new) kept.push_back(index);
    index = entry->second;
  }
  choose_vertices(mesh, kept);
}

}  // namespace tuberia
