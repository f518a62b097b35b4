#include "scene/shapes/disc_grid.hpp"

#include "scene/shapes/surface_grid.hpp"

namespace tuberia {

void append_disc(Mesh& mesh, const DiscGrid& disc) {
  const double side = disc.upwards ? 1.0 : -1.0, diameter = 2.0 * disc.radius;
  append_grid(mesh, disc.slices, disc.rings, [&](int column, int row) {
    // Rows run down as seen from the disc's front: from the middle out when it looks up, else from the rim in.
    const int ring = disc.upwards ? row : disc.rings - row;
    const glm::dvec2 direction = point_on_unit_circle(column, disc.slices) * (static_cast<double>(ring) / disc.rings);
    const double x = direction.x, z = 0.0 - direction.y;
    return SurfacePoint{.position = {disc.radius * x, disc.height, disc.radius * z}, .normal = {0, side, 0},
                        .tangent = {diameter, 0, 0}, .bitangent = {0, 0, side * diameter},
                        .texcoord = {0.5 + 0.5 * x, 0.5 + 0.5 * side * z}};
  });
}

}  // namespace tuberia
