#include "scene/mesh_vertices.hpp"

#include <unordered_map>

#include "scene/float_bits.hpp"

namespace tuberia {

void choose_vertices(Mesh& mesh, std::span<const std::uint32_t> chosen) {
  for_each_attribute(mesh, [&](auto& attribute) {
    if (attribute.empty()) return;
    std::remove_reference_t<decltype(attribute)> kept;
    kept.reserve(chosen.size());
    for (const std::uint32_t vertex : chosen) kept.push_back(attribute[vertex]);
    attribute = std::move(kept);
  });
}

std::vector<std::uint32_t> position_numbers(const Mesh& mesh) {
  std::unordered_map<Bits<3>, std::uint32_t, HashBits> numbers;
  std::vector<std::uint32_t> number_of_vertex(mesh.positions.size());
  for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex) {
    const auto next = static_cast<std::uint32_t>(numbers.size());
    const glm::vec3& position = mesh.positions[vertex];
    const Bits<3> bits{bits_of(position.x), bits_of(position.y), bits_of(position.z)};
    number_of_vertex[vertex] = numbers.try_emplace(bits, next).first->second;
  }
  return number_of_vertex;
}

void split_vertices(Mesh& mesh, std::span<const std::uint32_t> variant_of_corner) {
  std::unordered_map<std::uint64_t, std::uint32_t> numbers;
  std::vector<std::uint32_t> chosen;
  for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner) {
    std::uint32_t& index = mesh.indices[corner];
    const std::uint64_t key = static_cast<std::uint64_t>(index) << 32 | variant_of_corner[corner];
    const auto [entry, is_new] = numbers.try_emplace(key, static_cast<std::uint32_t>(chosen.size()));
    if (is_new) chosen.push_back(index);
    index = entry->second;
  }
  choose_vertices(mesh, chosen);
}

}  // namespace tuberia
