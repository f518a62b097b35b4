#include "pipeline/shape_set_up.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "math/fixed_point.hpp"

namespace tuberia {
namespace {

std::int32_t units_of(float pixels) { return static_cast<std::int32_t>(std::nearbyint(static_cast<double>(pixels) * kSubpixelUnits)); }

std::uint32_t period_of(const StipplePattern& pattern) { return 16 * static_cast<std::uint32_t>(pattern.factor); }

/// Bounds that may be a pixel too large: coverage asks every pixel anyway.
void set_bounds(const ScreenShape& shape, int ends, ScreenTriangle& record) {
  const std::int32_t reach = shape.size / 2 + kSubpixelUnits;
  const auto pixel = [](std::int32_t units) { return static_cast<std::int16_t>(std::clamp(units >> kSubpixelBits, -32768, 32767)); };
  record.left = pixel(std::min(shape.x[0], shape.x[ends - 1]) - reach);
  record.right = pixel(std::max(shape.x[0], shape.x[ends - 1]) + reach);
  record.top = pixel(std::min(shape.y[0], shape.y[ends - 1]) - reach);
  record.bottom = pixel(std::max(shape.y[0], shape.y[ends - 1]) + reach);
}

/// What points and lines have in common: no edges, and weights that are 0 at the first vertex.
ScreenTriangle record_of(const VertexBatch& vertices, std::uint32_t first, std::uint32_t second, double depth_bias) {
  ScreenTriangle t{};
  const auto z0 = static_cast<double>(vertices.screen[first].depth), z1 = static_cast<double>(vertices.screen[second].depth);
  const auto w0 = static_cast<double>(vertices.clip_w[first]), w1 = static_cast<double>(vertices.clip_w[second]);
  const double smallest = std::min(w0, w1);
  t.depth = static_cast<float>(z0 + depth_bias);
  t.depth_delta[0] = static_cast<float>(z1 - z0);
  t.inverse_w[0] = t.inverse_w[2] = static_cast<float>(std::max(smallest / w0, kLeastInverseW));
  t.inverse_w[1] = static_cast<float>(std::max(smallest / w1, kLeastInverseW));
  t.perspective = w0 == w1 ? kIsAffine : kDividesEachPixel;
  t.is_near = 1;
  t.vertex[0] = t.vertex[2] = static_cast<std::uint16_t>(first);
  t.vertex[1] = static_cast<std::uint16_t>(second);
  return t;
}

template <class Assembled>
ScreenTriangle finished(ScreenTriangle record, const Assembled& from, const ScreenShape& shape, int ends) {
  set_bounds(shape, ends, record);
  record.provoking_vertex = static_cast<std::uint16_t>(from.provoking);
  record.primitive = from.primitive;
  record.is_back = from.is_back;
  return record;
}

/// By how many pixels of its major axis a line moves the pattern on.
std::uint32_t length_in_pixels(const ScreenShape& line) {
  const bool x_major = std::abs(line.x[1] - line.x[0]) >= std::abs(line.y[1] - line.y[0]);
  const auto& along = x_major ? line.x : line.y;
  return static_cast<std::uint32_t>(std::abs((along[1] >> kSubpixelBits) - (along[0] >> kSubpixelBits)));
}

}  // namespace

ShapeSetUp::ShapeSetUp(const RasterizationState& state, int samples) noexcept
    : round_points_(state.point.round), point_size_(units_of(state.point.size_pixels)),
      line_size_(samples > 1 ? units_of(state.line.width_pixels)
                             : kSubpixelUnits * std::max(1, static_cast<std::int32_t>(std::nearbyint(state.line.width_pixels)))),
      pattern_period_(period_of(state.line.stipple.value_or(StipplePattern{}))) {}

ScreenShape ShapeSetUp::line_shape(const VertexBatch& vertices, const AssembledLine& line) const {
  return {.kind = ScreenShape::Kind::line,
          .x = {vertices.screen[line.v0].x, vertices.screen[line.v1].x},
          .y = {vertices.screen[line.v0].y, vertices.screen[line.v1].y},
          .size = line_size_};
}

ScreenShape ShapeSetUp::point_shape(const VertexBatch& vertices, const AssembledPoint& point) const {
  return {.kind = ScreenShape::Kind::point, .round = round_points_,
          .x = {vertices.screen[point.vertex].x}, .y = {vertices.screen[point.vertex].y}, .size = point_size_};
}

void ShapeSetUp::operator()(Chunk& chunk) const {
  chunk.shapes.clear();
  chunk.stipple_advance = 0;
  if (chunk.lines.empty() && chunk.points.empty()) return;
  const std::vector<ScreenTriangle> filled = std::move(chunk.screen_triangles);
  const std::size_t total = filled.size() + chunk.lines.size() + chunk.points.size();
  chunk.screen_triangles.clear();
  chunk.screen_triangles.reserve(total);
  const auto add = [&](const ScreenTriangle& record, const ScreenShape& shape) {
    chunk.screen_triangles.push_back(record);
    chunk.shapes.push_back(shape);
  };

  // A polygon's mode makes it one of the three, so all of a primitive's pieces come from one batch.
  const auto number = [](const auto& batch, std::size_t i) {
    return i < batch.size() ? std::int64_t{batch[i].primitive} : std::numeric_limits<std::int64_t>::max();
  };
  for (std::size_t t = 0, l = 0, p = 0; t + l + p < total;) {
    const std::int64_t next = std::min({number(filled, t), number(chunk.lines, l), number(chunk.points, p)});
    if (next == number(filled, t)) {
      add(filled[t++], {});
    } else if (next == number(chunk.points, p)) {
      const AssembledPoint& point = chunk.points[p++];
      const ScreenShape shape = point_shape(chunk.vertices, point);
      add(finished(record_of(chunk.vertices, point.vertex, point.vertex, point.depth_bias), point, shape, 1), shape);
    } else {
      const AssembledLine& line = chunk.lines[l++];
      ScreenShape shape = line_shape(chunk.vertices, line);
      if (line.begins_pattern) chunk.stipple_advance = 0;
      shape.stipple_start = chunk.stipple_advance;
      chunk.stipple_advance = (chunk.stipple_advance + length_in_pixels(shape)) % pattern_period_;
      add(finished(record_of(chunk.vertices, line.v0, line.v1, line.depth_bias), line, shape, 2), shape);
    }
  }
}

std::uint32_t continue_pattern(Chunk& chunk, std::uint32_t start, const StipplePattern& pattern) noexcept {
  for (ScreenShape& shape : chunk.shapes) shape.stipple_start = (shape.stipple_start + start) % period_of(pattern);
  return (start + chunk.stipple_advance) % period_of(pattern);
}

}  // namespace tuberia
