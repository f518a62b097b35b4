#include "scene/mesh_editing.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "math/parameter_error.hpp"
#include "math/transforms.hpp"
#include "scene/triangle_corners.hpp"

namespace tuberia {

Mesh transformed(Mesh mesh, const glm::mat4& to_from_object) {
  const glm::dmat4 matrix(to_from_object);
  const glm::dmat3 linear(matrix), normals(normal_matrix(to_from_object));
  for (glm::vec3& position : mesh.positions) position = glm::vec3(matrix * glm::dvec4(position, 1.0));
  for (glm::vec3& normal : mesh.normals) normal = glm::vec3(unit_or(normals * glm::dvec3(normal), glm::dvec3(normal)));
  for (auto* tangents : {&mesh.tangents, &mesh.bitangents})
    for (glm::vec3& tangent : *tangents) tangent = glm::vec3(linear * glm::dvec3(tangent));
  if (glm::determinant(linear) < 0)
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
  return mesh;
}

Mesh joined(Mesh first, const Mesh& second) {
  const auto offset = static_cast<std::uint32_t>(first.positions.size());
  const auto append = [](auto& to, const auto& from) {
    if (to.empty() || from.empty()) to.clear();
    else to.insert(to.end(), from.begin(), from.end());
  };
  if (first.positions.empty() || second.positions.empty()) return first.positions.empty() ? second : first;
  append(first.positions, second.positions);
  append(first.normals, second.normals);
  append(first.tangents, second.tangents);
  append(first.bitangents, second.bitangents);
  append(first.texcoords, second.texcoords);
  append(first.colours, second.colours);
  for (const std::uint32_t index : second.indices) first.indices.push_back(offset + index);
  return first;
}

Result<Mesh> with_repeated_texture(Mesh mesh, const glm::dvec2& times) {
  if (!std::isfinite(times.x) || times.x == 0) return parameter_error("times.x", times.x, "finite and not 0");
  if (!std::isfinite(times.y) || times.y == 0) return parameter_error("times.y", times.y, "finite and not 0");
  for (glm::vec2& texcoord : mesh.texcoords) texcoord = glm::vec2(glm::dvec2(texcoord) * times);
  for (glm::vec3& tangent : mesh.tangents) tangent = glm::vec3(glm::dvec3(tangent) / times.x);
  for (glm::vec3& bitangent : mesh.bitangents) bitangent = glm::vec3(glm::dvec3(bitangent) / times.y);
  return mesh;
}

}  // namespace tuberia
