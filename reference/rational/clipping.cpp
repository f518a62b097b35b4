#include "reference/rational/clipping.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tuberia::rational {
namespace {

enum class Plane { near, far, left, right, bottom, top, behind };  // in the order of their cuts

bool is_outside(Plane plane, const ClipVertex& v, const Volume& volume) {
  const float zl = static_cast<float>(volume.lowest_z);
  switch (plane) {
    case Plane::near: return v.z < zl * v.w;
    case Plane::far: return v.z > v.w;
    case Plane::left: return v.x < -(volume.guard_x * v.w);
    case Plane::right: return v.x > volume.guard_x * v.w;
    case Plane::bottom: return v.y < -(volume.guard_y * v.w);
    case Plane::top: return v.y > volume.guard_y * v.w;
    case Plane::behind: return v.w <= 0;
  }
  return false;
}

/// factor w - or + coordinate, times what makes it whole: > 0 inside.
Integer beyond(float guard, const Integer& w, const Integer& coordinate) {
  const Dyadic g = dyadic(static_cast<double>(guard));
  const Integer factor = static_cast<long>(g.mantissa);
  if (g.exponent >= 0) return (factor << static_cast<mp_bitcnt_t>(g.exponent)) * w + coordinate;
  return factor * w + (coordinate << static_cast<mp_bitcnt_t>(-g.exponent));
}

/// The signed distance from the plane, up to a factor > 0 that is the same for all corners once each is
/// divided by its divisor.
Integer distance(Plane plane, const Corner& c, const Volume& volume) {
  switch (plane) {
    case Plane::near: return c.z - volume.lowest_z * c.w;
    case Plane::far: return c.w - c.z;
    case Plane::left: return beyond(volume.guard_x, c.w, c.x);
    case Plane::right: return beyond(volume.guard_x, c.w, -c.x);
    case Plane::bottom: return beyond(volume.guard_y, c.w, c.y);
    case Plane::top: return beyond(volume.guard_y, c.w, -c.y);
    case Plane::behind: break;  // never cuts
  }
  return 0;
}

/// The bounds of double arithmetic: a rounding errs by at most 2^-53 of its result.
constexpr double kRounding = 0x1p-52;

/// A plane as the contract computes with it: inside where sign * coordinate + factor * w >= 0.
struct ComputedPlane {
  std::size_t axis;
  double sign, factor;
};
ComputedPlane computed_plane(Plane plane, const Volume& volume) {
  const double gx = static_cast<double>(volume.guard_x), gy = static_cast<double>(volume.guard_y);
  switch (plane) {
    case Plane::near: return {2, 1, static_cast<double>(-volume.lowest_z)};
    case Plane::far: return {2, -1, 1};
    case Plane::left: return {0, 1, gx};
    case Plane::right: return {0, -1, gx};
    case Plane::bottom: return {1, 1, gy};
    case Plane::top: return {1, -1, gy};
    case Plane::behind: break;
  }
  return {0, 0, 0};
}

/// The distance: one product and one sum. Of a vertex, whose coordinates are floats, the product is exact.
Estimate computed_distance(const ComputedPlane& plane, const Corner& c) {
  const Estimate &p = c.computed[plane.axis], &w = c.computed[3];
  const double value = plane.sign * p.value + plane.factor * w.value;
  const double product_error = c.vertex >= 0 ? 0 : kRounding * std::abs(plane.factor * w.value);
  return {value, p.error + plane.factor * w.error + product_error + kRounding * std::abs(value)};
}

/// A coordinate of a new corner as the contract computes it: two shares, two products and a sum.
Estimate computed_crossing(const Estimate& in, const Estimate& d_in, const Estimate& out, const Estimate& d_out) {
  const double whole = d_in.value - d_out.value, share_out = d_in.value / whole, share_in = -d_out.value / whole;
  const double share_error = std::abs(share_in * share_out) * (d_in.error / std::abs(d_in.value) + d_out.error / std::abs(d_out.value));
  const double of_in = share_in * in.value, of_out = share_out * out.value;
  return {of_in + of_out, share_error * std::abs(in.value - out.value) + std::abs(share_in) * in.error + std::abs(share_out) * out.error +
                              4 * kRounding * (std::abs(of_in) + std::abs(of_out))};
}

/// Where the edge from a corner inside to one outside meets the plane. With P = V / D and distances n / D
/// it is (n1 P2 / D1 - n2 P1 / D2) / (n1 / D1 - n2 / D2) = (n1 V2 - n2 V1) / (n1 D2 - n2 D1).
struct Distance {
  Integer exact;
  Estimate computed;
};
Corner crossing(const ComputedPlane& plane, const Corner& inside, const Distance& d_inside, const Corner& outside,
                const Distance& d_outside) {
  const auto mixed = [&](Integer Corner::*of) { return Integer(d_inside.exact * outside.*of - d_outside.exact * inside.*of); };
  Corner corner{mixed(&Corner::x), mixed(&Corner::y), mixed(&Corner::z), mixed(&Corner::w), mixed(&Corner::divisor)};
  for (std::size_t i = 0; i < 4; ++i)
    corner.computed[i] = computed_crossing(inside.computed[i], d_inside.computed, outside.computed[i], d_outside.computed);
  // The contract then puts it on the plane.
  const Estimate& w = corner.computed[3];
  corner.computed[plane.axis] = {-plane.sign * plane.factor * w.value, plane.factor * (w.error + kRounding * std::abs(w.value))};
  return corner;
}

void cut_by(Plane plane, const Volume& volume, Polygon& polygon) {
  const std::vector<Corner>& corners = polygon.corners;
  const ComputedPlane computed = computed_plane(plane, volume);
  std::vector<Distance> d;
  for (const Corner& corner : corners) {
    d.push_back({distance(plane, corner, volume), computed_distance(computed, corner)});
    // Of a vertex the sign is right: a correctly rounded sum has the sign of the exact one.
    if (corner.vertex < 0 && !(std::abs(d.back().computed.value) > d.back().computed.error)) polygon.is_doubtful = true;
  }
  std::vector<Corner> left;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = (i + 1) % corners.size();
    const int here = sgn(d[i].exact), there = sgn(d[next].exact);
    if (here >= 0) left.push_back(corners[i]);
    if (here > 0 && there < 0) left.push_back(crossing(computed, corners[i], d[i], corners[next], d[next]));
    if (here < 0 && there > 0) left.push_back(crossing(computed, corners[next], d[next], corners[i], d[i]));
  }
  polygon.corners = std::move(left);
}

/// The power of two of which all coordinates are multiples.
int common_unit(const Triangle& triangle) {
  int unit = std::numeric_limits<int>::max();
  for (const ClipVertex& v : triangle)
    for (const float value : {v.x, v.y, v.z, v.w})
      if (value != 0) unit = std::min(unit, dyadic(static_cast<double>(value)).exponent);
  return unit == std::numeric_limits<int>::max() ? 0 : unit;
}

std::vector<Corner> corners_of(const Triangle& triangle, int unit) {
  std::vector<Corner> corners;
  for (int k = 0; k < 3; ++k) {
    const ClipVertex& v = triangle[static_cast<std::size_t>(k)];
    const auto whole = [&](float value) { return in_units(dyadic(static_cast<double>(value)), unit); };
    const auto exact = [](float value) { return Estimate{static_cast<double>(value), 0}; };
    corners.push_back({whole(v.x), whole(v.y), whole(v.z), whole(v.w), 1, k, {exact(v.x), exact(v.y), exact(v.z), exact(v.w)}});
  }
  return corners;
}

float guard(int corner, int size) {
  if (size == 0) return 1;
  const double half = size / 2.0;
  return static_cast<float>((32767 - std::abs(corner + half)) / half);
}

}  // namespace

Volume volume_of(const Viewport& v, int lowest_z) noexcept { return {guard(v.x, v.width), guard(v.y, v.height), lowest_z}; }

Polygon clipped(const Triangle& triangle, const Volume& volume) {
  constexpr Plane kPlanes[] = {Plane::near, Plane::far, Plane::left, Plane::right, Plane::bottom, Plane::top, Plane::behind};
  const auto is_finite = [](const ClipVertex& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w); };
  if (!std::all_of(triangle.begin(), triangle.end(), is_finite)) return {};

  int outside[std::size(kPlanes)] = {};
  Polygon polygon;
  for (std::size_t p = 0; p < std::size(kPlanes); ++p) {
    for (const ClipVertex& v : triangle) outside[p] += is_outside(kPlanes[p], v, volume) ? 1 : 0;
    if (outside[p] == 3) return {};
    polygon.is_cut = polygon.is_cut || outside[p] > 0;
  }
  polygon.unit = common_unit(triangle);
  polygon.corners = corners_of(triangle, polygon.unit);
  if (!polygon.is_cut) return polygon;

  for (std::size_t p = 0; p < std::size(kPlanes); ++p)
    if (outside[p] > 0 && kPlanes[p] != Plane::behind) cut_by(kPlanes[p], volume, polygon);
  std::erase_if(polygon.corners, [&](const Corner& c) {
    const auto [w, error] = c.computed[3];
    if ((static_cast<float>(w - error) > 0) != (static_cast<float>(w + error) > 0)) polygon.is_doubtful = true;
    return nearest_float(quotient(polygon, c, &Corner::w)) <= 0;
  });
  if (polygon.corners.size() < 3) polygon.corners.clear();
  return polygon;
}

}  // namespace tuberia::rational
