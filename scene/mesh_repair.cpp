#include "scene/mesh_repair.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <unordered_map>

#include <glm/ext/vector_double3.hpp>

namespace tuberia {
namespace {

/// The bits of some floats, 0 for -0.
template <std::size_t kCount>
using Bits = std::array<std::uint32_t, kCount>;

std::uint32_t bits_of(float value) { return std::bit_cast<std::uint32_t>(value + 0.0f); }

struct HashBits {
  template <std::size_t kCount>
  std::size_t operator()(const Bits<kCount>& words) const noexcept {
    std::uint64_t hash = 0x9e3779b97f4a7c15u;
    for (const std::uint32_t word : words) {
      hash = (hash ^ word) * 0xff51afd7ed558ccdu;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }
};

using PositionBits = Bits<3>;
using VertexBits = Bits<18>;

PositionBits position_bits(const glm::vec3& position) {
  return {bits_of(position.x), bits_of(position.y), bits_of(position.z)};
}

/// All attributes of one vertex; zeros for those that the mesh does not have.
VertexBits vertex_bits(const Mesh& mesh, std::uint32_t vertex) {
  VertexBits words{};
  std::size_t next = 0;
  const auto append = [&](const auto& attribute, int components) {
    for (int i = 0; i < components; ++i)
      words[next++] = attribute.empty() ? 0 : bits_of(attribute[vertex][i]);
  };
  append(mesh.positions, 3);
  append(mesh.normals, 3);
  append(mesh.tangents, 3);
  append(mesh.bitangents, 3);
  append(mesh.texcoords, 2);
  append(mesh.colours, 4);
  return words;
}

glm::vec3 unit_or_z(const glm::dvec3& sum) {
  const double length = std::sqrt(sum.x * sum.x + sum.y * sum.y + sum.z * sum.z);
  return length > 0.0 && std::isfinite(length) ? glm::vec3(sum / length) : glm::vec3(0, 0, 1);
}

template <class Value>
void keep(std::vector<Value>& attribute, const std::vector<std::uint32_t>& kept) {
  if (attribute.empty()) return;
  std::vector<Value> chosen;
  chosen.reserve(kept.size());
  for (const std::uint32_t vertex : kept) chosen.push_back(attribute[vertex]);
  attribute = std::move(chosen);
}

}  // namespace

void make_smooth_normals(Mesh& mesh) {
  // Number the different positions.
  std::unordered_map<PositionBits, std::uint32_t, HashBits> numbers;
  std::vector<std::uint32_t> number_of_vertex(mesh.positions.size());
  for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    const auto next = static_cast<std::uint32_t>(numbers.size());
    number_of_vertex[vertex] =
        numbers.try_emplace(position_bits(mesh.positions[vertex]), next).first->second;
  }

  // The cross product of two sides is as long as twice the area: the weight comes for nothing.
  std::vector<glm::dvec3> sums(numbers.size(), glm::dvec3(0));
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
  keep(mesh.positions, kept);
  keep(mesh.normals, kept);
  keep(mesh.tangents, kept);
  keep(mesh.bitangents, kept);
  keep(mesh.texcoords, kept);
  keep(mesh.colours, kept);
}

}  // namespace tuberia
