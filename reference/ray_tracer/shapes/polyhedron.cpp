#include "reference/ray_tracer/shapes/polyhedron.hpp"

#include <algorithm>
#include <string>

#include "reference/ray_tracer/shapes/crossing.hpp"
#include "reference/ray_tracer/shapes/side_frame.hpp"

namespace tuberia::tracer {
namespace {

using Planes = std::vector<glm::dvec4>;

glm::dvec3 normal_of(const glm::dvec4& plane) noexcept { return glm::dvec3(plane); }
double height_over(const glm::dvec4& plane, const glm::dvec3& point) noexcept { return glm::dot(normal_of(plane), point) + plane.w; }

Result<Planes> with_unit_normals(std::span<const glm::dvec4> planes) {
  Planes unit;
  for (const glm::dvec4& plane : planes) {
    const double length = glm::length(normal_of(plane));
    if (!(std::isfinite(length) && std::isfinite(plane.w) && length > 0))
      return Error{"polyhedron: plane " + std::to_string(unit.size()) + " has no direction, or a number that is not finite"};
    unit.push_back(plane / length);
  }
  return unit;
}

/// Around the corners: points of three planes that are outside no other.
Box box_of(const Planes& planes) noexcept {
  double largest = 0;
  for (const glm::dvec4& plane : planes) largest = std::max(largest, std::abs(plane.w));
  Box box;
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      const glm::dvec3 along = glm::cross(normal_of(planes[i]), normal_of(planes[j]));
      for (std::size_t k = j + 1; k < planes.size() && glm::length(along) > 1e-12; ++k) {
        const glm::dvec3 a = normal_of(planes[i]), b = normal_of(planes[j]), c = normal_of(planes[k]);
        const double determinant = glm::dot(along, c);
        if (std::abs(determinant) < 1e-12) continue;
        const glm::dvec3 corner = -(planes[i].w * glm::cross(b, c) + planes[j].w * glm::cross(c, a) + planes[k].w * along) / determinant;
        const double tolerance = 1e-10 * (largest + glm::length(corner));
        const auto is_inside = [&](const glm::dvec4& plane) { return height_over(plane, corner) <= tolerance; };
        if (std::all_of(planes.begin(), planes.end(), is_inside)) box.add(corner);
      }
    }
  return box;
}

/// Whether one can go on for ever in some direction: then also along the line of two planes.
bool is_endless(const Planes& planes) noexcept {
  for (const glm::dvec4& first : planes)
    for (const glm::dvec4& second : planes) {
      const glm::dvec3 along = glm::cross(normal_of(first), normal_of(second));
      if (glm::length(along) < 1e-12) continue;
      const glm::dvec3 direction = glm::normalize(along);
      const auto lets_pass = [&](const glm::dvec4& plane) { return glm::dot(normal_of(plane), direction) <= 1e-12; };
      if (std::all_of(planes.begin(), planes.end(), lets_pass)) return true;
    }
  return false;
}

}  // namespace

Result<std::shared_ptr<const Polyhedron>> Polyhedron::create(std::span<const glm::dvec4> planes) {
  if (planes.size() > kMostPlanes) return Error{"polyhedron: " + std::to_string(planes.size()) + " planes, but at most " + std::to_string(kMostPlanes) + " are possible"};
  Result<Planes> unit = with_unit_normals(planes);
  if (!unit) return unit.error();
  const Box box = box_of(*unit);
  if (box.empty()) return Error{"polyhedron: its " + std::to_string(planes.size()) + " planes enclose nothing"};
  if (is_endless(*unit)) return Error{"polyhedron: its " + std::to_string(planes.size()) + " planes leave it without an end"};
  return std::shared_ptr<const Polyhedron>(new Polyhedron(std::move(*unit), box));
}

std::optional<ShapeHit> Polyhedron::intersect(const Ray& ray) const noexcept {
  Crossing crossing;
  for (std::size_t i = 0; i < planes_.size(); ++i)
    crossing.cut(height_over(planes_[i], ray.origin), glm::dot(normal_of(planes_[i]), ray.direction), static_cast<int>(i));
  return first_end(crossing, ray);
}

SurfacePoint Polyhedron::surface(const Ray& ray, const ShapeHit& hit) const noexcept {
  const glm::dvec4& plane = planes_[static_cast<std::size_t>(hit.face)];
  const glm::dvec3 normal = normal_of(plane), near_surface = ray.at(hit.t);
  SurfacePoint point;
  point.position = near_surface - height_over(plane, near_surface) * normal;
  point.normal = point.geometric_normal = normal;
  point.magnitude = std::max({std::abs(plane.w), glm::length(box_.lower), glm::length(box_.upper)});

  const SideFrame frame = side_frame(normal);
  const double width = std::abs(glm::dot(box_.size(), frame.right)), height = std::abs(glm::dot(box_.size(), frame.down));
  const glm::dvec3 from_centre = point.position - box_.centre();
  point.texcoord = {0.5 + glm::dot(from_centre, frame.right) / width, 0.5 + glm::dot(from_centre, frame.down) / height};
  point.tangent = width * dropped_on_plane(frame.right, normal, frame.axis);
  point.bitangent = height * dropped_on_plane(frame.down, normal, frame.axis);
  return point;
}

}  // namespace tuberia::tracer
