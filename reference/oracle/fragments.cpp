#include "reference/oracle/fragments.hpp"

#include <algorithm>
#include <cmath>

#include "reference/oracle/cube.hpp"
#include "reference/oracle/fog.hpp"
#include "reference/oracle/program.hpp"

namespace tuberia::oracle {
namespace {

std::uint8_t operated(StencilOperation operation, std::uint8_t code, std::uint8_t reference) {
  const auto byte = [](int x) { return static_cast<std::uint8_t>(x & 255); };
  switch (operation) {
    case StencilOperation::keep: return code;
    case StencilOperation::zero: return 0;
    case StencilOperation::replace: return reference;
    case StencilOperation::increment: return code == 255 ? code : byte(code + 1);
    case StencilOperation::decrement: return code == 0 ? code : byte(code - 1);
    case StencilOperation::invert: return byte(~code);
    case StencilOperation::increment_wrap: return byte(code + 1);
    case StencilOperation::decrement_wrap: return byte(code - 1);
  }
  return code;
}

/// 1/w of a shape's vertices, relative to the largest.
struct InverseW {
  std::array<Interval, 3> of;
  double least = 1;
  bool are_equal = false;
};

InverseW inverse_w(const Shape& shape) {
  // The third vertex of a line is no vertex of it.
  const std::size_t third = shape.primitive().kind == ScreenPrimitive::Kind::line ? 0 : 2;
  const std::array<float, 3> w{shape.vertex(0).w, shape.vertex(1).w, shape.vertex(third).w};
  const double smallest = static_cast<double>(*std::min_element(w.begin(), w.end()));
  InverseW q;
  q.are_equal = w[0] == w[1] && w[1] == w[2];
  for (std::size_t k = 0; k < 3; ++k) {
    q.of[k] = std::max(static_cast<double>(static_cast<float>(smallest / static_cast<double>(w[k]))), 0x1p-100);
    q.least = std::min(q.least, q.of[k].low);
  }
  return q;
}

struct Divided {
  FragmentWeights weights;
  Interval sum;
};

Divided divided(const InverseW& q, Weights screen) {
  const double w1 = static_cast<double>(screen.one), w2 = static_cast<double>(screen.two);
  const Interval one = Interval(w1) * q.of[1], two = Interval(w2) * q.of[2];
  const Interval rest = ((Interval(1.0) - Interval(w1)) - Interval(w2)) * q.of[0];
  const Interval sum = (rest + one) + two;
  return {{one / sum, two / sum}, sum};
}

}  // namespace

FragmentWeights perspective_weights(const Shape& shape, const Draw& draw, int x, int y) {
  const Weights screen = shape.weights(x, y);
  if (shape.primitive().kind == ScreenPrimitive::Kind::point) return {0.0, 0.0};
  const InverseW q = inverse_w(shape);
  const bool is_line = shape.primitive().kind == ScreenPrimitive::Kind::line;
  const bool is_affine = q.are_equal || (!is_line && draw.perspective == PerspectiveCorrection::none);
  if (is_affine) return {static_cast<double>(screen.one), static_cast<double>(screen.two)};
  const FragmentWeights here = divided(q, screen).weights;
  if (is_line || draw.perspective == PerspectiveCorrection::each_pixel) return here;

  const int length = 4 << static_cast<int>(draw.perspective), start_x = x / length * length;
  const Divided start = divided(q, shape.weights(start_x, y)), end = divided(q, shape.weights(start_x + length, y, start_x));
  const Outcome inside = both(outcome_of(Compare::greater_equal, start.sum, q.least / 2), outcome_of(Compare::greater_equal, end.sum, q.least / 2));
  if (inside == Outcome::no) return here;
  const auto along = [&](Interval from, Interval to) {
    return from + Interval(static_cast<double>(x - start_x)) * ((to - from) * Interval(1.0 / length));
  };
  const FragmentWeights straight{along(start.weights.one, end.weights.one), along(start.weights.two, end.weights.two)};
  if (inside == Outcome::yes) return straight;
  return {hull(straight.one, here.one), hull(straight.two, here.two)};
}

Interval interpolated(const Shape& shape, const FragmentWeights& w, std::size_t scalar) {
  const auto value = [&](std::size_t i) {
    const ScreenVertex& v = shape.vertex(i);
    return shape.primitive().is_back ? v.back[scalar] : v.front[scalar];
  };
  const Interval first = value(0);
  if (shape.primitive().kind == ScreenPrimitive::Kind::point) return first;
  if (shape.primitive().kind == ScreenPrimitive::Kind::line) return first + (value(1) - first) * w.one;
  return (first + (value(1) - first) * w.one) + (value(2) - first) * w.two;
}

ShadedFragment shaded(const Shape& shape, const Draw& draw, int x, int y) {
  const FragmentWeights w = perspective_weights(shape, draw, x, y);
  ShadedFragment fragment;
  fragment.colour = program_colour(shape, w, draw, x, y);
  if (draw.program.may_discard())
    fragment.is_kept = outcome_of(Compare::greater_equal, fragment.colour[3], static_cast<double>(draw.program.alpha_cutoff));
  if (draw.fog.mode == FogMode::off) return fragment;
  const Interval at = interpolated(shape, w, kFogCoordinate);
  const Interval share = !draw.fog.per_vertex ? fog_share(draw.fog, absolute(at)) : at.is_known() ? clamped(at, 0, 1) : Interval{0, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval fog = static_cast<double>(draw.fog.colour[static_cast<int>(i)]);
    fragment.colour[i] = fog + share * (fragment.colour[i] - fog);
  }
  return fragment;
}

Outcome alpha_keeps(const Draw& draw, Interval alpha, int sample, int samples) {
  const Interval a = alpha.is_known() ? clamped(alpha, 0, 1) : Interval{0, 1};
  Outcome outcome = outcome_of(draw.alpha_test, a, static_cast<double>(draw.alpha_reference));
  if (!draw.alpha_to_coverage) return outcome;
  const Interval scaled = a * Interval(static_cast<double>(samples)) + Interval(0.5);
  const double fewest = std::floor(scaled.low), most = std::floor(scaled.high);
  const Outcome stays = sample < fewest ? Outcome::yes : sample < most ? Outcome::maybe : Outcome::no;
  return both(outcome, stays);
}

bool stencil_and_depth(Sample& sample, const Draw& draw, bool is_back, float depth, DepthFormat format) {
  const StencilFace& face = is_back ? draw.stencil.back : draw.stencil.front;
  const auto update = [&](StencilOperation operation) {
    const int result = operated(operation, sample.stencil, face.reference);
    sample.stencil = static_cast<std::uint8_t>((sample.stencil & ~face.write_mask) | (result & face.write_mask));
  };
  if (draw.stencil.enabled && !holds(face.test, face.reference & face.read_mask, sample.stencil & face.read_mask)) {
    update(face.fail);
    return false;
  }
  const float least = std::min(draw.near_depth, draw.far_depth), most = std::max(draw.near_depth, draw.far_depth);
  const std::int32_t code = depth_code(std::clamp(depth, least, most), format);
  const bool passes = holds(draw.depth_test, code, sample.depth);
  if (draw.stencil.enabled) update(passes ? face.pass : face.depth_fail);
  if (passes && draw.depth_write) sample.depth = code;
  return passes;
}

}  // namespace tuberia::oracle
