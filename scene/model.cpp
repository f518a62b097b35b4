#include "scene/model.hpp"

namespace tuberia {

std::int64_t Model::triangle_count() const noexcept {
  std::int64_t count = 0;
  for (const Mesh& mesh : meshes) count += mesh.triangle_count();
  return count;
}

std::int64_t Model::vertex_count() const noexcept {
  std::int64_t count = 0;
  for (const Mesh& mesh : meshes) count += static_cast<std::int64_t>(mesh.positions.size());
  return count;
}

Bounds Model::bounds() const noexcept {
  Bounds box;
  for (const Mesh& mesh : meshes) box.add(tuberia::bounds(mesh));
  return box;
}

}  // namespace tuberia
