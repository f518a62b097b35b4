#include "scene/content/polygon_mesh.hpp"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace tuberia {
namespace {

using Corners = std::vector<glm::dvec3>;

/// Twice the area as a vector along the normal.
glm::dvec3 area_of(const Corners& outline) {
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < outline.size(); ++i) sum += glm::cross(outline[i] - outline[0], outline[(i + 1) % outline.size()] - outline[0]);
  return sum;
}

/// Whether no corner lies outside of any edge.
bool is_convex(const Corners& outline, const glm::dvec3& area) {
  const double size = glm::dot(area, area);
  for (std::size_t i = 0; i < outline.size(); ++i)
    for (const glm::dvec3& corner : outline)
      if (glm::dot(glm::cross(outline[(i + 1) % outline.size()] - outline[i], corner - outline[i]), area) < -1e-9 * size) return false;
  return true;
}

/// The image's directions on the side of a box with this normal.
struct Side {
  glm::dvec3 right, down;
};

Side side_of(const glm::dvec3& normal) {
  const glm::dvec3 size = glm::abs(normal);
  if (size.x >= size.y && size.x >= size.z) return {{0, 0, normal.x < 0 ? 1 : -1}, {0, -1, 0}};
  if (size.y >= size.z) return {{1, 0, 0}, {0, 0, normal.y < 0 ? -1 : 1}};
  return {{normal.z < 0 ? -1 : 1, 0, 0}, {0, -1, 0}};
}

std::vector<glm::vec2> texcoords_of(const Corners& outline, const Side& side) {
  const auto place = [&](const glm::dvec3& corner) { return glm::dvec2(glm::dot(corner, side.right), glm::dot(corner, side.down)); };
  glm::dvec2 lower = place(outline[0]), upper = lower;
  for (const glm::dvec3& corner : outline) {
    lower = glm::min(lower, place(corner));
    upper = glm::max(upper, place(corner));
  }
  std::vector<glm::vec2> texcoords;
  for (const glm::dvec3& corner : outline) texcoords.emplace_back((place(corner) - lower) / (upper - lower));
  return texcoords;
}

}  // namespace

Result<Mesh> polygon_mesh(const description::Polygon& polygon) {
  const Corners& outline = polygon.outline;
  const glm::dvec3 area = outline.empty() ? glm::dvec3(0) : area_of(outline);
  if (area == glm::dvec3(0)) return Error{"its polygon has no area"};
  if (!polygon.holes.empty()) return Error{"a polygon with holes can only be traced (tuberia trace)"};
  if (!is_convex(outline, area)) return Error{"a polygon that is not convex can only be traced (tuberia trace)"};
  Mesh mesh;
  mesh.positions.assign(outline.begin(), outline.end());
  mesh.normals.assign(outline.size(), glm::vec3(glm::normalize(area)));
  mesh.texcoords = texcoords_of(outline, side_of(area));
  for (std::uint32_t i = 2; i < outline.size(); ++i) mesh.indices.insert(mesh.indices.end(), {0, i - 1, i});
  return mesh;
}

}  // namespace tuberia
