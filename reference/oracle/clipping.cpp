#include "reference/oracle/clipping.hpp"

#include <algorithm>
#include <cmath>

namespace tuberia::oracle {
namespace {

Corner cut(const Corner& in, double d_in, const Corner& out, double d_out, const ClipPlane& plane) {
  const double s_out = d_in / (d_in - d_out);
  const double s_in = -d_out / (d_in - d_out);
  Corner corner;
  corner.x = s_in * in.x + s_out * out.x;
  corner.y = s_in * in.y + s_out * out.y;
  corner.z = s_in * in.z + s_out * out.z;
  corner.w = s_in * in.w + s_out * out.w;
  for (std::size_t k = 0; k < 3; ++k) corner.weight[k] = s_in * in.weight[k] + s_out * out.weight[k];
  plane.settle(corner);
  return corner;
}

std::vector<Corner> cut_polygon(const std::vector<Corner>& polygon, const ClipPlane& plane) {
  std::vector<Corner> left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner& a = polygon[i];
    const Corner& b = polygon[(i + 1) % polygon.size()];
    const double da = plane.distance(a), db = plane.distance(b);
    if (da >= 0) left.push_back(a);
    if (da > 0 && db < 0) left.push_back(cut(a, da, b, db, plane));
    if (da < 0 && db > 0) left.push_back(cut(b, db, a, da, plane));
  }
  return left;
}

std::vector<Corner> cut_line(const std::vector<Corner>& line, const ClipPlane& plane) {
  const double da = plane.distance(line[0]), db = plane.distance(line[1]);
  if (da >= 0 && db >= 0) return line;
  if (da > 0) return {line[0], cut(line[0], da, line[1], db, plane)};
  if (db > 0) return {cut(line[1], db, line[0], da, plane), line[1]};
  return {};
}

}  // namespace

int Corner::vertex() const {
  for (int k = 0; k < 3; ++k) {
    bool is_it = weight[static_cast<std::size_t>(k)] == 1;
    for (int other = 0; other < 3; ++other)
      if (other != k && weight[static_cast<std::size_t>(other)] != 0) is_it = false;
    if (is_it) return k;
  }
  return -1;
}

bool ClipPlane::is_outside(const ClipVertex& v) const {
  const float g = static_cast<float>(guard), zl = static_cast<float>(lowest_z);
  switch (kind) {
    case Kind::near_plane: return v.z < zl * v.w;
    case Kind::far_plane: return v.z > v.w;
    case Kind::left: return v.x < -g * v.w;
    case Kind::right: return v.x > g * v.w;
    case Kind::bottom: return v.y < -g * v.w;
    case Kind::top: return v.y > g * v.w;
    case Kind::behind: return v.w <= 0;
    case Kind::user: return distance({v.x, v.y, v.z, v.w, {}}) < 0;
  }
  return false;
}

double ClipPlane::distance(const Corner& c) const {
  switch (kind) {
    case Kind::near_plane: return c.z - lowest_z * c.w;
    case Kind::far_plane: return -c.z + c.w;
    case Kind::left: return c.x + guard * c.w;
    case Kind::right: return -c.x + guard * c.w;
    case Kind::bottom: return c.y + guard * c.w;
    case Kind::top: return -c.y + guard * c.w;
    case Kind::behind: return 0;  // never cuts
    case Kind::user: return ((user.x * c.x + user.y * c.y) + user.z * c.z) + user.w * c.w;
  }
  return 0;
}

void ClipPlane::settle(Corner& c) const {
  switch (kind) {
    case Kind::near_plane: c.z = lowest_z * c.w; break;
    case Kind::far_plane: c.z = c.w; break;
    case Kind::left: c.x = -guard * c.w; break;
    case Kind::right: c.x = guard * c.w; break;
    case Kind::bottom: c.y = -guard * c.w; break;
    case Kind::top: c.y = guard * c.w; break;
    case Kind::behind:
    case Kind::user: break;
  }
}

std::vector<ClipPlane> clip_planes(const Draw& draw, const Viewport& viewport) {
  const auto guard = [](int corner, int size) {
    if (size == 0) return 1.0;
    const double half = size / 2.0, centre = corner + half;
    return static_cast<double>(static_cast<float>((32767 - std::abs(centre)) / half));
  };
  const double gx = guard(viewport.x, viewport.width), gy = guard(viewport.y, viewport.height);
  const double zl = draw.volume == ClipVolume::minus_w_to_w ? -1 : 0;
  using Kind = ClipPlane::Kind;
  std::vector<ClipPlane> planes{{Kind::near_plane, zl, 1, {}}, {Kind::far_plane, zl, 1, {}},  {Kind::left, zl, gx, {}},
                                {Kind::right, zl, gx, {}},     {Kind::bottom, zl, gy, {}}, {Kind::top, zl, gy, {}},
                                {Kind::behind, zl, 1, {}}};
  for (const glm::dvec4& plane : draw.user_planes) planes.push_back({Kind::user, zl, 1, plane});
  return planes;
}

std::vector<Corner> clipped(const std::vector<ClipVertex>& vertices, const std::vector<ClipPlane>& planes, bool& was_cut) {
  was_cut = false;
  std::vector<Corner> corners;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const ClipVertex& v = vertices[k];
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z) || !std::isfinite(v.w)) return {};
    corners.push_back({v.x, v.y, v.z, v.w, {}});
    corners.back().weight[k] = 1;
  }
  const auto outside = [&](const ClipPlane& plane) {
    return std::count_if(vertices.begin(), vertices.end(), [&](const ClipVertex& v) { return plane.is_outside(v); });
  };
  for (const ClipPlane& plane : planes)
    if (outside(plane) == static_cast<std::ptrdiff_t>(vertices.size())) return {};
  for (const ClipPlane& plane : planes) {
    if (outside(plane) == 0) continue;
    was_cut = true;
    if (plane.kind == ClipPlane::Kind::behind || corners.empty()) continue;
    corners = vertices.size() == 2 ? cut_line(corners, plane) : cut_polygon(corners, plane);
  }
  if (!was_cut) return corners;
  std::erase_if(corners, [](const Corner& c) { return static_cast<float>(c.w) <= 0; });
  if (corners.size() < vertices.size()) corners.clear();
  return corners;
}

}  // namespace tuberia::oracle
