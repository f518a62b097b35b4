#include "reference/ray_tracer/exact_shape.hpp"

#include "reference/ray_tracer/shapes/cuboid.hpp"
#include "reference/ray_tracer/shapes/flat_shapes.hpp"
#include "reference/ray_tracer/shapes/polygon.hpp"
#include "reference/ray_tracer/shapes/polyhedron.hpp"
#include "reference/ray_tracer/shapes/quadric.hpp"
#include "reference/ray_tracer/shapes/round_shapes.hpp"
#include "reference/ray_tracer/shapes/sphere.hpp"
#include "reference/ray_tracer/shapes/torus.hpp"

namespace tuberia::tracer {
namespace {

using ShapePointer = std::shared_ptr<const Shape>;
using ShapeResult = Result<ShapePointer>;

ShapeResult shape_of(const description::Plane& plane) { return ShapePointer(std::make_shared<Rectangle>(plane.width, plane.depth)); }
ShapeResult shape_of(const description::Cube& cube) { return ShapePointer(std::make_shared<Cuboid>(cube.size)); }
ShapeResult shape_of(const description::Sphere& sphere) { return ShapePointer(std::make_shared<Sphere>(sphere.radius)); }
ShapeResult shape_of(const description::Cylinder& c) { return ShapePointer(std::make_shared<Cylinder>(c.radius, c.height, c.capped)); }
ShapeResult shape_of(const description::Cone& c) { return ShapePointer(std::make_shared<Cone>(c.radius, c.height, c.capped)); }
ShapeResult shape_of(const description::Torus& torus) { return ShapePointer(std::make_shared<Torus>(torus.ring_radius, torus.tube_radius)); }
ShapeResult shape_of(const description::Disc& disc) { return ShapePointer(std::make_shared<Disc>(disc.radius)); }
ShapeResult shape_of(const description::InfinitePlane&) { return ShapePointer(std::make_shared<InfinitePlane>()); }

template <class OfItsKind>
ShapeResult shape_or_error(Result<std::shared_ptr<const OfItsKind>> made) {
  if (!made) return made.error();
  return ShapePointer(*std::move(made));
}
ShapeResult shape_of(const description::Polygon& p) { return shape_or_error(Polygon::create(p.outline, p.holes)); }
ShapeResult shape_of(const description::Polyhedron& p) { return shape_or_error(Polyhedron::create(p.planes)); }
ShapeResult shape_of(const description::Quadric& q) { return shape_or_error(Quadric::create(q.q, q.lower, q.upper)); }

template <class OfTriangles>
ShapeResult shape_of(const OfTriangles&) { return ShapePointer(); }

}  // namespace

Result<std::shared_ptr<const Shape>> exact_shape(const description::Shape& shape) {
  return std::visit([](const auto& of_its_kind) { return shape_of(of_its_kind); }, shape);
}

bool may_have_no_mesh(const description::Shape& shape) noexcept {
  return std::holds_alternative<description::InfinitePlane>(shape) || std::holds_alternative<description::Polygon>(shape) ||
         std::holds_alternative<description::Polyhedron>(shape) || std::holds_alternative<description::Quadric>(shape);
}

}  // namespace tuberia::tracer
