#include "reference/oracle/program.hpp"

#include <cmath>

#include "reference/oracle/combine.hpp"

namespace tuberia::oracle {
namespace {

Interval scalar_at(const Shape& shape, const Draw& draw, const FragmentWeights& w, std::size_t scalar) {
  // Not even a constant survives weights that are no numbers.
  if (!w.one.is_known() || !w.two.is_known()) return unknown();
  return draw.flat_shading ? shape.primitive().provoking[scalar] : interpolated(shape, w, scalar);
}

/// Where a texture is read for one pixel; `first` is the scalar that holds s.
TexturePoint point_at(const Shape& shape, const Draw& draw, const Texture& texture, std::size_t first, int x, int y) {
  const FragmentWeights w = perspective_weights(shape, draw, x, y);
  const auto scalar = [&](std::size_t i) { return scalar_at(shape, draw, w, first + i); };
  TexturePoint point{scalar(0), scalar(1), 0.0, 0.0};
  if (first < kUnitCoordinates) return point;
  point.r = scalar(2);
  const Interval q = scalar(3);
  if (texture.kind == TextureKind::cube) {
    point.reference = q;
    return point;
  }
  point.s = point.s / q;
  point.t = point.t / q;
  point.r = point.r / q;
  point.reference = point.r;
  if (texture.kind != TextureKind::three_dimensional) point.r = 0.0;
  if (texture.kind == TextureKind::one_dimensional) point.t = 0.0;
  return point;
}

/// With the changes of the coordinates from the quad's upper left pixel to the next ones.
TexturePoint with_steps(TexturePoint point, const Shape& shape, const Draw& draw, const Texture& texture, std::size_t first, int x, int y) {
  if (draw.flat_shading) return point;
  const int left = x & ~1, top = y & ~1;
  const auto at = [&](int px, int py) {
    const TexturePoint p = point_at(shape, draw, texture, first, px, py);
    return Triple{p.s, p.t, p.r};
  };
  const Triple corner = at(left, top), right = at(left + 1, top), below = at(left, top + 1);
  const std::array<int, 3> size{texture.width, texture.height, texture.slices};
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval texels = size[i];
    point.steps.x[i] = right[i] - corner[i];
    point.steps.y[i] = below[i] - corner[i];
    point.texel_steps.x[i] = right[i] * texels - corner[i] * texels;
    point.texel_steps.y[i] = below[i] * texels - corner[i] * texels;
  }
  return point;
}

Colour texel_at(const Shape& shape, const Draw& draw, const Texture& texture, const Sampler& sampler, std::size_t first, int x, int y) {
  TexturePoint point = point_at(shape, draw, texture, first, x, y);
  if (sampler.mipmaps != MipmapFilter::none || sampler.max_anisotropy > 1) point = with_steps(point, shape, draw, texture, first, x, y);
  return sample(texture, sampler, point);
}

Colour through_units(const Shape& shape, const Draw& draw, Colour primary, int x, int y) {
  for (Interval& c : primary) c = c.is_known() ? clamped(c, 0, 1) : Interval{0, 1};
  Colour colour = primary;
  for (std::size_t k = 0; k < kTextureUnits; ++k) {
    const TextureUnit& unit = draw.program.units[k];
    if (unit.texture == nullptr) continue;
    const Colour texel = texel_at(shape, draw, *unit.texture, unit.sampler, kUnitCoordinates + 4 * k, x, y);
    colour = combined(unit, texel, primary, colour);
  }
  return colour;
}

}  // namespace

Colour program_colour(const Shape& shape, const FragmentWeights& w, const Draw& draw, int x, int y) {
  const Program& program = draw.program;
  Colour colour;
  for (std::size_t i = 0; i < 4; ++i) {
    if (program.kind == ProgramKind::textured) colour[i] = static_cast<double>(program.tint[static_cast<int>(i)]);
    else if (program.kind == ProgramKind::flat && w.one.is_known() && w.two.is_known()) colour[i] = shape.primitive().provoking[kColour + i];
    else colour[i] = scalar_at(shape, draw, w, kColour + i);
  }
  if (program.kind == ProgramKind::fixed_function) return through_units(shape, draw, colour, x, y);
  if (program.kind != ProgramKind::textured && program.kind != ProgramKind::textured_gouraud) return colour;
  const Colour texel = texel_at(shape, draw, *program.texture, program.sampler, kTexcoord, x, y);
  for (std::size_t i = 0; i < 4; ++i) colour[i] = texel[i] * colour[i];
  return colour;
}

}  // namespace tuberia::oracle
