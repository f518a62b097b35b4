#pragma once
// Descriptions of shapes as what rays meet.

#include <memory>

#include "base/result.hpp"
#include "reference/ray_tracer/shapes/shape.hpp"
#include "scene/description/shape.hpp"

namespace tuberia::tracer {

/// The surface itself, in object space; null for shapes that are meshes: teapots, patches, height fields, triangles and models.
/// Errors: of polygons, polyhedra and quadrics that are none.
Result<std::shared_ptr<const Shape>> exact_shape(const description::Shape& shape);

/// Whether there may be no mesh of it, so that even who asks for triangles gets the surface itself.
bool may_have_no_mesh(const description::Shape& shape) noexcept;

}  // namespace tuberia::tracer
