#pragma once
// Triangles and rays that our fast kernel and Embree are compared on.

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "reference/ray_tracer/fast/fast_triangles.hpp"

namespace tuberia::bench {

/// World space, three indices a triangle.
struct TriangleSoup {
  std::string name;
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
};

/// The Stanford bunny, 2 units high, each triangle split in four so many times; where there is no such file, a sphere of about as many triangles.
TriangleSoup bunny(int subdivisions);

struct RaySet {
  std::string name;
  std::vector<tracer::FastRay> rays;
};

/// Through the pixels of a picture of the bunny that is 16:9, 45 degrees high, from 2.9 units in front of it; unit directions, squares of
/// 4 x 4 pixels one after another.
RaySet primary_rays(int width_pixels, int height_pixels);

/// From anywhere in the bunny's box to anywhere, in no order.
RaySet incoherent_rays(int count);

}  // namespace tuberia::bench
