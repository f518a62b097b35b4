#include "reference/oracle/fragments.hpp"

#include <cmath>

#include "reference/oracle/cube.hpp"
#include "reference/oracle/program.hpp"

namespace tuberia::oracle {
namespace {

Interval mapped(Interval a, double (*increasing)(double)) { return {increasing(a.low), increasing(a.high)}; }

/// The share of the colour that the fog lets through.
Interval fog_share(const Fog& fog, Interval c) {
  if (!c.is_known()) return unknown();
  const Interval density = static_cast<double>(fog.density);
  const Interval start = static_cast<double>(fog.start), end = static_cast<double>(fog.end);
  if (fog.mode == FogMode::linear) {
    const Interval share = (end - c) / (end - start);
    return share.is_known() ? clamped(share, 0, 1) : Interval{0, 1};
  }
  Interval thickness = density * c;
  if (fog.mode == FogMode::exp2) thickness = thickness * thickness;
  if (!thickness.is_known()) return {0, 1};
  // The documents allow e^x an error: that of the exponent scaled, and that of the power itself.
  thickness = widened(thickness, 0x1p-21);
  return clamped(widened(mapped(-thickness, [](double x) { return std::exp(x); }), 1e-6), 0, 1);
}

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

}  // namespace

FragmentWeights perspective_weights(const Shape& shape, Weights screen) {
  const double w1 = static_cast<double>(screen.one), w2 = static_cast<double>(screen.two);
  if (shape.primitive().kind == ScreenPrimitive::Kind::point) return {0.0, 0.0};
  // The third vertex of a line is no vertex of it.
  const std::size_t third = shape.primitive().kind == ScreenPrimitive::Kind::line ? 0 : 2;
  const float a = shape.vertex(0).w, b = shape.vertex(1).w, c = shape.vertex(third).w;
  if (a == b && b == c) return {w1, w2};
  const double least = static_cast<double>(std::min({a, b, c}));
  const auto q = [&](float w) {
    return Interval(std::max(static_cast<double>(static_cast<float>(least / static_cast<double>(w))), 0x1p-100));
  };
  const Interval one = Interval(w1) * q(b), two = Interval(w2) * q(c);
  const Interval rest = ((Interval(1.0) - Interval(w1)) - Interval(w2)) * q(a);
  const Interval sum = (rest + one) + two;
  return {one / sum, two / sum};
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
  const FragmentWeights w = perspective_weights(shape, shape.weights(x, y));
  ShadedFragment fragment;
  fragment.colour = program_colour(shape, w, draw, x, y);
  if (draw.program.may_discard())
    fragment.is_kept = outcome_of(Compare::greater_equal, fragment.colour[3], static_cast<double>(draw.program.alpha_cutoff));
  if (draw.fog.mode == FogMode::off) return fragment;
  const Interval share = fog_share(draw.fog, absolute(interpolated(shape, w, kFogCoordinate)));
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
