#include "scene/mesh.hpp"

namespace tuberia {

Bounds bounds(const Mesh& mesh) noexcept {
  Bounds box;
  for (const glm::vec3& position : mesh.positions) box.add(position);
  return box;
}

}  // namespace tuberia
