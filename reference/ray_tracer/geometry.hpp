#pragma once
// All shapes and triangles of a scene, in world space.

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <memory>
#include <vector>

#include "reference/ray_tracer/items.hpp"
#include "reference/ray_tracer/shapes/shape.hpp"
#include "scene/mesh.hpp"

namespace tuberia::tracer {

/// world = linear * object + translation. Inverted in two steps, so that what is far from the world's origin loses no digits.
struct Placement {
  explicit Placement(const glm::dmat4& world_from_object) noexcept;

  Ray to_object(const Ray& ray) const noexcept;  // t stays the same
  glm::dvec3 point_to_world(const glm::dvec3& point) const noexcept { return linear * point + translation; }
  /// Unit; points outwards, mirrored or not. 0 for a normal without a length.
  glm::dvec3 normal_to_world(const glm::dvec3& normal) const noexcept;
  Box to_world(const Box& box) const noexcept;   // infinite sides stay infinite
  BoundingSphere to_world(const BoundingSphere& sphere) const noexcept;
  /// What a number of object space can become in the world.
  double magnitude_to_world(double magnitude) const noexcept;

  glm::dmat3 linear, inverse, normal_matrix;
  glm::dvec3 translation;
  bool is_regular;   // finite, and of an inverse
  bool is_mirrored;  // turns every winding round
};

/// Each shape is an item, and each triangle of a mesh. `part` numbers are the caller's: what belongs together, of one material.
/// Matrices are affine; their last row is not looked at.
class Geometry final : public Items {
 public:
  /// A shape whose matrix has no inverse is an item that nothing meets.
  void add_shape(std::shared_ptr<const Shape> shape, const glm::dmat4& world_from_object, int part);
  /// Triangles without an area, or with corners that are not finite, are items that nothing meets. Normals: the
  /// mesh's at its vertices if it has any and not `facets`. Tangents: the mesh's; or of each triangle's texture coordinates; or, without any,
  /// perpendicular unit vectors.
  void add_mesh(const Mesh& mesh, const glm::dmat4& world_from_object, int part, bool facets = false);

  std::int64_t count() const noexcept override { return static_cast<std::int64_t>(references_.size()); }
  /// The empty box for an item that nothing meets.
  Box bounds(std::int64_t item) const noexcept override;
  BoundingSphere bounding_sphere(std::int64_t item) const noexcept override;
  bool intersect(std::int64_t item, const PreparedRay& ray, Hit& nearest) const noexcept override;

  int part_of(std::int64_t item) const noexcept;
  bool is_convex(std::int64_t item) const noexcept;  // Shape::is_convex; triangles are
  /// The corners of a triangle, world space; nullopt for a shape, and for a triangle that nothing meets.
  std::optional<std::array<glm::dvec3, 3>> triangle(std::int64_t item) const noexcept;
  /// The point that the ray met, world space.
  SurfacePoint surface(const Ray& ray, const Hit& hit) const noexcept;

 private:
  struct PlacedShape {
    std::shared_ptr<const Shape> shape;
    Placement placement;
    Box bounds;
    int part;
  };
  struct Corners {
    std::array<std::uint32_t, 3> vertices{};
    bool can_be_met = false;
  };
  /// World space; attributes are empty or have one entry for each position. Normals are unit.
  struct PlacedMesh {
    std::vector<glm::dvec3> positions, normals, tangents, bitangents;
    std::vector<glm::vec2> texcoords;
    std::vector<glm::vec4> colours;
    std::vector<Corners> triangles;
    int part = 0;
    bool is_mirrored = false;

    std::array<glm::dvec3, 3> corners_of(std::int32_t triangle) const noexcept;
    SurfacePoint surface(std::int32_t triangle, const glm::dvec3& weights) const noexcept;
    void find_tangents(SurfacePoint& point, std::int32_t triangle, const glm::dvec3& weights) const noexcept;
  };
  /// An item: a shape, or a triangle of a mesh.
  struct Reference {
    std::int32_t mesh = -1, index = 0;
  };

  const Reference& reference(std::int64_t item) const noexcept { return references_[static_cast<std::size_t>(item)]; }

  std::vector<Reference> references_;
  std::vector<PlacedShape> shapes_;
  std::vector<PlacedMesh> meshes_;
};

}  // namespace tuberia::tracer
