#include "scene/content/shape_meshes.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "math/transforms.hpp"
#include "scene/content/polygon_mesh.hpp"
#include "scene/content/texture_picture.hpp"
#include "scene/mesh_editing.hpp"
#include "scene/shapes/shapes.hpp"
#include "scene/vertex_normals.hpp"

namespace tuberia {
namespace {

Result<Mesh> mesh_of(const SceneDescription&, const description::Plane& p) {
  return plane_mesh({.width = p.width, .depth = p.depth, .columns = p.segments.u, .rows = p.segments.v});
}
Result<Mesh> mesh_of(const SceneDescription&, const description::Cube& c) {
  return box_mesh({.width = c.size.x, .height = c.size.y, .depth = c.size.z, .segments = c.segments});
}
Result<Mesh> mesh_of(const SceneDescription&, const description::Sphere& s) {
  return sphere_mesh({.radius = s.radius, .slices = s.segments.u, .stacks = s.segments.v});
}
Result<Mesh> mesh_of(const SceneDescription&, const description::Cylinder& c) {
  return cylinder_mesh({.radius = c.radius, .height = c.height, .slices = c.segments.u, .stacks = c.segments.v, .caps = c.capped});
}
Result<Mesh> mesh_of(const SceneDescription&, const description::Cone& c) {
  return cone_mesh({.radius = c.radius, .height = c.height, .slices = c.segments.u, .stacks = c.segments.v, .caps = c.capped});
}
Result<Mesh> mesh_of(const SceneDescription&, const description::Torus& t) {
  return torus_mesh({.radius = t.ring_radius, .tube_radius = t.tube_radius, .slices = t.segments.u, .stacks = t.segments.v});
}
Result<Mesh> mesh_of(const SceneDescription&, const description::Disc& d) {
  return disc_mesh({.radius = d.radius, .slices = d.segments.u, .rings = d.segments.v});
}

Result<Mesh> mesh_of(const SceneDescription&, const description::Teapot& teapot) {
  auto mesh = teapot_mesh({.segments = teapot.segments});
  if (!mesh) return mesh;
  return teapot.size == 1 ? std::move(mesh) : transformed(*std::move(mesh), scaling(glm::dvec3(teapot.size)));
}

Result<Mesh> mesh_of(const SceneDescription&, const description::BezierPatches& shape) {
  BezierShape bezier{.patches = {}, .segments = shape.segments};
  for (const auto& points : shape.patches) bezier.patches.push_back({.points = points});
  return bezier_mesh(bezier);
}

/// Grid points are vertices; slopes are central differences, one-sided at the border.
Result<Mesh> mesh_of_heights(const description::HeightField& field) {
  const int columns = static_cast<int>(field.heights[0].size()) - 1, rows = static_cast<int>(field.heights.size()) - 1;
  const auto at = [&](int column, int row) {
    return field.height * field.heights[static_cast<std::size_t>(std::clamp(row, 0, rows))][static_cast<std::size_t>(std::clamp(column, 0, columns))];
  };
  const auto slope = [&](int column, int row, int across, int down, int cells) {
    const bool is_inside = across != 0 ? column > 0 && column < columns : row > 0 && row < rows;
    return (at(column + across, row + down) - at(column - across, row - down)) * cells / (is_inside ? 2 : 1);
  };
  return height_field_mesh({.width = field.width, .depth = field.depth, .columns = columns, .rows = rows}, [&](double u, double v) {
    const int column = static_cast<int>(u * columns + 0.5), row = static_cast<int>(v * rows + 0.5);
    return Height{.value = at(column, row), .slope_u = slope(column, row, 1, 0, columns), .slope_v = slope(column, row, 0, 1, rows)};
  });
}

Result<Mesh> mesh_of(const SceneDescription& scene, const description::HeightField& field) {
  if (!field.heights.empty()) return mesh_of_heights(field);
  const description::Texture* texture = find_texture(scene, field.texture);
  if (texture == nullptr) return Error{"there is no texture '" + field.texture + "'"};
  const auto picture = picture_of(scene, *texture);
  if (!picture) return picture.error();
  constexpr int kMostQuadrilaterals = 512;  // along a side; a larger picture is read at some of its texels
  return height_field_mesh({.width = field.width, .depth = field.depth, .columns = std::min(picture->width(), kMostQuadrilaterals),
                            .rows = std::min(picture->height(), kMostQuadrilaterals)}, *picture, field.height);
}

Result<Mesh> mesh_of(const SceneDescription&, const description::TriangleMesh& shape) {
  Mesh mesh;
  mesh.positions.assign(shape.positions.begin(), shape.positions.end());
  for (const glm::dvec3& normal : shape.normals) mesh.normals.push_back(normal == glm::dvec3(0) ? glm::vec3(0) : glm::vec3(glm::normalize(normal)));
  mesh.texcoords.assign(shape.texcoords.begin(), shape.texcoords.end());
  for (const glm::vec3& colour : shape.colours) mesh.colours.emplace_back(colour, 1);
  mesh.indices = shape.indices;
  if (mesh.normals.empty()) return with_vertex_normals(std::move(mesh));
  return mesh;
}

Error traced_only(std::string_view what) { return {std::string(what) + " can only be traced (tuberia trace)"}; }

Result<Mesh> mesh_of(const SceneDescription&, const description::Polygon& polygon) { return polygon_mesh(polygon); }
Result<Mesh> mesh_of(const SceneDescription&, const description::InfinitePlane&) { return traced_only("an infinite plane"); }
Result<Mesh> mesh_of(const SceneDescription&, const description::Polyhedron&) { return traced_only("a polyhedron of planes"); }
Result<Mesh> mesh_of(const SceneDescription&, const description::Quadric&) { return traced_only("a quadric"); }
Result<Mesh> mesh_of(const SceneDescription&, const description::ModelFile& model) { return Error{"model " + model.file + " is no single mesh"}; }

}  // namespace

Result<Mesh> mesh_of_shape(const SceneDescription& scene, const description::Shape& shape) {
  return std::visit([&](const auto& of_its_kind) { return mesh_of(scene, of_its_kind); }, shape);
}

}  // namespace tuberia
