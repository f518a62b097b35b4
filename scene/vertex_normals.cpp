#include "scene/vertex_normals.hpp"

#include <algorithm>
#include <cmath>
#include <glm/ext/vector_double3.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>
#include <tuple>
#include <vector>

#include "math/parameter_error.hpp"
#include "scene/mesh_vertices.hpp"
#include "scene/triangle_corners.hpp"

namespace tuberia {
namespace {

// Planes this near are one: the sine of the angle between the normals of two halves of a quadrilateral whose
// corners were rounded to floats.
constexpr double kSamePlane = 1e-5;

/// Sets that are joined until no more belongs together.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  std::uint32_t root(std::uint32_t item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t first = root(a), second = root(b);
    parent_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Corners of triangles that meet along an edge: the corner at one end of it, the position number of both ends.
struct EdgeEnd {
  std::uint32_t here, there, corner;
};

/// Every corner has two edges: to the next and to the previous corner of its triangle. In the order of edges.
std::vector<EdgeEnd> edge_ends(const Mesh& mesh) {
  const std::vector<std::uint32_t> number = position_numbers(mesh);
  std::vector<EdgeEnd> ends;
  ends.reserve(2 * mesh.indices.size());
  for (std::uint32_t corner = 0; corner < mesh.indices.size(); ++corner)
    for (const std::uint32_t other : {next_corner(corner), previous_corner(corner)})
      ends.push_back({number[mesh.indices[corner]], number[mesh.indices[other]], corner});
  std::sort(ends.begin(), ends.end(), [](const EdgeEnd& a, const EdgeEnd& b) {
    return std::tie(a.here, a.there, a.corner) < std::tie(b.here, b.there, b.corner);
  });
  return ends;
}

/// Corners at one position, joined across each edge along which `joins` says so of the two triangles.
template <class Joins>
DisjointSets joined_corners(const Mesh& mesh, const std::vector<EdgeEnd>& ends, Joins joins) {
  DisjointSets sets(mesh.indices.size());
  for (std::size_t first = 0, last = 0; first < ends.size(); first = last) {
    while (last < ends.size() && ends[last].here == ends[first].here && ends[last].there == ends[first].there) ++last;
    for (std::size_t a = first; a < last; ++a)
      for (std::size_t b = a + 1; b < last; ++b)
        if (joins(ends[a].corner / 3, ends[b].corner / 3)) sets.join(ends[a].corner, ends[b].corner);
  }
  return sets;
}

std::vector<glm::dvec3> facet_normals(const Mesh& mesh) {
  std::vector<glm::dvec3> normals(mesh.indices.size() / 3);
  for (std::uint32_t triangle = 0; triangle < normals.size(); ++triangle) normals[triangle] = unit_normal(mesh, triangle);
  return normals;
}

bool has_area(const glm::dvec3& normal) { return normal != glm::dvec3(0); }
bool same_plane(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::dot(a, b) > 0 && glm::length(glm::cross(a, b)) < kSamePlane;
}

/// Triangles without area go with the first other triangle at each of their vertices.
void lean_on_others(const Mesh& mesh, const std::vector<glm::dvec3>& normals, std::vector<std::uint32_t>& variant_of_corner) {
  std::vector<std::optional<std::uint32_t>> variant_of_vertex(mesh.positions.size());
  for (std::uint32_t corner = 0; corner < mesh.indices.size(); ++corner)
    if (auto& variant = variant_of_vertex[mesh.indices[corner]]; !variant && has_area(normals[corner / 3])) variant = variant_of_corner[corner];
  for (std::uint32_t corner = 0; corner < mesh.indices.size(); ++corner) {
    if (has_area(normals[corner / 3])) continue;
    auto& variant = variant_of_vertex[mesh.indices[corner]];
    if (!variant) variant = variant_of_corner[corner];
    variant_of_corner[corner] = *variant;
  }
}

/// Gives each corner the normal of its variant and splits the vertices of different ones.
void set_normals(Mesh& mesh, const std::vector<glm::dvec3>& normal_of_variant, const std::vector<std::uint32_t>& variant_of_corner) {
  split_vertices(mesh, variant_of_corner);
  mesh.normals.resize(mesh.positions.size());
  for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner) {
    const glm::dvec3& sum = normal_of_variant[variant_of_corner[corner]];
    mesh.normals[mesh.indices[corner]] = glm::vec3(unit_or(sum, {0, 0, 1}));
  }
}

}  // namespace

Result<Mesh> with_vertex_normals(Mesh mesh, const NormalRule& rule) {
  if (!(rule.crease_angle_radians >= 0 && rule.crease_angle_radians <= std::numbers::pi))
    return parameter_error("crease_angle_radians", rule.crease_angle_radians, "between 0 and pi");

  // Which corners share a normal, and which are of one polygon.
  const std::vector<glm::dvec3> normals = facet_normals(mesh);
  const std::vector<EdgeEnd> ends = edge_ends(mesh);
  const double smallest_cosine = std::cos(rule.crease_angle_radians) - 1e-12;
  DisjointSets smooth = joined_corners(mesh, ends, [&](std::uint32_t a, std::uint32_t b) {
    return has_area(normals[a]) && has_area(normals[b]) &&
           (same_plane(normals[a], normals[b]) || glm::dot(normals[a], normals[b]) >= smallest_cosine);
  });
  DisjointSets polygons = joined_corners(mesh, ends, [&](std::uint32_t a, std::uint32_t b) { return same_plane(normals[a], normals[b]); });

  std::vector<glm::dvec3> sums(mesh.indices.size(), glm::dvec3(0));
  std::vector<std::uint32_t> variants(mesh.indices.size());
  for (std::uint32_t corner = 0; corner < variants.size(); ++corner) {
    variants[corner] = smooth.root(corner);
    const bool is_first_of_polygon = polygons.root(corner) == corner;
    const double weight = rule.weight == NormalWeight::by_angle ? angle_at(mesh, corner) : is_first_of_polygon ? 1.0 : 0.0;
    sums[variants[corner]] += weight * normals[corner / 3];
  }
  lean_on_others(mesh, normals, variants);
  set_normals(mesh, sums, variants);
  return mesh;
}

Mesh with_facet_normals(Mesh mesh) {
  const std::vector<glm::dvec3> normals = facet_normals(mesh);
  DisjointSets planes = joined_corners(mesh, edge_ends(mesh), [&](std::uint32_t a, std::uint32_t b) { return normals[a] == normals[b]; });
  std::vector<glm::dvec3> normal_of_corner(mesh.indices.size());
  std::vector<std::uint32_t> variants(mesh.indices.size());
  for (std::uint32_t corner = 0; corner < variants.size(); ++corner) {
    variants[corner] = planes.root(corner);
    normal_of_corner[corner] = normals[corner / 3];
  }
  set_normals(mesh, normal_of_corner, variants);
  return mesh;
}

}  // namespace tuberia
