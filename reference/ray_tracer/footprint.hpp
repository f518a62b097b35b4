#pragma once
// How much of a texture a pixel covers, from the rays through its neighbours.                            [A 1.1]

#include "reference/ray_tracer/traced_scene.hpp"

namespace tuberia::tracer {

/// The rays one pixel to the right of an eye ray and one below it.
struct NeighbourRays {
  Ray right, down;
};

/// How far texture coordinates move from `at` to where the neighbours meet its tangent plane; 0 where they do not.
TextureFootprint footprint_of(const SurfacePoint& at, const NeighbourRays& neighbours) noexcept;

}  // namespace tuberia::tracer
