#pragma once
// All shapes and triangles of a scene, in world space.

#include <glm/mat4x4.hpp>
#include <memory>
#include <vector>

#include "reference/ray_tracer/items.hpp"
#include "reference/ray_tracer/shapes/shape.hpp"
#include "scene/mesh.hpp"

namespace tuberia::tracer {

/// Each shape is an item, and each triangle of a mesh. `part` numbers are the caller's: what belongs together, of one material.
class Geometry final : public Items {
 public:
  void add_shape(std::shared_ptr<const Shape> shape, const glm::dmat4& world_from_object, int part);
  /// Triangles without an area, or with corners that are not finite, are items that nothing meets. Normals: the
  /// mesh's at its vertices if it has any and not `facets`.
  void add_mesh(const Mesh& mesh, const glm::dmat4& world_from_object, int part);

  std::int64_t count() const noexcept override;
  Box bounds(std::int64_t item) const noexcept override;
  bool intersect(std::int64_t item, const PreparedRay& ray, Hit& nearest) const noexcept override;

  int part_of(std::int64_t item) const noexcept;
  bool is_convex(std::int64_t item) const noexcept;  // Shape::is_convex; triangles are
  /// The point that the ray met, world space.
  SurfacePoint surface(const Ray& ray, const Hit& hit) const noexcept;
};

}  // namespace tuberia::tracer
