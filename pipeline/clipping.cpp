#include "pipeline/clipping.hpp"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <tuple>

#include "math/fixed_point.hpp"

namespace tuberia {
namespace {

/// Inside where factor * position[axis] + w_factor * w >= 0; of the user's planes, where the product
/// with all four coordinates is.
struct Plane {
  std::uint32_t bit;
  int axis;
  double factor, w_factor;
  const double* user = nullptr;
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

double user_distance(const double* plane, const double* p) {
  return ((plane[0] * p[0] + plane[1] * p[1]) + plane[2] * p[2]) + plane[3] * p[3];
}

double distance(const Plane& plane, const ClippedCorner& c) {
  if (plane.user != nullptr) return user_distance(plane.user, c.position);
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
  if (plane.user == nullptr) c.position[plane.axis] = -plane.factor * plane.w_factor * c.position[3];
  return c;
}

/// Calls visit(plane) for the planes named, in the order of their cuts.
template <class Visit>
void for_each_plane(std::uint32_t planes, const ClipLimits& limits, Visit&& visit) {
  for (const Plane& plane : planes_of(limits))
    if ((planes & plane.bit) != 0) visit(plane);
  for (int k = 0; k < limits.user_plane_count; ++k)
    if ((planes & outcode::user << k) != 0) visit(Plane{outcode::user << k, 0, 0, 0, limits.user_planes[k]});
}

/// Sutherland and Hodgman: one plane after the other, each walking round the polygon once.
void cut_by(const Plane& plane, const ClippedPolygon& from, ClippedPolygon& to) {
  to.count = 0;
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
}

/// Whether the corner's w is positive as the float that it will become.
bool has_w(const ClippedCorner& corner) { return static_cast<float>(corner.position[3]) > 0; }

/// The one point with w = 0 that all planes let pass is (0, 0, 0, 0): it has no place on the
/// screen, and its two edges project to the two neighbours, so leaving it out changes nothing.
void drop_corners_without_w(ClippedPolygon& polygon) {
  const auto end = std::remove_if(polygon.corner.begin(), polygon.corner.begin() + polygon.count,
                                  [](const ClippedCorner& c) { return !has_w(c); });
  polygon.count = static_cast<int>(end - polygon.corner.begin());
}

std::array<double, 4> position_of(const VertexBatch& vertices, std::uint32_t slot) {
  return {static_cast<double>(vertices.clip_x[slot]), static_cast<double>(vertices.clip_y[slot]),
          static_cast<double>(vertices.clip_z[slot]), static_cast<double>(vertices.clip_w[slot])};
}

/// Which of the primitive's own vertices a corner is; -1 for none. (A share of 1 alone does not make
/// it one: it may have been rounded, and little of a far vertex is much.)
int own_vertex(const ClippedCorner& corner) {
  const auto whole = std::find(corner.weight, corner.weight + 3, 1.0);
  return whole != corner.weight + 3 && std::count(corner.weight, corner.weight + 3, 0.0) == 2 ? static_cast<int>(whole - corner.weight) : -1;
}

/// The slot of a corner: one that was a vertex keeps its slot, and with it every bit of its place.
std::uint32_t slot_of(const ClippedCorner& corner, std::span<const std::uint32_t> slot, VertexBatch& vertices) {
  if (const int own = own_vertex(corner); own >= 0) return slot[static_cast<std::size_t>(own)];
  const auto number = static_cast<std::size_t>(vertices.size());
  vertices.clipped.push_back({{slot.front(), slot[1], slot.back()}, {corner.weight[0], corner.weight[1], corner.weight[2]},
                              static_cast<int>(slot.size())});
  const std::size_t padded = number + 1 + kKernelPadding;
  AlignedVector<float>* arrays[4] = {&vertices.clip_x, &vertices.clip_y, &vertices.clip_z, &vertices.clip_w};
  for (std::size_t k = 0; k < 4; ++k) {
    arrays[k]->resize(padded);
    (*arrays[k])[number] = static_cast<float>(corner.position[k]);
  }
  return static_cast<std::uint32_t>(number);
}

/// Adds a polygon's fan, and to `polygons`, if there are any, the polygon itself.
void add_polygon(const ClippedPolygon& polygon, const ClippedTriangle& triangle, VertexBatch& vertices, TriangleBatch& out,
                 PolygonBatch* polygons) {
  if (polygon.count == 0) return;
  std::array<std::uint32_t, std::tuple_size_v<decltype(polygon.corner)>> corner_slot{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i)
    corner_slot[i] = slot_of(polygon.corner[i], triangle.slot, vertices);
  for (std::size_t i = 1; i + 1 < static_cast<std::size_t>(polygon.count); ++i)
    out.add(corner_slot[0], corner_slot[i], corner_slot[i + 1], triangle.provoking, triangle.primitive);
  if (polygons == nullptr) return;

  ClippedTriangle& added = polygons->polygons.emplace_back(triangle);
  added.first_corner = static_cast<std::uint32_t>(polygons->corners.size());
  added.corner_count = static_cast<std::uint32_t>(polygon.count);
  for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i) {
    const ClippedCorner& corner = polygon.corner[i];
    unsigned zero = 0;
    for (unsigned k = 0; k < 3; ++k) zero |= corner.weight[k] == 0 ? 1u << k : 0u;
    polygons->corners.push_back({corner_slot[i], static_cast<std::uint8_t>(zero), static_cast<std::int8_t>(own_vertex(corner))});
  }
}

void add_whole(const ClippedTriangle& triangle, TriangleBatch& out, PolygonBatch* polygons) {
  out.add(triangle.slot[0], triangle.slot[1], triangle.slot[2], triangle.provoking, triangle.primitive);
  if (polygons == nullptr) return;
  ClippedTriangle& added = polygons->polygons.emplace_back(triangle);
  added.first_corner = static_cast<std::uint32_t>(polygons->corners.size());
  added.corner_count = 3;
  for (int k = 0; k < 3; ++k)
    polygons->corners.push_back({triangle.slot[k], static_cast<std::uint8_t>(7 ^ 1 << k), static_cast<std::int8_t>(k)});
}

}  // namespace

ClipLimits clip_limits(const Viewport& viewport, ClipVolume volume) noexcept {
  // One pixel of reserve keeps the rounding of the guard plane itself inside.
  const auto guard = [](int origin, int size) {
    if (size <= 0) return 1.0f;
    const double half = 0.5 * size, centre = origin + half;
    return static_cast<float>((kGuardBandPixels - 1 - std::abs(centre)) / half);
  };
  ClipLimits limits;
  limits.guard_x = guard(viewport.x, viewport.width_pixels);
  limits.guard_y = guard(viewport.y, viewport.height_pixels);
  limits.z_low = volume == ClipVolume::minus_w_to_w ? -1.0f : 0.0f;
  return limits;
}

ClipLimits clip_limits(const Viewport& viewport, const ClippingState& state) noexcept {
  static_assert(ClipLimits::kMaxUserPlanes == ClippingState::kMaxUserPlanes);
  ClipLimits limits = clip_limits(viewport, state.volume);
  limits.user_plane_count = state.user_plane_count;
  for (int k = 0; k < state.user_plane_count; ++k)
    for (int i = 0; i < 4; ++i) limits.user_planes[k][i] = state.user_planes[static_cast<std::size_t>(k)][i];
  return limits;
}

std::uint32_t outcode_of(const glm::vec4& p, const ClipLimits& limits) noexcept {
  const float bound_x = p.w * limits.guard_x, bound_y = p.w * limits.guard_y;
  const bool finite = std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
  return (p.x < -bound_x ? outcode::left : 0) | (p.x > bound_x ? outcode::right : 0) |
         (p.y < -bound_y ? outcode::bottom : 0) | (p.y > bound_y ? outcode::top : 0) |
         (p.z < p.w * limits.z_low ? outcode::near : 0) | (p.z > p.w ? outcode::far : 0) |
         (p.w <= 0 ? outcode::behind : 0) | (finite ? 0 : outcode::invalid) | user_outcode_of(p, limits);
}

std::uint32_t user_outcode_of(const glm::vec4& p, const ClipLimits& limits) noexcept {
  const double position[4] = {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z), static_cast<double>(p.w)};
  std::uint32_t code = 0;
  for (int k = 0; k < limits.user_plane_count; ++k)
    if (user_distance(limits.user_planes[k], position) < 0) code |= outcode::user << k;
  return code;
}

glm::dvec4 clip_plane_from_world(const glm::dvec4& world_plane, const glm::mat4& clip_from_world) noexcept {
  // plane . world = plane . (world_from_clip clip): the transpose of the inverse acts on planes.
  return glm::transpose(glm::inverse(glm::dmat4(clip_from_world))) * world_plane;
}


ClippedPolygon clip_triangle(std::span<const std::array<double, 4>, 3> triangle, std::uint32_t planes,
                             const ClipLimits& limits) noexcept {
  ClippedPolygon polygons[2];  // by turns before and after a cut
  int now = 0;
  polygons[0].count = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    std::copy(triangle[i].begin(), triangle[i].end(), polygons[0].corner[i].position);
    for (std::size_t k = 0; k < 3; ++k) polygons[0].corner[i].weight[k] = i == k ? 1 : 0;
  }
  for_each_plane(planes, limits, [&](const Plane& plane) {
    cut_by(plane, polygons[now], polygons[1 - now]);
    now = 1 - now;
  });
  drop_corners_without_w(polygons[now]);
  ClippedPolygon result;
  result.count = polygons[now].count < 3 ? 0 : polygons[now].count;
  std::copy_n(polygons[now].corner.begin(), result.count, result.corner.begin());
  return result;
}

ClippedLine clip_line(std::span<const std::array<double, 4>, 2> line, std::uint32_t planes, const ClipLimits& limits) noexcept {
  ClippedLine result;
  ClippedCorner (&end)[2] = result.corner;
  for (std::size_t i = 0; i < 2; ++i) {
    std::copy(line[i].begin(), line[i].end(), end[i].position);
    for (std::size_t k = 0; k < 3; ++k) end[i].weight[k] = i == k ? 1 : 0;
  }
  for_each_plane(planes, limits, [&](const Plane& plane) {
    const double da = distance(plane, end[0]), db = distance(plane, end[1]);
    if (result.is_empty || (da >= 0 && db >= 0)) return;
    if (da <= 0 && db <= 0) result.is_empty = true;
    else if (da < 0) end[0] = cut(plane, end[1], db, end[0], da);
    else end[1] = cut(plane, end[0], da, end[1], db);
  });
  result.is_empty |= !(has_w(end[0]) && has_w(end[1]));
  return result;
}

int Clipping::operator()(VertexBatch& vertices, TriangleBatch& triangles) const { return clip_all(vertices, triangles, nullptr); }

int Clipping::operator()(VertexBatch& vertices, TriangleBatch& triangles, PolygonBatch& polygons) const {
  polygons.clear();
  return clip_all(vertices, triangles, &polygons);
}

int Clipping::clip_all(VertexBatch& vertices, TriangleBatch& triangles, PolygonBatch* polygons) const {
  // Most chunks lie wholly inside.
  std::uint32_t any = 0;
  for (std::size_t i = 0; i < vertices.source.size(); ++i) any |= vertices.outcode[i];
  if (any == 0 && polygons == nullptr) return 0;

  TriangleBatch out;
  int cut_count = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(triangles.count); ++i) {
    const ClippedTriangle triangle{{triangles.v0[i], triangles.v1[i], triangles.v2[i]}, triangles.provoking[i], triangles.primitive[i], 0, 0};
    const std::uint32_t a = vertices.outcode[triangle.slot[0]], b = vertices.outcode[triangle.slot[1]], c = vertices.outcode[triangle.slot[2]];
    const std::uint32_t crossed = a | b | c;
    if (crossed == 0) {
      add_whole(triangle, out, polygons);
      continue;
    }
    if ((crossed & outcode::invalid) != 0 || (a & b & c) != 0) continue;

    std::array<std::array<double, 4>, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = position_of(vertices, triangle.slot[k]);
    add_polygon(clip_triangle(corners, crossed, limits_), triangle, vertices, out, polygons);
    ++cut_count;
  }
  triangles = std::move(out);
  return cut_count;
}

int Clipping::operator()(VertexBatch& vertices, LineBatch& lines) const {
  int cut_count = 0;
  std::size_t kept = 0;
  for (AssembledLine line : lines) {
    const std::uint32_t a = vertices.outcode[line.v0], b = vertices.outcode[line.v1], crossed = a | b;
    if ((crossed & outcode::invalid) != 0 || (a & b) != 0) continue;
    if (crossed != 0) {
      ++cut_count;
      const std::array<std::uint32_t, 2> slot{line.v0, line.v1};
      const std::array<std::array<double, 4>, 2> ends{position_of(vertices, slot[0]), position_of(vertices, slot[1])};
      const ClippedLine rest = clip_line(ends, crossed, limits_);
      if (rest.is_empty) continue;
      line.v0 = slot_of(rest.corner[0], slot, vertices);
      line.v1 = slot_of(rest.corner[1], slot, vertices);
    }
    lines[kept++] = line;
  }
  lines.resize(kept);
  return cut_count;
}

int Clipping::operator()(const VertexBatch& vertices, PointBatch& points) const {
  std::erase_if(points, [&](const AssembledPoint& point) { return vertices.outcode[point.vertex] != 0; });
  return 0;
}

}  // namespace tuberia
