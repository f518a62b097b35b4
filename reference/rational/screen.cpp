#include "reference/rational/screen.hpp"

#include <algorithm>
#include <cmath>

namespace tuberia::rational {
namespace {

constexpr std::int64_t kGuardBand = std::int64_t{1} << 23;  // units

/// numerator / w * scale + offset, times 2^shift, exactly; scale and offset are doubles of the contract.
Quotient mapped(float numerator, float w, double scale, double offset, int shift) {
  const Dyadic n = dyadic(static_cast<double>(numerator)), d = dyadic(static_cast<double>(w));
  const Dyadic s = dyadic(scale), o = dyadic(offset);
  const int product = n.exponent + s.exponent, sum = o.exponent + d.exponent;
  const bool has_product = n.mantissa != 0 && s.mantissa != 0, has_sum = o.mantissa != 0;
  const int unit = !has_product ? sum : !has_sum ? product : std::min(product, sum);
  Integer top;
  if (has_product) top += (Integer(static_cast<long>(n.mantissa)) * static_cast<long>(s.mantissa)) << static_cast<mp_bitcnt_t>(product - unit);
  if (has_sum) top += (Integer(static_cast<long>(o.mantissa)) * static_cast<long>(d.mantissa)) << static_cast<mp_bitcnt_t>(sum - unit);
  return {top, static_cast<long>(d.mantissa), std::int64_t{unit} - d.exponent + shift};
}

/// The same in double, and how far it may be from the truth: five roundings of at most 2^-53 each.
Estimate estimated(float numerator, float w, double scale, double offset) {
  const double product = static_cast<double>(numerator) / static_cast<double>(w) * scale;
  return {product + offset, 0x1p-50 * (std::abs(product) + std::abs(offset))};
}

/// Rationals decide only where doubles cannot; the contract's doubles are in doubt there, too.
std::int64_t snapped(float numerator, float w, double scale_pixels, double offset_pixels, bool& is_doubtful) {
  const auto [pixels, error] = estimated(numerator, w, scale_pixels, offset_pixels);
  const double low = 256 * (pixels - error), high = 256 * (pixels + error);
  if (low >= static_cast<double>(kGuardBand)) return kGuardBand;
  if (high <= static_cast<double>(-kGuardBand)) return -kGuardBand;
  if (std::floor(low + 0.5) == std::floor(high + 0.5) && std::floor(low + 0.5) != low + 0.5) return static_cast<std::int64_t>(std::floor(low + 0.5));
  is_doubtful = true;
  return nearest_whole(mapped(numerator, w, scale_pixels, offset_pixels, 8), kGuardBand);
}

float depth_of(float z, float w, double scale, double offset, bool& is_doubtful) {
  const auto [depth, error] = estimated(z, w, scale, offset);
  const float low = static_cast<float>(depth - error), high = static_cast<float>(depth + error);
  if (low == high && std::abs(low) > 0x1p-100f) return low;
  is_doubtful = is_doubtful || low != high;
  return nearest_float(mapped(z, w, scale, offset, 0));
}

}  // namespace

ClipVertex position_of(const Polygon& polygon, const Corner& corner, const Triangle& triangle, bool& is_doubtful) {
  if (corner.vertex >= 0) return triangle[static_cast<std::size_t>(corner.vertex)];
  for (const Estimate& number : corner.computed)
    if (static_cast<float>(number.value - number.error) != static_cast<float>(number.value + number.error)) is_doubtful = true;
  const auto rounded = [&](Integer Corner::*coordinate) { return nearest_float(quotient(polygon, corner, coordinate)); };
  return {rounded(&Corner::x), rounded(&Corner::y), rounded(&Corner::z), rounded(&Corner::w)};
}

ScreenCorner on_screen(const ClipVertex& v, const View& view, bool& is_doubtful) {
  const double half_width = view.viewport.width / 2.0, half_height = view.viewport.height / 2.0;
  const double n = static_cast<double>(view.near_depth), f = static_cast<double>(view.far_depth);
  const bool is_symmetric = view.lowest_z == -1;
  return {snapped(v.x, v.w, half_width, view.viewport.x + half_width, is_doubtful),
          snapped(v.y, v.w, -half_height, view.viewport.y + half_height, is_doubtful),
          depth_of(v.z, v.w, is_symmetric ? (f - n) / 2 : f - n, is_symmetric ? (n + f) / 2 : n, is_doubtful), v.w};
}

ScreenTriangle::ScreenTriangle(const ScreenCorner& first, const ScreenCorner& second, const ScreenCorner& third)
    : corners_{first, second, third} {
  area_ = (second.x - first.x) * (third.y - first.y) - (second.y - first.y) * (third.x - first.x);
  is_turned_ = area_ < 0;
  if (is_turned_) std::swap(corners_[1], corners_[2]);
  area_ = std::abs(area_);
  for (std::size_t k = 0; k < 3; ++k) {
    const ScreenCorner& from = corners_[(k + 1) % 3];
    const ScreenCorner& to = corners_[(k + 2) % 3];
    // Clockwise with y down: a left edge runs upwards, a top edge to the right.
    const bool is_left = to.y < from.y, is_top = to.y == from.y && to.x > from.x;
    edges_[k] = {from.y - to.y, to.x - from.x, from.x, from.y, is_left || is_top ? 0 : 1};
  }
}

bool ScreenTriangle::covers(int x, int y) const noexcept {
  return area_ != 0 && std::all_of(edges_.begin(), edges_.end(), [&](const Edge& edge) { return edge.at(x, y) >= edge.least; });
}

double ScreenTriangle::depth_at(int x, int y) const noexcept {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += static_cast<double>(edges_[k].at(x, y)) * static_cast<double>(corners_[k].depth);
  return sum / static_cast<double>(area_);
}

double ScreenTriangle::depth_error() const noexcept {
  constexpr std::int64_t kFar = 1984 * 256;
  constexpr double kSquare = 64;
  double largest = 1, rise = 0;
  for (const ScreenCorner& corner : corners_) largest = std::max(largest, std::abs(static_cast<double>(corner.depth)));
  const auto [left, right] = std::minmax({corners_[0].x, corners_[1].x, corners_[2].x});
  const auto [top, bottom] = std::minmax({corners_[0].y, corners_[1].y, corners_[2].y});
  if (right - left > kFar || bottom - top > kFar)
    for (std::size_t k = 1; k < 3; ++k) {
      const double per_pixel = 256 * static_cast<double>(std::abs(edges_[k].per_x) + std::abs(edges_[k].per_y)) / static_cast<double>(area_);
      rise += kSquare * per_pixel * std::abs(static_cast<double>(corners_[k].depth) - static_cast<double>(corners_[0].depth));
    }
  return 0x1p-23 * (3 * largest + 2 * rise);
}

Result triangles_of(const Triangle& triangle, const View& view) {
  const Polygon polygon = clipped(triangle, volume_of(view.viewport, view.lowest_z));
  Result result;
  result.is_cut = polygon.is_cut;
  result.is_doubtful = polygon.is_doubtful;
  std::vector<ScreenCorner> corners;
  for (const Corner& corner : polygon.corners)
    corners.push_back(on_screen(position_of(polygon, corner, triangle, result.is_doubtful), view, result.is_doubtful));
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    ++result.fan_triangles;
    const ScreenTriangle one(corners[0], corners[i], corners[i + 1]);
    if (one.area() != 0) result.triangles.push_back(one);
  }
  return result;
}

}  // namespace tuberia::rational
