#include "scene/shapes/zigzag.hpp"

#include <glm/geometric.hpp>

#include "scene/shapes/surface_grid.hpp"

namespace tuberia {

Result<Mesh> zigzag_mesh(const ZigzagShape& shape) {
  ShapeCheck check("zigzag");
  check.positive("width", shape.width).positive("depth", shape.depth).positive("height", shape.height);
  check.count("flanks", shape.flanks, 1).count("strips_per_flank", shape.strips_per_flank, 1);
  check.product("flanks * strips_per_flank", shape.flanks, shape.strips_per_flank);
  if (check.error()) return *check.error();

  Mesh mesh;
  mesh.name = "zigzag";
  for (int flank = 0; flank < shape.flanks; ++flank) {
    const double rise = flank % 2 == 0 ? shape.height : -shape.height;
    const glm::dvec3 tangent(shape.width, rise * shape.flanks, 0), bitangent(0, 0, shape.depth);
    append_grid(mesh, shape.strips_per_flank, 1, [&](int column, int row) {
      const double along_flank = static_cast<double>(column) / shape.strips_per_flank, u = (flank + along_flank) / shape.flanks, v = row;
      const double height = rise > 0 ? along_flank - 0.5 : 0.5 - along_flank;
      return SurfacePoint{.position = {(u - 0.5) * shape.width, height * shape.height, (v - 0.5) * shape.depth},
                          .normal = glm::normalize(glm::cross(bitangent, tangent)), .tangent = tangent, .bitangent = bitangent,
                          .texcoord = {u, v}};
    });
  }
  return mesh;
}

}  // namespace tuberia
