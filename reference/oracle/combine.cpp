#include "reference/oracle/combine.hpp"

namespace tuberia::oracle {
namespace {

struct Sources {
  Colour texture, constant, primary, previous;
};

const Colour& source_of(CombineSource source, const Sources& sources) {
  switch (source) {
    case CombineSource::texture: return sources.texture;
    case CombineSource::constant: return sources.constant;
    case CombineSource::primary: return sources.primary;
    case CombineSource::previous: break;
  }
  return sources.previous;
}

/// Channel c of an argument; in the alpha half (c = 3) colour means alpha.
Interval argument(const CombineArgument& a, const Sources& sources, std::size_t c) {
  const Colour& colour = source_of(a.source, sources);
  const bool is_alpha = a.operand == CombineOperand::alpha || a.operand == CombineOperand::one_minus_alpha;
  const bool is_inverted = a.operand == CombineOperand::one_minus_colour || a.operand == CombineOperand::one_minus_alpha;
  const Interval value = colour[is_alpha ? 3 : c];
  return is_inverted ? Interval(1.0) - value : value;
}

Interval dot(const Combine& combine, const Sources& sources) {
  Interval sum = 0.0;
  for (std::size_t c = 0; c < 3; ++c)
    sum = sum + (argument(combine.argument[0], sources, c) - Interval(0.5)) * (argument(combine.argument[1], sources, c) - Interval(0.5));
  return Interval(4.0) * sum;
}

Interval channel(const Combine& combine, const Sources& sources, std::size_t c) {
  const Interval a0 = argument(combine.argument[0], sources, c), a1 = argument(combine.argument[1], sources, c);
  const Interval a2 = argument(combine.argument[2], sources, c);
  switch (combine.function) {
    case CombineFunction::replace: return a0;
    case CombineFunction::modulate: return a0 * a1;
    case CombineFunction::add: return a0 + a1;
    case CombineFunction::add_signed: return (a0 + a1) - Interval(0.5);
    case CombineFunction::interpolate: return a0 * a2 + a1 * (Interval(1.0) - a2);
    case CombineFunction::subtract: return a0 - a1;
    case CombineFunction::dot3_rgb:
    case CombineFunction::dot3_rgba: return dot(combine, sources);
  }
  return a0;
}

}  // namespace

Colour combined(const TextureUnit& unit, const Colour& texel, const Colour& primary, const Colour& previous) {
  Sources sources{texel, {}, primary, previous};
  for (int c = 0; c < 4; ++c) sources.constant[static_cast<std::size_t>(c)] = static_cast<double>(unit.constant[c]);
  const auto finished = [](Interval value, int scale) {
    const Interval scaled = value * Interval(static_cast<double>(scale));
    return scaled.is_known() ? clamped(scaled, 0, 1) : Interval{0, 1};
  };
  Colour result;
  for (std::size_t c = 0; c < 3; ++c) result[c] = finished(channel(unit.colour, sources, c), unit.colour.scale);
  if (unit.colour.function == CombineFunction::dot3_rgba) result[3] = result[0];
  else result[3] = finished(channel(unit.alpha, sources, 3), unit.alpha.scale);
  return result;
}

}  // namespace tuberia::oracle
