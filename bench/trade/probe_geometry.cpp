#include "bench/trade/probe_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace tuberia::bench::trade {
namespace {

/// The part of a polygon on the side of the line coordinate = bound where sign * (coordinate - bound) >= 0.
std::vector<glm::dvec2> cut(const std::vector<glm::dvec2>& polygon, int axis, double bound, double sign) {
  std::vector<glm::dvec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double d_from = sign * (from[axis] - bound), d_to = sign * (to[axis] - bound);
    if (d_from >= 0) kept.push_back(from);
    if ((d_from >= 0) != (d_to >= 0)) kept.push_back(from + (to - from) * (d_from / (d_from - d_to)));
  }
  return kept;
}

enum class Place { inside, outside, across };

/// Where a pixel lies, as far as distances from its centre to the edges tell. Sides of a clockwise polygon
/// (y down) are positive inside.
Place place_of(std::span<const glm::dvec2> polygon, const glm::dvec2& centre, double orientation) {
  constexpr double kHalfDiagonal = 0.7072;
  Place place = Place::inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 &a = polygon[i], along = polygon[(i + 1) % polygon.size()] - a, to = centre - a;
    const double distance = orientation * (along.x * to.y - along.y * to.x) / glm::length(along);
    if (distance < -kHalfDiagonal) return Place::outside;
    if (distance < kHalfDiagonal) place = Place::across;
  }
  return place;
}

double signed_area(std::span<const glm::dvec2> polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return twice / 2;
}

}  // namespace

bool covers_centre(const std::array<FinePoint, 3>& triangle, int x, int y) noexcept {
  constexpr std::int64_t kPixel = std::int64_t{1} << kFineBits;
  const FinePoint centre{x * kPixel + kPixel / 2, y * kPixel + kPixel / 2};
  int positive = 0, negative = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const FinePoint &a = triangle[i], &b = triangle[(i + 1) % 3];
    const std::int64_t edge = (b.x - a.x) * (centre.y - a.y) - (b.y - a.y) * (centre.x - a.x);
    positive += edge > 0 ? 1 : 0;
    negative += edge < 0 ? 1 : 0;
  }
  return positive == 3 || negative == 3;
}

double perimeter(const std::array<FinePoint, 3>& triangle) noexcept {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const FinePoint &a = triangle[i], &b = triangle[(i + 1) % 3];
    sum += std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
  }
  return std::ldexp(sum, -kFineBits);
}

double covered_area(std::span<const glm::dvec2> polygon, int x, int y) noexcept {
  const Place place = place_of(polygon, {x + 0.5, y + 0.5}, signed_area(polygon) < 0 ? -1 : 1);
  if (place != Place::across) return place == Place::inside ? 1 : 0;
  std::vector<glm::dvec2> part(polygon.begin(), polygon.end());
  part = cut(part, 0, x, 1);
  part = cut(part, 0, x + 1, -1);
  part = cut(part, 1, y, 1);
  return std::abs(signed_area(cut(part, 1, y + 1, -1)));
}

}  // namespace tuberia::bench::trade
