#include "examples/tuberia/witness/picture_grid.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace tuberia::witness {
namespace {

double on_grid(double pixels) { return std::nearbyint(pixels * 256) / 256; }

double doubled_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

}  // namespace

glm::dvec3 PictureGrid::screen_from_world(const glm::dvec3& point) const {
  const glm::dvec3 offset = point - eye_;
  const double w = is_parallel_ ? 1 : -glm::dot(offset, basis_.w), scale = is_parallel_ ? 1 : view_.near_distance / w;
  const glm::dvec2 window(glm::dot(offset, basis_.u) * scale, glm::dot(offset, basis_.v) * scale);
  return {(window.x - view_.left) / (view_.right - view_.left) * size_.x, (view_.top - window.y) / (view_.top - view_.bottom) * size_.y, w};
}

std::optional<glm::dvec2> PictureGrid::weights_at(const std::array<glm::dvec3, 3>& corners, const glm::dvec2& place) const {
  std::array<glm::dvec2, 3> at;
  std::array<double, 3> w;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 screen = screen_from_world(corners[k]);
    if (!is_parallel_ && !(screen.z > view_.near_distance)) return std::nullopt;
    at[k] = {on_grid(screen.x), on_grid(screen.y)};
    w[k] = screen.z;
  }
  if (doubled_area(at[0], at[1], at[2]) == 0) return std::nullopt;
  const glm::dvec3 shares(doubled_area(place, at[1], at[2]) / w[0], doubled_area(at[0], place, at[2]) / w[1], doubled_area(at[0], at[1], place) / w[2]);
  const double sum = shares.x + shares.y + shares.z;
  return glm::dvec2(shares.y, shares.z) / sum;
}

}  // namespace tuberia::witness
