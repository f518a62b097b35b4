#include "reference/oracle/oracle.hpp"

#include <algorithm>
#include <vector>

#include "reference/oracle/blending.hpp"
#include "reference/oracle/fragments.hpp"

namespace tuberia::oracle {
namespace {

Rectangle common_part(const Rectangle& a, const Rectangle& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
}

/// Whether something between coverage and the depth test may drop a fragment: then the program runs
/// before that test, for all fragments.
bool is_tested_late(const Draw& draw) {
  return draw.program.may_discard() || draw.alpha_test != Compare::always || draw.alpha_to_coverage;
}

void draw_fragment(Target& target, const Draw& draw, const Shape& shape, int x, int y,
                   const std::vector<bool>& covered, Counts& counts) {
  ++counts.fragments;
  const ShadedFragment fragment = shaded(shape, draw, x, y);
  bool any_passed = false;
  for (int s = 0; s < target.samples; ++s) {
    if (!covered[static_cast<std::size_t>(s)]) continue;
    Sample& sample = target.at(x, y, s);
    const Outcome kept = both(fragment.is_kept, alpha_keeps(draw, fragment.colour[3], s, target.samples));
    if (kept == Outcome::no) continue;
    if (kept == Outcome::maybe) sample.is_uncertain = true;
    if (sample.is_uncertain) {
      counts.are_certain = false;
      continue;
    }
    if (!stencil_and_depth(sample, draw, shape.primitive().is_back, shape.depth(x, y, s), target.depth_format)) continue;
    any_passed = true;
    ++counts.samples_passed;
    blend(sample, fragment.colour, draw.blend, target.colour_format);
  }
  // Without need for its colour nothing is shaded.
  if (is_tested_late(draw) || (any_passed && draw.blend.write)) ++counts.fragments_shaded;
}

void draw_primitive(Target& target, const Draw& draw, const Rectangle& clip, const ScreenPrimitive& primitive, Counts& counts) {
  const Shape shape(primitive, draw, target.samples);
  std::vector<bool> covered(static_cast<std::size_t>(target.samples));
  for (int y = clip.top; y < clip.bottom; ++y)
    for (int x = clip.left; x < clip.right; ++x) {
      bool any = false;
      for (int s = 0; s < target.samples; ++s) {
        const bool is_covered = shape.covers(x, y, s);
        covered[static_cast<std::size_t>(s)] = is_covered;
        any = any || is_covered;
      }
      if (any) draw_fragment(target, draw, shape, x, y, covered, counts);
    }
}

/// Whether a primitive counts as drawn: a triangle only if its bounds (with several samples a pixel wider
/// each way) hold the centre of a pixel that it may touch.
bool counts_as_drawn(const ScreenPrimitive& primitive, const Rectangle& clip, int samples) {
  if (clip.left >= clip.right || clip.top >= clip.bottom) return false;
  if (primitive.kind != ScreenPrimitive::Kind::triangle) return true;
  const std::int64_t margin = samples > 1 ? 256 : 0;
  const auto holds_centre = [&](std::int64_t ScreenVertex::*axis, int first, int end) {
    const auto& v = primitive.vertex;
    const auto [least, most] = std::minmax({v[0].*axis, v[1].*axis, v[2].*axis});
    for (std::int64_t pixel = first; pixel < end; ++pixel)
      if (least - margin <= 256 * pixel + 128 && 256 * pixel + 128 <= most + margin) return true;
    return false;
  };
  return holds_centre(&ScreenVertex::x, clip.left, clip.right) && holds_centre(&ScreenVertex::y, clip.top, clip.bottom);
}

}  // namespace

Counts draw(Target& target, const Draw& draw) {
  const Viewport viewport = draw.viewport.value_or(Viewport{0, 0, target.width, target.height});
  Rectangle clip = common_part({0, 0, target.width, target.height},
                               {viewport.x, viewport.y, viewport.x + viewport.width, viewport.y + viewport.height});
  if (draw.scissor) clip = common_part(clip, *draw.scissor);
  const GeometryResult screen = geometry(draw, viewport, target.depth_format);
  Counts counts;
  counts.primitives_in = screen.assembled;
  counts.clipped = screen.clipped;
  counts.after_clipping = screen.after_clipping;
  for (const ScreenPrimitive& primitive : screen.primitives) {
    if (counts_as_drawn(primitive, clip, target.samples)) ++counts.drawn;
    draw_primitive(target, draw, clip, primitive, counts);
  }
  return counts;
}

}  // namespace tuberia::oracle
