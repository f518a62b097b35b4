#include "scene/sphere_mapping.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/mesh_vertices.hpp"
#include "scene/triangle_corners.hpp"

namespace tuberia {
namespace {

constexpr double kSpherePi = std::numbers::pi;

// An angle below this between the axes leaves too few bits to find where u = 0.
constexpr double kParallelAxes = 1e-9;

bool is_pole(const glm::dvec2& coordinates) { return coordinates.y <= 0 || coordinates.y >= 1; }

/// The three corners of a triangle in one piece of the pattern's plane.
void unwrap(std::array<glm::dvec2, 3>& corner, const TextureMapping& mapping) {
  const auto counts = [&](const glm::dvec2& coordinates) { return !(mapping.has_poles && is_pole(coordinates)); };
  double largest = 0, sum = 0;
  int count = 0;
  for (const glm::dvec2& c : corner)
    if (counts(c)) largest = std::max(largest, c.x);
  for (glm::dvec2& c : corner) {
    if (!counts(c)) continue;
    if (mapping.u_wraps && largest - c.x > 0.5) c.x += 1;
    sum += c.x;
    ++count;
  }
  for (glm::dvec2& c : corner)
    if (!counts(c) && count > 0) c.x = sum / count;
}

}  // namespace

glm::dvec2 sphere_coordinates(const glm::dvec3& normal, const SphereAxes& axes) noexcept {
  const double phi = std::acos(std::clamp(-glm::dot(axes.pole, normal), -1.0, 1.0));
  const double v = phi / kSpherePi;
  if (v <= 0 || v >= 1) return {0, v};
  const double u = std::acos(std::clamp(glm::dot(axes.equator, normal) / std::sin(phi), -1.0, 1.0)) / (2 * kSpherePi);
  return {glm::dot(glm::cross(axes.pole, axes.equator), normal) < 0 ? 1 - u : u, v};
}

Result<TextureMapping> sphere_mapping(const SphereAxes& axes, bool use_positions) {
  const glm::dvec3 pole = unit_or(axes.pole, glm::dvec3(0)), equator = unit_or(axes.equator, glm::dvec3(0));
  if (pole == glm::dvec3(0)) return Error{"sphere mapping: the axis to the pole has no direction"};
  if (equator == glm::dvec3(0)) return Error{"sphere mapping: the axis to the equator has no direction"};
  const glm::dvec3 across = equator - glm::dot(equator, pole) * pole;
  if (!(glm::length(across) > kParallelAxes)) return Error{"sphere mapping: the axes to the pole and to the equator are parallel"};
  const SphereAxes clean{.pole = pole, .equator = glm::normalize(across)};
  return TextureMapping{.coordinates = [clean, use_positions](const glm::dvec3& position, const glm::dvec3& normal) {
                          return sphere_coordinates(unit_or(use_positions ? position : normal, clean.equator), clean);
                        }, .u_wraps = true, .has_poles = true};
}

Result<Mesh> with_texture_mapping(Mesh mesh, const TextureMapping& mapping) {
  if (mesh.normals.empty()) return Error{"mesh '" + mesh.name + "' has no normals to map a texture by"};
  std::vector<glm::dvec2> of_vertex(mesh.positions.size());
  for (std::size_t i = 0; i < of_vertex.size(); ++i) {
    of_vertex[i] = mapping.coordinates(mesh.positions[i], mesh.normals[i]);
    if (!std::isfinite(of_vertex[i].x) || !std::isfinite(of_vertex[i].y))
      return Error{"texture mapping: the coordinates of vertex " + std::to_string(i) + " are not finite"};
  }

  // Every corner by itself first; then those of one vertex that agree share it again.
  std::vector<glm::dvec2> of_corner(mesh.indices.size());
  std::vector<std::uint32_t> variants(mesh.indices.size());
  for (std::uint32_t first = 0; first + 2 < mesh.indices.size(); first += 3) {
    std::array<glm::dvec2, 3> corner{};
    for (std::uint32_t k = 0; k < 3; ++k) corner[k] = of_vertex[mesh.indices[first + k]];
    const auto plain = corner;
    unwrap(corner, mapping);
    for (std::uint32_t k = 0; k < 3; ++k) {
      of_corner[first + k] = corner[k];
      const bool own = mapping.has_poles && is_pole(corner[k]);
      variants[first + k] = own ? 2 + first / 3 : corner[k].x != plain[k].x ? 1 : 0;
    }
  }
  split_vertices(mesh, variants);
  mesh.tangents.clear();
  mesh.bitangents.clear();
  mesh.texcoords.resize(mesh.positions.size());
  for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner)
    mesh.texcoords[mesh.indices[corner]] = glm::vec2(of_corner[corner].x, 1 - of_corner[corner].y);
  return mesh;
}

}  // namespace tuberia
