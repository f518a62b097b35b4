#include "reference/ray_tracer/shapes/polygon.hpp"

#include <algorithm>
#include <string>

#include "reference/ray_tracer/shapes/crossing.hpp"
#include "reference/ray_tracer/shapes/side_frame.hpp"
#include "reference/ray_tracer/shapes/triangle.hpp"

namespace tuberia::tracer {
namespace {

/// Twice the area times the normal, by the sum over all edges: it does not matter whether the first corner is concave.
glm::dvec3 area_of(std::span<const glm::dvec3> corners) noexcept {
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < corners.size(); ++i) sum += glm::cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
  return sum;
}

std::optional<Error> complaint(const std::string& ring, std::span<const glm::dvec3> corners) {
  if (corners.size() < 3) return Error{"polygon: " + ring + " has " + std::to_string(corners.size()) + " corners, but needs at least 3"};
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (!std::isfinite(corners[i].x + corners[i].y + corners[i].z))
      return Error{"polygon: corner " + std::to_string(i) + " of " + ring + " is not finite"};
  return std::nullopt;
}

}  // namespace

bool is_inside(std::span<const Ring> rings, const glm::dvec2& point) noexcept {
  bool inside = false;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const glm::dvec2 a = ring[i] - point, b = ring[(i + 1) % ring.size()] - point;
      const bool a_above = a.y >= 0, b_above = b.y >= 0;
      if (a_above == b_above) continue;
      // Where the edge crosses v = 0: at (a.x b.y - b.x a.y) / (b.y - a.y), of which only the sign is asked.
      const double numerator = difference_of_products(a.x, b.y, b.x, a.y);
      if (b_above ? numerator > 0 : numerator < 0) inside = !inside;
    }
  return inside;
}

Result<std::shared_ptr<const Polygon>> Polygon::create(std::span<const glm::dvec3> outline, std::span<const std::vector<glm::dvec3>> holes) {
  std::vector<std::pair<std::string, std::span<const glm::dvec3>>> rings{{"the outline", outline}};
  for (std::size_t i = 0; i < holes.size(); ++i) rings.emplace_back("hole " + std::to_string(i), holes[i]);
  for (const auto& ring : rings)
    if (const std::optional<Error> error = complaint(ring.first, ring.second)) return *error;

  double size = 0;
  for (const glm::dvec3& corner : outline) size = std::max(size, glm::length(corner - outline[0]));
  const glm::dvec3 area = area_of(outline);
  const double length = glm::length(area);
  if (!(length > 1e-12 * size * size)) return Error{"polygon: the outline has no area"};
  const glm::dvec3 normal = area / length;

  std::shared_ptr<Polygon> polygon(new Polygon(outline[0], normal));
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.second.size(); ++i) {
      const double distance = std::abs(glm::dot(ring.second[i] - outline[0], normal));
      if (distance > 1e-6 * size)
        return Error{"polygon: corner " + std::to_string(i) + " of " + ring.first + " is " + std::to_string(distance) + " away from the plane of the outline"};
    }
    polygon->add_ring(ring.second);
  }
  return std::shared_ptr<const Polygon>(std::move(polygon));
}

Polygon::Polygon(const glm::dvec3& corner, const glm::dvec3& normal) noexcept : corner_(corner), normal_(normal), axis_(dominant_axis(normal)) {}

void Polygon::add_ring(std::span<const glm::dvec3> corners) {
  Ring& ring = rings_.emplace_back();
  for (const glm::dvec3& corner : corners) {
    ring.push_back(projected(corner));
    box_.add(on_plane(corner));
  }
}

glm::dvec2 Polygon::projected(const glm::dvec3& point) const noexcept { return {point[(axis_ + 1) % 3], point[(axis_ + 2) % 3]}; }

glm::dvec3 Polygon::on_plane(glm::dvec3 point) const noexcept {
  point[axis_] -= glm::dot(point - corner_, normal_) / normal_[axis_];
  return point;
}

std::optional<ShapeHit> Polygon::intersect(const Ray& ray) const noexcept {
  const double rate = glm::dot(normal_, ray.direction);
  const double t = glm::dot(normal_, corner_ - ray.origin) / rate;  // [5-13]
  if (rate == 0 || !is_within(ray, t) || !is_inside(rings_, projected(ray.at(t)))) return std::nullopt;
  return ShapeHit{.t = t};
}

SurfacePoint Polygon::surface(const Ray& ray, const ShapeHit& hit) const noexcept {
  SurfacePoint point;
  point.position = on_plane(ray.at(hit.t));
  point.normal = point.geometric_normal = normal_;
  point.magnitude = std::max(glm::length(box_.lower), glm::length(box_.upper));

  const SideFrame frame = side_frame(normal_);
  const double width = std::abs(glm::dot(box_.size(), frame.right)), height = std::abs(glm::dot(box_.size(), frame.down));
  const glm::dvec3 from_centre = point.position - box_.centre();
  point.texcoord = {0.5 + glm::dot(from_centre, frame.right) / width, 0.5 + glm::dot(from_centre, frame.down) / height};
  point.tangent = width * dropped_on_plane(frame.right, normal_, frame.axis);
  point.bitangent = height * dropped_on_plane(frame.down, normal_, frame.axis);
  return point;
}

}  // namespace tuberia::tracer
