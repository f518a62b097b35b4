#include "reference/ray_tracer/exact_shape.hpp"

#include "reference/ray_tracer/shapes/cuboid.hpp"
#include "reference/ray_tracer/shapes/flat_shapes.hpp"
#include "reference/ray_tracer/shapes/sphere.hpp"

namespace tuberia::tracer {
namespace {

using ShapePointer = std::shared_ptr<const Shape>;

ShapePointer shape_of(const description::Plane& plane) { return std::make_shared<Rectangle>(plane.width, plane.depth); }
ShapePointer shape_of(const description::Cube& cube) { return std::make_shared<Cuboid>(cube.size); }
ShapePointer shape_of(const description::Sphere& sphere) { return std::make_shared<Sphere>(sphere.radius); }
ShapePointer shape_of(const description::InfinitePlane&) { return std::make_shared<InfinitePlane>(); }
template <class Mesh>
ShapePointer shape_of(const Mesh&) { return nullptr; }

}  // namespace

std::shared_ptr<const Shape> exact_shape(const description::Shape& shape) {
  return std::visit([](const auto& of_its_kind) { return shape_of(of_its_kind); }, shape);
}

bool is_never_mesh(const description::Shape& shape) noexcept {
  return std::holds_alternative<description::InfinitePlane>(shape) || std::holds_alternative<description::Polygon>(shape) ||
         std::holds_alternative<description::Polyhedron>(shape) || std::holds_alternative<description::Quadric>(shape);
}

}  // namespace tuberia::tracer
