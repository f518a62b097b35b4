#include "reference/oracle/polygon.hpp"

#include <algorithm>
#include <cmath>

namespace tuberia::oracle {
namespace {

using Kind = ScreenPrimitive::Kind;

/// The fan's triangle i of a polygon is its corners 0, i and i + 1, i = 1..corners-2.
std::int64_t fan_area(const Polygon& polygon, std::size_t i) {
  return doubled_area(polygon.vertices[0], polygon.vertices[i], polygon.vertices[i + 1]);
}

bool is_front(std::int64_t area, const Draw& draw) {
  if (area == 0) return false;
  return (area > 0) == (draw.front_face == Winding::clockwise);
}

bool is_culled(bool front, const Draw& draw) { return draw.cull == (front ? CullFace::front : CullFace::back); }

/// The smallest difference of depths that the format resolves near the triangle's.
double resolution(DepthFormat format, double largest_depth) {
  if (format == DepthFormat::d16) return 0x1p-16;
  if (format == DepthFormat::d24) return 0x1p-24;
  const int exponent = largest_depth == 0 ? -126 : std::max(std::ilogb(largest_depth), -126);
  return std::ldexp(1.0, exponent - 23);
}

/// The bias of the fan's triangle i; without one (i = 0) of a polygon without slope.
double polygon_bias(const Polygon& polygon, std::size_t i, const Draw& draw, DepthFormat format) {
  const PolygonOffset& offset = draw.polygon_offset;
  const ScreenVertex& a = polygon.vertices[0];
  const ScreenVertex& b = polygon.vertices[i == 0 ? 1 : i];
  const ScreenVertex& c = polygon.vertices[i == 0 ? 2 : i + 1];
  const double z0 = static_cast<double>(a.depth), z1 = static_cast<double>(b.depth), z2 = static_cast<double>(c.depth);
  const auto d = [](std::int64_t difference) { return static_cast<double>(difference); };
  double steepest = 0;
  if (i != 0) {
    const double area = d(fan_area(polygon, i));
    const double dzdx = ((z1 - z0) * d(c.y - a.y) - (z2 - z0) * d(b.y - a.y)) / area * 256;
    const double dzdy = ((z2 - z0) * d(b.x - a.x) - (z1 - z0) * d(c.x - a.x)) / area * 256;
    steepest = std::max(std::abs(dzdx), std::abs(dzdy));
  }
  double bias = 0;
  if (offset.factor != 0) bias += static_cast<double>(offset.factor) * steepest;
  if (offset.units != 0)
    bias += static_cast<double>(offset.units) * resolution(format, std::max({std::abs(z0), std::abs(z1), std::abs(z2)}));
  if (offset.clamp > 0) bias = std::min(bias, static_cast<double>(offset.clamp));
  if (offset.clamp < 0) bias = std::max(bias, static_cast<double>(offset.clamp));
  return bias;
}

ScreenPrimitive primitive_of(Kind kind, const Polygon& polygon, bool back, double bias) {
  ScreenPrimitive out;
  out.kind = kind;
  out.provoking = back ? polygon.own[0].back : polygon.own[0].front;
  out.is_back = back;
  out.bias = bias;
  out.number = polygon.number;
  return out;
}

void add_fan(const Polygon& polygon, std::size_t i, bool front, const Draw& draw, DepthFormat format,
             std::vector<ScreenPrimitive>& out) {
  const double bias = draw.polygon_offset.fill ? polygon_bias(polygon, i, draw, format) : 0;
  out.push_back(primitive_of(Kind::triangle, polygon, !front, bias));
  out.back().vertex = {polygon.vertices[0], polygon.vertices[i], polygon.vertices[i + 1]};
}

/// Adds a line between two corners; the counter moves on along its major axis.
void add_edge(const ScreenPrimitive& like, const ScreenVertex& a, const ScreenVertex& b, std::int64_t* counter,
              std::vector<ScreenPrimitive>& out) {
  out.push_back(like);
  out.back().vertex = {a, b, a};
  if (counter == nullptr) return;
  out.back().stipple_start = *counter;
  const auto pixel = [](std::int64_t units) { return (units - (units % 256 + 256) % 256) / 256; };
  const bool x_major = std::abs(b.x - a.x) >= std::abs(b.y - a.y);
  *counter += x_major ? std::abs(pixel(b.x) - pixel(a.x)) : std::abs(pixel(b.y) - pixel(a.y));
}

/// Whether the edge that begins at the primitive's vertex k is to be drawn.
bool has_flag(const Polygon& polygon, std::size_t k, const Draw& draw) {
  return draw.topology != Topology::triangles || polygon.own[k].edge_flag;
}

void add_outline(const Polygon& polygon, const ScreenPrimitive& like, const Draw& draw, std::vector<ScreenPrimitive>& out) {
  std::int64_t counter = 0;
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const std::size_t next = (i + 1) % polygon.corners.size();
    bool is_drawn = false;
    for (std::size_t k = 0; k < 3; ++k)
      if (polygon.corners[i].weight[k] == 0 && polygon.corners[next].weight[k] == 0 && has_flag(polygon, (k + 1) % 3, draw))
        is_drawn = true;
    if (is_drawn) add_edge(like, polygon.vertices[i], polygon.vertices[next], &counter, out);
  }
}

void add_corners(const Polygon& polygon, const ScreenPrimitive& like, const Draw& draw, std::vector<ScreenPrimitive>& out) {
  for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
    const int k = polygon.corners[i].vertex();
    if (k < 0 || !has_flag(polygon, static_cast<std::size_t>(k), draw)) continue;
    out.push_back(like);
    out.back().vertex[0] = polygon.vertices[i];
  }
}

}  // namespace

void add_point(const Polygon& polygon, std::vector<ScreenPrimitive>& out) {
  out.push_back(primitive_of(Kind::point, polygon, false, 0));
  out.back().vertex[0] = polygon.vertices[0];
}

void add_line(const Polygon& polygon, std::int64_t* stipple_counter, std::vector<ScreenPrimitive>& out) {
  add_edge(primitive_of(Kind::line, polygon, false, 0), polygon.vertices[0], polygon.vertices[1], stipple_counter, out);
}

void add_polygon(const Polygon& polygon, const Draw& draw, DepthFormat format, std::vector<ScreenPrimitive>& out) {
  const std::size_t triangles = polygon.vertices.size() - 2;
  const bool always_filled = draw.front_mode == PolygonMode::fill && draw.back_mode == PolygonMode::fill;
  if (always_filled) {
    for (std::size_t i = 1; i <= triangles; ++i) {
      const std::int64_t area = fan_area(polygon, i);
      const bool front = is_front(area, draw);
      if (area != 0 && !is_culled(front, draw)) add_fan(polygon, i, front, draw, format, out);
    }
    return;
  }
  std::int64_t area = 0;
  std::size_t first_with_area = 0;
  for (std::size_t i = triangles; i >= 1; --i) {
    area += fan_area(polygon, i);
    if (fan_area(polygon, i) != 0) first_with_area = i;
  }
  const bool front = is_front(area, draw);
  if (is_culled(front, draw)) return;
  const PolygonMode mode = front ? draw.front_mode : draw.back_mode;
  if (mode == PolygonMode::fill) {
    for (std::size_t i = 1; i <= triangles; ++i)
      if (fan_area(polygon, i) != 0) add_fan(polygon, i, front, draw, format, out);
    return;
  }
  const bool is_line = mode == PolygonMode::line;
  const bool is_offset = is_line ? draw.polygon_offset.line : draw.polygon_offset.point;
  const double bias = is_offset ? polygon_bias(polygon, first_with_area, draw, format) : 0;
  const ScreenPrimitive like = primitive_of(is_line ? Kind::line : Kind::point, polygon, !front, bias);
  if (is_line) add_outline(polygon, like, draw, out);
  else add_corners(polygon, like, draw, out);
}

}  // namespace tuberia::oracle
