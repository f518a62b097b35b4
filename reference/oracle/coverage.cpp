#include "reference/oracle/coverage.hpp"

#include <algorithm>
#include <cmath>

#include "reference/oracle/diamond.hpp"

namespace tuberia::oracle {
namespace {

std::int64_t floor_divided(std::int64_t a, std::int64_t b) { return a / b - (a % b != 0 && (a % b < 0) != (b < 0) ? 1 : 0); }

constexpr std::int64_t kUnits = 256;

std::int64_t centre(int pixel) { return kUnits * pixel + kUnits / 2; }

bool is_x_major(const ScreenVertex& a, const ScreenVertex& b) { return std::abs(b.x - a.x) >= std::abs(b.y - a.y); }

}  // namespace

Shape::Shape(const ScreenPrimitive& primitive, const Draw& draw, int samples)
    : primitive_(primitive), draw_(draw), samples_(samples), vertices_(primitive.vertex) {
  using Kind = ScreenPrimitive::Kind;
  const auto whole = [](double x) { return static_cast<std::int64_t>(std::nearbyint(x)); };
  if (primitive.kind == Kind::triangle) set_up_triangle();
  if (primitive.kind == Kind::point) size_ = whole(256 * static_cast<double>(draw.point_size_pixels));
  if (primitive.kind == Kind::line) {
    size_ = whole(256 * static_cast<double>(draw.line_width_pixels));
    width_ = std::max<std::int64_t>(1, whole(static_cast<double>(draw.line_width_pixels)));
  }
}

void Shape::set_up_triangle() {
  area_ = doubled_area(vertices_[0], vertices_[1], vertices_[2]);
  if (area_ < 0) {
    std::swap(vertices_[1], vertices_[2]);
    area_ = -area_;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const ScreenVertex& from = vertices_[(k + 1) % 3];
    const ScreenVertex& to = vertices_[(k + 2) % 3];
    Edge& edge = edges_[k];
    edge = {from.y - to.y, to.x - from.x, from.x, from.y, 1};
    if (edge.per_x > 0 || (edge.per_x == 0 && edge.per_y > 0)) edge.rule = 0;
  }
  const auto [left, right] = std::minmax({vertices_[0].x, vertices_[1].x, vertices_[2].x});
  const auto [top, bottom] = std::minmax({vertices_[0].y, vertices_[1].y, vertices_[2].y});
  is_far_ = right - left > 1984 * kUnits || bottom - top > 1984 * kUnits || draw_.edge_arithmetic != EdgeArithmetic::exact;
}

bool Shape::covers(int x, int y, int sample) const {
  const SampleOffset offset = sample_offset(samples_, sample);
  const std::int64_t px = centre(x) + offset.x, py = centre(y) + offset.y;
  switch (primitive_.kind) {
    case ScreenPrimitive::Kind::triangle: {
      const bool are_exact = draw_.edge_arithmetic == EdgeArithmetic::exact || draw_.edge_arithmetic == EdgeArithmetic::exact_64;
      return are_exact ? triangle_covers(px, py) : rounded_edges_cover(x, y);
    }
    case ScreenPrimitive::Kind::point: return point_covers(px, py);
    case ScreenPrimitive::Kind::line:
      return (samples_ == 1 ? wide_line_covers(x, y) : rectangle_covers(px, py)) && stipple_shows(x, y);
  }
  return false;
}

bool Shape::triangle_covers(std::int64_t px, std::int64_t py) const {
  return std::all_of(edges_.begin(), edges_.end(), [&](const Edge& edge) { return edge.at(px, py) - edge.rule >= 0; });
}

bool Shape::rounded_edges_cover(int x, int y) const {
  const auto [left, right] = std::minmax({vertices_[0].x, vertices_[1].x, vertices_[2].x});
  const auto [top, bottom] = std::minmax({vertices_[0].y, vertices_[1].y, vertices_[2].y});
  if (centre(x) < left || centre(x) > right || centre(y) < top || centre(y) > bottom) return false;
  const bool is_anchored = draw_.edge_arithmetic == EdgeArithmetic::float_anchored;
  const int corner_x = is_anchored ? x / 64 * 64 : 0, corner_y = is_anchored ? y / 64 * 64 : 0;
  return std::all_of(edges_.begin(), edges_.end(), [&](const Edge& edge) {
    const auto start = static_cast<float>(floor_divided(edge.at(centre(corner_x), centre(corner_y)) - edge.rule, kUnits));
    const float along_x = static_cast<float>(x - corner_x) * static_cast<float>(edge.per_x);
    const float along_y = static_cast<float>(y - corner_y) * static_cast<float>(edge.per_y);
    const float across = along_x + start;
    return along_y + across >= 0;
  });
}

bool Shape::point_covers(std::int64_t px, std::int64_t py) const {
  const std::int64_t x = px - vertices_[0].x, y = py - vertices_[0].y;
  if (draw_.round_points) return 4 * (x * x + y * y) < size_ * size_;
  return -size_ <= 2 * x && 2 * x < size_ && -size_ <= 2 * y && 2 * y < size_;
}

bool Shape::thin_line_covers(int x, int y) const {
  const ScreenVertex& a = vertices_[0];
  const ScreenVertex& b = vertices_[1];
  // Wide lines are thin ones side by side, so the first one moves half the width back.
  const std::int64_t back = -128 * (width_ - 1);
  const std::int64_t move_x = is_x_major(a, b) ? 0 : back, move_y = is_x_major(a, b) ? back : 0;
  return leaves_diamond({a.x + move_x, a.y + move_y}, {b.x + move_x, b.y + move_y}, {centre(x), centre(y)});
}

bool Shape::wide_line_covers(int x, int y) const {
  const bool x_major = is_x_major(vertices_[0], vertices_[1]);
  for (int k = 0; k < width_; ++k)
    if (x_major ? thin_line_covers(x, y - k) : thin_line_covers(x - k, y)) return true;
  return false;
}

bool Shape::rectangle_covers(std::int64_t px, std::int64_t py) const {
  const std::int64_t dx = vertices_[1].x - vertices_[0].x, dy = vertices_[1].y - vertices_[0].y;
  const std::int64_t rx = px - vertices_[0].x, ry = py - vertices_[0].y;
  const std::int64_t along = rx * dx + ry * dy, across = dx * ry - dy * rx, length_squared = dx * dx + dy * dy;
  if (along < 0 || along >= length_squared) return false;
  // -size |d| <= 2 across < size |d|, squared: the side that across < 0 lies on owns its border.
  __extension__ using Wide = __int128;
  const Wide left = Wide(4) * across * across, right = Wide(size_) * size_ * length_squared;
  return across < 0 ? left <= right : left < right;
}

bool Shape::stipple_shows(int x, int y) const {
  if (!draw_.stipple) return true;
  const bool x_major = is_x_major(vertices_[0], vertices_[1]);
  const std::int64_t start = floor_divided(x_major ? vertices_[0].x : vertices_[0].y, kUnits);
  const std::int64_t counter = primitive_.stipple_start + std::abs((x_major ? x : y) - start);
  return (draw_.stipple->bits >> (counter / draw_.stipple->factor % 16) & 1) != 0;
}

float Shape::near_weight(const Edge& edge, int x, int y, SampleOffset offset) const {
  const std::int64_t value = edge.at(centre(x) + offset.x, centre(y) + offset.y);
  const std::int64_t e = floor_divided(value - edge.rule, kUnits), r = value - kUnits * e;
  const double inverse = 1 / static_cast<double>(area_);
  const float scale = static_cast<float>(256 * inverse);
  const bool at_centre = offset.x == 0 && offset.y == 0;
  const float rest = static_cast<float>(static_cast<double>(r) * (at_centre ? inverse : static_cast<double>(scale) / 256));
  const float scaled = static_cast<float>(e) * scale;
  return scaled + rest;
}

float Shape::far_weight(const Edge& edge, int x, int y, SampleOffset offset, int square_x) const {
  const double inverse = 1 / static_cast<double>(area_);
  const float scale = static_cast<float>(256 * inverse);
  const int corner_x = static_cast<int>(64 * floor_divided(square_x, 64)), corner_y = static_cast<int>(64 * floor_divided(y, 64));
  const std::int64_t value = edge.at(centre(corner_x), centre(corner_y));
  const std::int64_t e = floor_divided(value - edge.rule, kUnits), r = value - kUnits * e;
  const float rest = static_cast<float>(static_cast<double>(r) * inverse);
  const float anchor = static_cast<float>(static_cast<double>(e) * static_cast<double>(scale) + static_cast<double>(rest));
  const float gx = static_cast<float>(static_cast<double>(edge.per_x) * static_cast<double>(scale));
  const float gy = static_cast<float>(static_cast<double>(edge.per_y) * static_cast<double>(scale));
  const float dx = static_cast<float>(x - corner_x) + static_cast<float>(offset.x) / 256;
  const float dy = static_cast<float>(y - corner_y) + static_cast<float>(offset.y) / 256;
  const float along_x = dx * gx;
  const float along_y = dy * gy;
  return along_y + (along_x + anchor);
}

Weights Shape::weights_at(int x, int y, SampleOffset offset, int square_x) const {
  if (primitive_.kind == ScreenPrimitive::Kind::point) return {};
  if (primitive_.kind == ScreenPrimitive::Kind::triangle) {
    if (is_far_) return {far_weight(edges_[1], x, y, offset, square_x), far_weight(edges_[2], x, y, offset, square_x)};
    return {near_weight(edges_[1], x, y, offset), near_weight(edges_[2], x, y, offset)};
  }
  const ScreenVertex& a = vertices_[0];
  const ScreenVertex& b = vertices_[1];
  const bool x_major = is_x_major(a, b);
  const std::int64_t from_a = x_major ? centre(x) + offset.x - a.x : centre(y) + offset.y - a.y;
  const std::int64_t length = x_major ? b.x - a.x : b.y - a.y;
  const double t = static_cast<double>(from_a) / static_cast<double>(length);
  return {static_cast<float>(std::clamp(t, 0.0, 1.0)), 0};
}

float Shape::depth(int x, int y, int sample) const {
  const Weights w = weights_at(x, y, sample_offset(samples_, sample), x);
  const double z0 = static_cast<double>(vertices_[0].depth);
  const float first = static_cast<float>(z0 + primitive_.bias);
  if (primitive_.kind == ScreenPrimitive::Kind::point) return first;
  const float d1 = static_cast<float>(static_cast<double>(vertices_[1].depth) - z0);
  const float d2 = static_cast<float>(static_cast<double>(vertices_[2].depth) - z0);
  const float second = d1 * w.one;
  const float third = d2 * w.two;
  return third + (second + first);
}

}  // namespace tuberia::oracle
