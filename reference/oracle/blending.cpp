#include "reference/oracle/blending.hpp"

#include <cmath>

namespace tuberia::oracle {
namespace {

Interval one_minus(Interval x) { return Interval(1.0) - x; }

struct Operands {
  Colour source, destination, constant;
};

/// The factor of channel c (3: alpha).
Interval factor(BlendFactor f, const Operands& o, std::size_t c) {
  switch (f) {
    case BlendFactor::zero: return 0.0;
    case BlendFactor::one: return 1.0;
    case BlendFactor::source_colour: return o.source[c];
    case BlendFactor::one_minus_source_colour: return one_minus(o.source[c]);
    case BlendFactor::destination_colour: return o.destination[c];
    case BlendFactor::one_minus_destination_colour: return one_minus(o.destination[c]);
    case BlendFactor::source_alpha: return o.source[3];
    case BlendFactor::one_minus_source_alpha: return one_minus(o.source[3]);
    case BlendFactor::destination_alpha: return o.destination[3];
    case BlendFactor::one_minus_destination_alpha: return one_minus(o.destination[3]);
    case BlendFactor::constant_colour: return o.constant[c];
    case BlendFactor::one_minus_constant_colour: return one_minus(o.constant[c]);
    case BlendFactor::constant_alpha: return o.constant[3];
    case BlendFactor::one_minus_constant_alpha: return one_minus(o.constant[3]);
    case BlendFactor::source_alpha_saturate:
      return c == 3 ? Interval(1.0) : smaller(o.source[3], one_minus(o.destination[3]));
  }
  return 0.0;
}

Interval by_function(const BlendFunction& function, const Operands& o, std::size_t c) {
  if (function.equation == BlendEquation::min) return smaller(o.source[c], o.destination[c]);
  if (function.equation == BlendEquation::max) return larger(o.source[c], o.destination[c]);
  const Interval s = o.source[c] * factor(function.source, o, c);
  const Interval d = o.destination[c] * factor(function.destination, o, c);
  if (function.equation == BlendEquation::subtract) return s - d;
  if (function.equation == BlendEquation::reverse_subtract) return d - s;
  return s + d;
}

Interval blended(const Blend& state, const Operands& o, std::size_t c) {
  switch (state.mode) {
    case BlendMode::replace: return o.source[c];
    case BlendMode::source_over:
      return (c == 3 ? o.source[3] : o.source[c] * o.source[3]) + o.destination[c] * one_minus(o.source[3]);
    case BlendMode::additive: return o.source[c] + o.destination[c];
    case BlendMode::function: return by_function(c == 3 ? state.alpha : state.colour, o, c);
  }
  return o.source[c];
}

unsigned logic(LogicOperation operation, unsigned s, unsigned d) {
  switch (operation) {
    case LogicOperation::clear: return 0;
    case LogicOperation::and_: return s & d;
    case LogicOperation::and_reverse: return s & ~d;
    case LogicOperation::copy: return s;
    case LogicOperation::and_inverted: return ~s & d;
    case LogicOperation::noop: return d;
    case LogicOperation::xor_: return s ^ d;
    case LogicOperation::or_: return s | d;
    case LogicOperation::nor: return ~(s | d);
    case LogicOperation::equivalent: return ~(s ^ d);
    case LogicOperation::invert: return ~d;
    case LogicOperation::or_reverse: return s | ~d;
    case LogicOperation::copy_inverted: return ~s;
    case LogicOperation::or_inverted: return ~s | d;
    case LogicOperation::nand: return ~(s & d);
    case LogicOperation::set: return 255;
    case LogicOperation::off: break;
  }
  return s;
}

/// The codes that a logic operation may leave, for all the codes that its operands may be.
Interval by_logic(LogicOperation operation, Interval source, Interval destination) {
  Interval codes{255, 0};
  for (double s = source.low; s <= source.high; ++s)
    for (double d = destination.low; d <= destination.high; ++d) {
      const double code = logic(operation, static_cast<unsigned>(s), static_cast<unsigned>(d)) & 255u;
      codes = {std::min(codes.low, code), std::max(codes.high, code)};
    }
  return codes;
}

}  // namespace

void blend(Sample& sample, const Colour& fragment, const Blend& state, ColourFormat format) {
  if (!state.write) return;
  Operands o;
  o.source = fragment;
  for (std::size_t c = 0; c < 4; ++c) {
    o.destination[c] = linear(sample.colour[c], static_cast<int>(c), format);
    o.constant[c] = static_cast<double>(state.constant[static_cast<int>(c)]);
    if (is_8_bit(format)) {
      o.source[c] = clamped(o.source[c], 0, 1);
      o.constant[c] = clamped(o.constant[c], 0, 1);
    }
  }
  for (std::size_t c = 0; c < 4; ++c) {
    if (!state.mask[c]) continue;
    const int channel = static_cast<int>(c);
    if (state.logic != LogicOperation::off)
      sample.colour[c] = by_logic(state.logic, stored(o.source[c], channel, format), sample.colour[c]);
    else
      sample.colour[c] = stored(blended(state, o, c), channel, format);
  }
}

}  // namespace tuberia::oracle
