#include "pipeline/clipping.hpp"

#include <algorithm>
#include <cmath>

#include "math/fixed_point.hpp"

namespace tuberia {
namespace {

/// Inside where factor[axis] * position + w_factor * w >= 0.
struct Plane {
  std::uint32_t bit;
  int axis;
  double factor, w_factor;
};

std::array<Plane, 6> planes_of(const ClipLimits& limits) {
  // near with z_low 0 is z >= 0, with -1 it is z + w >= 0.
  return {{{outcode::near, 2, 1, -static_cast<double>(limits.z_low)},
           {outcode::far, 2, -1, 1},
           {outcode::left, 0, 1, static_cast<double>(limits.guard_x)},
           {outcode::right, 0, -1, static_cast<double>(limits.guard_x)},
           {outcode::bottom, 1, 1, static_cast<double>(limits.guard_y)},
           {outcode::top, 1, -1, static_cast<double>(limits.guard_y)}}};
}

double distance(const Plane& plane, const ClippedCorner& c) {
  return plane.factor * c.position[plane.axis] + plane.w_factor * c.position[3];
}

/// Where the way from a corner inside to one outside meets the plane.
ClippedCorner cut(const Plane& plane, const ClippedCorner& inside, double d_inside, const ClippedCorner& outside,
                  double d_outside) {
  // Two shares and not inside + t * (outside - inside): one end may be so far away that the other is
  // lost in their difference.
  const double share_outside = d_inside / (d_inside - d_outside), share_inside = -d_outside / (d_inside - d_outside);
  ClippedCorner c;
  for (int i = 0; i < 4; ++i) c.position[i] = share_inside * inside.position[i] + share_outside * outside.position[i];
  for (int i = 0; i < 3; ++i) c.weight[i] = share_inside * inside.weight[i] + share_outside * outside.weight[i];
  // On the plane exactly, whatever the rounding: otherwise large triangles lose the screen.
  c.position[plane.axis] = -plane.factor * plane.w_factor * c.position[3];
  return c;
}

/// Sutherland and Hodgman: one plane after the other, each walking round the polygon once.
ClippedPolygon cut_by(const Plane& plane, const ClippedPolygon& from) {
  ClippedPolygon to;
  for (int i = 0; i < from.count; ++i) {
    const ClippedCorner& a = from.corner[static_cast<std::size_t>(i)];
    const ClippedCorner& b = from.corner[static_cast<std::size_t>((i + 1) % from.count)];
    const double da = distance(plane, a), db = distance(plane, b);
    const auto add = [&](const ClippedCorner& c) {
      if (to.count < static_cast<int>(to.corner.size())) to.corner[static_cast<std::size_t>(to.count++)] = c;
    };
    if (da >= 0) add(a);
    // A corner on the plane is its own cut.
    if (da > 0 && db < 0) add(cut(plane, a, da, b, db));
    if (da < 0 && db > 0) add(cut(plane, b, db, a, da));
  }
  return to;
}

/// The one point with w = 0 that all planes let pass is (0, 0, 0, 0): it has no place on the
/// screen, and its two edges project to the two neighbours, so leaving it out changes nothing.
void drop_corners_without_w(ClippedPolygon& polygon) {
  const auto end = std::remove_if(polygon.corner.begin(), polygon.corner.begin() + polygon.count,
                                  [](const ClippedCorner& c) { return !(c.position[3] > 0); });
  polygon.count = static_cast<int>(end - polygon.corner.begin());
}

}  // namespace

ClipLimits clip_limits(const Viewport& viewport, ClipVolume volume) noexcept {
  // One pixel of reserve keeps the rounding of the guard plane itself inside.
  const auto guard = [](int origin, int size) {
    if (size <= 0) return 1.0f;
    const double half = 0.5 * size, centre = origin + half;
    return static_cast<float>((kGuardBandPixels - 1 - std::abs(centre)) / half);
  };
  return {.guard_x = guard(viewport.x, viewport.width_pixels),
          .guard_y = guard(viewport.y, viewport.height_pixels),
          .z_low = volume == ClipVolume::minus_w_to_w ? -1.0f : 0.0f};
}

ClippedPolygon clip_triangle(std::span<const std::array<double, 4>, 3> triangle, std::uint32_t planes,
                             const ClipLimits& limits) noexcept {
  ClippedPolygon polygon;
  polygon.count = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    std::copy(triangle[i].begin(), triangle[i].end(), polygon.corner[i].position);
    for (std::size_t k = 0; k < 3; ++k) polygon.corner[i].weight[k] = i == k ? 1 : 0;
  }
  for (const Plane& plane : planes_of(limits))
    if ((planes & plane.bit) != 0) polygon = cut_by(plane, polygon);
  drop_corners_without_w(polygon);
  if (polygon.count < 3) polygon.count = 0;
  return polygon;
}

int Clipping::operator()(VertexBatch& vertices, TriangleBatch& triangles) const {
  // Most chunks lie wholly inside.
  std::uint32_t any = 0;
  for (std::size_t i = 0; i < vertices.source.size(); ++i) any |= vertices.outcode[i];
  if (any == 0) return 0;

  TriangleBatch out;
  int cut_count = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(triangles.count); ++i) {
    const std::uint32_t slot[3] = {triangles.v0[i], triangles.v1[i], triangles.v2[i]};
    const std::uint32_t a = vertices.outcode[slot[0]], b = vertices.outcode[slot[1]], c = vertices.outcode[slot[2]];
    const std::uint32_t crossed = a | b | c;
    if (crossed == 0) {
      out.add(slot[0], slot[1], slot[2], triangles.provoking[i], triangles.primitive[i]);
      continue;
    }
    if ((crossed & outcode::invalid) != 0 || (a & b & c) != 0) continue;

    std::array<std::array<double, 4>, 3> corners;
    for (std::size_t k = 0; k < 3; ++k)
      corners[k] = {static_cast<double>(vertices.clip_x[slot[k]]), static_cast<double>(vertices.clip_y[slot[k]]),
                    static_cast<double>(vertices.clip_z[slot[k]]), static_cast<double>(vertices.clip_w[slot[k]])};
    add_polygon(clip_triangle(corners, crossed, limits_), slot, triangles.provoking[i], triangles.primitive[i], vertices, out);
    ++cut_count;
  }
  triangles = std::move(out);
  return cut_count;
}

void Clipping::add_polygon(const ClippedPolygon& polygon, const std::uint32_t (&slot)[3], std::uint32_t provoking,
                           std::uint32_t primitive, VertexBatch& vertices, TriangleBatch& out) const {
  if (polygon.count == 0) return;
  std::array<std::uint32_t, 9> corner_slot{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i) {
    const ClippedCorner& corner = polygon.corner[i];
    // A corner that was a vertex keeps its slot, and with it every bit of its place. (A share of 1
    // alone does not make it one: it may have been rounded, and little of a far vertex is much.)
    const auto whole = std::find(corner.weight, corner.weight + 3, 1.0);
    if (whole != corner.weight + 3 && std::count(corner.weight, corner.weight + 3, 0.0) == 2) {
      corner_slot[i] = slot[whole - corner.weight];
      continue;
    }
    const auto number = static_cast<std::size_t>(vertices.size());
    corner_slot[i] = static_cast<std::uint32_t>(number);
    vertices.clipped.push_back({{slot[0], slot[1], slot[2]}, {corner.weight[0], corner.weight[1], corner.weight[2]}});
    const std::size_t padded = number + 1 + kKernelPadding;
    AlignedVector<float>* arrays[4] = {&vertices.clip_x, &vertices.clip_y, &vertices.clip_z, &vertices.clip_w};
    for (std::size_t k = 0; k < 4; ++k) {
      arrays[k]->resize(padded);
      (*arrays[k])[number] = static_cast<float>(corner.position[k]);
    }
  }
  for (std::size_t i = 1; i + 1 < static_cast<std::size_t>(polygon.count); ++i)
    out.add(corner_slot[0], corner_slot[i], corner_slot[i + 1], provoking, primitive);
}

}  // namespace tuberia
