#include "reference/ray_tracer/footprint.hpp"

namespace tuberia::tracer {
namespace {

glm::dvec2 texcoord_step(const SurfacePoint& at, const Ray& neighbour) noexcept {
  const glm::dvec3 &n = at.geometric_normal, &tu = at.tangent, &tv = at.bitangent;
  const double t = glm::dot(at.position - neighbour.origin, n) / glm::dot(neighbour.direction, n);
  const glm::dvec3 step = neighbour.at(t) - at.position;
  // step = du tu + dv tv, in the sense of least squares where the tangents are not in the plane.
  const double uu = glm::dot(tu, tu), uv = glm::dot(tu, tv), vv = glm::dot(tv, tv), su = glm::dot(step, tu), sv = glm::dot(step, tv);
  const glm::dvec2 moved = glm::dvec2(vv * su - uv * sv, uu * sv - uv * su) / (uu * vv - uv * uv);
  return std::isfinite(moved.x) && std::isfinite(moved.y) ? moved : glm::dvec2(0);
}

}  // namespace

TextureFootprint footprint_of(const SurfacePoint& at, const NeighbourRays& neighbours) noexcept {
  return {.right = texcoord_step(at, neighbours.right), .down = texcoord_step(at, neighbours.down)};
}

}  // namespace tuberia::tracer
