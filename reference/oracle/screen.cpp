#include "reference/oracle/screen.hpp"

#include <algorithm>
#include <cmath>

#include "reference/oracle/polygon.hpp"

namespace tuberia::oracle {
namespace {

std::int64_t snapped(double pixels, int subpixel_bits) {
  const double steps = std::exp2(subpixel_bits);
  return static_cast<std::int64_t>(std::clamp(std::nearbyint(steps * pixels) * (256 / steps), -0x1p23, 0x1p23));
}

/// Only corners that rounding has left without a place are so far away.
double ndc(float coordinate, double inverse_w) {
  const double quotient = static_cast<double>(coordinate) * inverse_w;
  return std::abs(quotient) <= 1e30 ? quotient : 0;
}

ScreenVertex on_screen(const ClipVertex& v, const Draw& draw, const Viewport& viewport) {
  const double i = 1 / static_cast<double>(v.w);
  const double half_width = viewport.width / 2.0, half_height = viewport.height / 2.0;
  const double n = static_cast<double>(draw.near_depth), f = static_cast<double>(draw.far_depth);
  const bool symmetric = draw.volume == ClipVolume::minus_w_to_w;
  const double sz = symmetric ? (f - n) / 2 : f - n, oz = symmetric ? (n + f) / 2 : n;
  ScreenVertex out;
  out.x = snapped(ndc(v.x, i) * half_width + (viewport.x + half_width), draw.subpixel_bits);
  out.y = snapped(ndc(v.y, i) * -half_height + (viewport.y + half_height), draw.subpixel_bits);
  out.depth = static_cast<float>(ndc(v.z, i) * sz + oz);
  out.w = v.w;
  out.front = v.front;
  out.back = v.back;
  return out;
}

/// A sum in double in vertex order, rounded to float once.
Interval weighted(const Corner& corner, const std::vector<ClipVertex>& vertices, Scalars ClipVertex::*face, std::size_t scalar) {
  double low = 0, high = 0;  // weights are not negative
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const Interval& value = (vertices[k].*face)[scalar];
    if (!value.is_known()) return unknown();
    low = k == 0 ? corner.weight[k] * value.low : low + corner.weight[k] * value.low;
    high = k == 0 ? corner.weight[k] * value.high : high + corner.weight[k] * value.high;
  }
  return {static_cast<double>(static_cast<float>(low)), static_cast<double>(static_cast<float>(high))};
}

/// The vertex at a corner: one of the primitive's own, or a new one.
ClipVertex vertex_at(const Corner& corner, const std::vector<ClipVertex>& vertices, bool has_own_fog) {
  if (const int own = corner.vertex(); own >= 0) return vertices[static_cast<std::size_t>(own)];
  ClipVertex made;
  made.x = static_cast<float>(corner.x);
  made.y = static_cast<float>(corner.y);
  made.z = static_cast<float>(corner.z);
  made.w = static_cast<float>(corner.w);
  for (std::size_t i = 0; i < kScalars; ++i) {
    made.front[i] = weighted(corner, vertices, &ClipVertex::front, i);
    made.back[i] = weighted(corner, vertices, &ClipVertex::back, i);
  }
  if (!has_own_fog)
    made.front[kFogCoordinate] = made.back[kFogCoordinate] = static_cast<double>(made.w);
  return made;
}

Polygon screen_polygon(const std::vector<ClipVertex>& vertices, const Draw& draw, const Viewport& viewport,
                       const std::vector<ClipPlane>& planes, bool& was_cut) {
  Polygon polygon;
  polygon.corners = clipped(vertices, planes, was_cut);
  for (const Corner& corner : polygon.corners)
    polygon.vertices.push_back(on_screen(vertex_at(corner, vertices, draw.has_fog_coordinates || draw.fog.per_vertex), draw, viewport));
  return polygon;
}

/// A primitive whose vertices have been transformed elsewhere; nothing is clipped.
Polygon given_polygon(const Primitive& primitive, const std::vector<ClipVertex>& vertices, const Draw& draw) {
  Polygon polygon;
  for (std::size_t k = 0; k < static_cast<std::size_t>(primitive.corners); ++k) {
    const std::size_t element = primitive.vertex[k];
    const InputVertex& in = draw.vertices[draw.indices.empty() ? element : draw.indices[element]];
    const ClipVertex& v = vertices[k];
    polygon.corners.push_back({});
    polygon.corners.back().weight[k] = 1;
    polygon.vertices.push_back({in.screen_x, in.screen_y, in.screen_depth, in.position.w, v.front, v.back});
  }
  return polygon;
}

}  // namespace

std::int64_t doubled_area(const ScreenVertex& a, const ScreenVertex& b, const ScreenVertex& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

GeometryResult geometry(const Draw& draw, const Viewport& viewport, DepthFormat depth_format) {
  const std::vector<ClipVertex> vertices = transformed(draw);
  const std::vector<ClipPlane> planes = clip_planes(draw, viewport);
  GeometryResult result;
  std::int64_t strip_counter = 0;
  std::uint32_t number = 0;
  for (const Primitive& primitive : assembled(draw.topology, vertices.size())) {
    ++result.assembled;
    std::vector<ClipVertex> own;
    for (int k = 0; k < primitive.corners; ++k) own.push_back(vertices[primitive.vertex[static_cast<std::size_t>(k)]]);
    bool was_cut = false;
    Polygon polygon = draw.space == PositionSpace::screen ? given_polygon(primitive, own, draw)
                                                          : screen_polygon(own, draw, viewport, planes, was_cut);
    if (was_cut) ++result.clipped;
    polygon.own = own;
    polygon.number = number++;
    if (polygon.vertices.empty()) continue;
    result.after_clipping += primitive.corners == 3 ? static_cast<std::int64_t>(polygon.vertices.size()) - 2 : 1;
    if (primitive.corners == 3) add_polygon(polygon, draw, depth_format, result.primitives);
    else if (primitive.corners == 2) add_line(polygon, draw.topology == Topology::lines ? nullptr : &strip_counter, result.primitives);
    else add_point(polygon, result.primitives);
  }
  return result;
}

}  // namespace tuberia::oracle
