// Blending in general: what the fused tile loops leave out of blend-inl.hpp.

#if defined(TUBERIA_RASTER_SIMD_BLEND_FUNCTION_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_BLEND_FUNCTION_INL
#undef TUBERIA_RASTER_SIMD_BLEND_FUNCTION_INL
#else
#define TUBERIA_RASTER_SIMD_BLEND_FUNCTION_INL
#endif

#include "raster/simd/blend-inl.hpp"
#include "raster/simd/half-inl.hpp"
#include "raster/simd/narrow-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

template <class F>
HWY_INLINE Vec4<F> all_channels(F a) { return {a, a, a, a}; }
template <class F>
HWY_INLINE Vec4<F> one_minus(Vec4<F> a) { return {1.0f - a.x, 1.0f - a.y, 1.0f - a.z, 1.0f - a.w}; }

template <class F>
HWY_INLINE Vec4<F> blend_factor(BlendFactor factor, Vec4<F> source, Vec4<F> pixel, Vec4<F> constant) {
  switch (factor) {
    case BlendFactor::zero: return all_channels(F(0.0f));
    case BlendFactor::one: break;
    case BlendFactor::source_colour: return source;
    case BlendFactor::one_minus_source_colour: return one_minus(source);
    case BlendFactor::destination_colour: return pixel;
    case BlendFactor::one_minus_destination_colour: return one_minus(pixel);
    case BlendFactor::source_alpha: return all_channels(source.w);
    case BlendFactor::one_minus_source_alpha: return all_channels(1.0f - source.w);
    case BlendFactor::destination_alpha: return all_channels(pixel.w);
    case BlendFactor::one_minus_destination_alpha: return all_channels(1.0f - pixel.w);
    case BlendFactor::constant_colour: return constant;
    case BlendFactor::one_minus_constant_colour: return one_minus(constant);
    case BlendFactor::constant_alpha: return all_channels(constant.w);
    case BlendFactor::one_minus_constant_alpha: return all_channels(1.0f - constant.w);
    case BlendFactor::source_alpha_saturate: {
      const F rest = 1.0f - pixel.w;
      const F smaller = select(source.w < rest, source.w, rest);
      return {smaller, smaller, smaller, F(1.0f)};
    }
  }
  return all_channels(F(1.0f));
}

/// One channel: s and d are the colours, fs and fd their factors. Products are rounded, then sums.
template <class F>
HWY_INLINE F blend_equation(BlendEquation equation, F s, F fs, F d, F fd) {
  switch (equation) {
    case BlendEquation::add: break;
    case BlendEquation::subtract: return s * fs - d * fd;
    case BlendEquation::reverse_subtract: return d * fd - s * fs;
    case BlendEquation::min: return select(s < d, s, d);
    case BlendEquation::max: return select(s > d, s, d);
  }
  return s * fs + d * fd;
}

template <class F>
HWY_INLINE Vec4<F> blend_by_function(Vec4<F> source, Vec4<F> pixel, Vec4<F> constant, const BlendState& state) {
  const BlendFunction& c = state.colour;
  const Vec4<F> fs = blend_factor(c.source, source, pixel, constant), fd = blend_factor(c.destination, source, pixel, constant);
  const F alpha_fs = blend_factor(state.alpha.source, source, pixel, constant).w;
  const F alpha_fd = blend_factor(state.alpha.destination, source, pixel, constant).w;
  return {blend_equation(c.equation, source.x, fs.x, pixel.x, fd.x), blend_equation(c.equation, source.y, fs.y, pixel.y, fd.y),
          blend_equation(c.equation, source.z, fs.z, pixel.z, fd.z),
          blend_equation(state.alpha.equation, source.w, alpha_fs, pixel.w, alpha_fd)};
}

/// The new pixel in any mode.
template <class F>
HWY_INLINE Vec4<F> blend(Vec4<F> source, Vec4<F> pixel, Vec4<F> constant, const BlendState& state) {
  if (state.mode == BlendMode::replace) return source;
  if (state.mode == BlendMode::function) return blend_by_function(source, pixel, constant, state);
  return blend(source, pixel, state.mode);
}

HWY_INLINE Int logic_result(LogicOperation operation, Int s, Int d) {
  switch (operation) {
    case LogicOperation::off: case LogicOperation::copy: break;
    case LogicOperation::clear: return Int(0);
    case LogicOperation::and_: return s & d;
    case LogicOperation::and_reverse: return s & ~d;
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
    case LogicOperation::set: return Int(-1);
  }
  return s;
}

HWY_INLINE Int code_mask(const ColourMask& m) {
  return Int((m.red ? 0xff : 0) | (m.green ? 0xff00 : 0) | (m.blue ? 0xff0000 : 0)) | Int(m.alpha ? -0x1000000 : 0);
}

/// Formats of 8 bits a channel.
template <class F>
HWY_INLINE void write_codes(Mask live, Vec4<F> colour, const OutputState& state, std::uint32_t* pixels) {
  const Int stored = load(pixels), mask = code_mask(state.blend.mask);
  colour = saturate(colour);
  Int code;
  if (state.blend.logic != LogicOperation::off) {
    code = logic_result(state.blend.logic, encode(colour, state.colour_format), stored);
  } else {
    const Rgba32F& c = state.blend.constant;
    const Vec4<F> constant = saturate(Vec4<F>(F(c.r), F(c.g), F(c.b), F(c.a)));
    code = encode(saturate(blend(colour, decode<F>(stored, state.colour_format), constant, state.blend)), state.colour_format);
  }
  store_where(live, (stored & ~mask) | (code & mask), pixels);
}

/// Formats of floats and halves.
template <class F, class Channel, class Load, class Store>
HWY_INLINE void write_planes(Mask live, Vec4<F> colour, const OutputState& state, Channel* first, const Load& load_one, const Store& store_one) {
  Channel* planes[4] = {first, first + kBlockPixels, first + 2 * kBlockPixels, first + 3 * kBlockPixels};
  const Rgba32F& c = state.blend.constant;
  if (state.blend.mode != BlendMode::replace) {
    const Vec4<F> pixel{load_one(planes[0]), load_one(planes[1]), load_one(planes[2]), load_one(planes[3])};
    colour = blend(colour, pixel, Vec4<F>(F(c.r), F(c.g), F(c.b), F(c.a)), state.blend);
  }
  const ColourMask& mask = state.blend.mask;
  if (mask.red) store_one(live, colour.x, planes[0]);
  if (mask.green) store_one(live, colour.y, planes[1]);
  if (mask.blue) store_one(live, colour.z, planes[2]);
  if (mask.alpha) store_one(live, colour.w, planes[3]);
}

/// As write_colour, for every state there is.
template <class F>
HWY_INLINE void write_any_colour(Mask live, Vec4<F> colour, const OutputState& state, void* tile_colour, int index) {
  const int at = index / kBlockPixels * (4 * kBlockPixels) + index % kBlockPixels;
  if (state.colour_format == ColourFormat::rgba32f) {
    write_planes(live, colour, state, static_cast<float*>(tile_colour) + at,
                 [](const float* from) HWY_ATTR { return load<F>(from); },
                 [](Mask m, F a, float* to) HWY_ATTR { store_where(m, a, to); });
  } else if (state.colour_format == ColourFormat::rgba16f) {
    write_planes(live, colour, state, static_cast<std::uint16_t*>(tile_colour) + at,
                 [](const std::uint16_t* from) HWY_ATTR { return float_of_half<F>(load_narrow(from)); },
                 [](Mask m, F a, std::uint16_t* to) HWY_ATTR { store_narrow_where(m, half_code(a), to); });
  } else {
    write_codes(live, colour, state, static_cast<std::uint32_t*>(tile_colour) + index);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
