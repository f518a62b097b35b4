#include "pipeline/cutting.hpp"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

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
template <class Add>
void walk_round(const Plane& plane, std::span<const ClippedCorner> corners, const Add& add) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ClippedCorner& a = corners[i];
    const ClippedCorner& b = corners[(i + 1) % corners.size()];
    const double da = distance(plane, a), db = distance(plane, b);
    if (da >= 0) add(a);
    // A corner on the plane is its own cut.
    if (da > 0 && db < 0) add(cut(plane, a, da, b, db));
    if (da < 0 && db > 0) add(cut(plane, b, db, a, da));
  }
}

void cut_by(const Plane& plane, const ClippedPolygon& from, ClippedPolygon& to) {
  to.count = 0;
  walk_round(plane, {from.corner.data(), static_cast<std::size_t>(from.count)}, [&](const ClippedCorner& c) {
    if (to.count < static_cast<int>(to.corner.size())) to.corner[static_cast<std::size_t>(to.count++)] = c;
  });
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

std::vector<glm::dvec4> clip_polygon(std::span<const glm::dvec4> corners, const ClipLimits& limits) {
  std::vector<ClippedCorner> polygon, cut_polygon;
  for (const glm::dvec4& p : corners) polygon.push_back({{p.x, p.y, p.z, p.w}, {0, 0, 0}});
  for_each_plane(~0u, limits, [&](const Plane& plane) {
    cut_polygon.clear();
    walk_round(plane, polygon, [&](const ClippedCorner& c) { cut_polygon.push_back(c); });
    polygon.swap(cut_polygon);
  });
  std::vector<glm::dvec4> result;
  for (const ClippedCorner& c : polygon)
    if (has_w(c)) result.push_back({c.position[0], c.position[1], c.position[2], c.position[3]});
  if (result.size() < 3) result.clear();
  return result;
}

}  // namespace tuberia
