// Rectangles sampled at levels of detail that the program has worked out: rectangles of codes by the short
// way, in texture_kernels.cpp.

#if defined(TUBERIA_RASTER_SIMD_TEXTURE_AT_LEVEL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_TEXTURE_AT_LEVEL_INL
#undef TUBERIA_RASTER_SIMD_TEXTURE_AT_LEVEL_INL
#else
#define TUBERIA_RASTER_SIMD_TEXTURE_AT_LEVEL_INL
#endif

#include "raster/simd/texture-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// Defined in texture_kernels.cpp for each precision of sampling; live: as of sample_lanes.
template <Precision P>
Vec4<Float<P>> sample_lanes_at_level(const Texture& texture, const Sampler& sampler, Float<P> u, Float<P> v, Float<P> level, std::uint32_t live);

/// The same bits as sample_at_level at (u, v, 0).
template <Precision P>
HWY_INLINE Vec4<Float<P>> sample_at_level(const Texture& texture, const Sampler& sampler, Vec2<Float<P>> uv, Float<P> level, Mask live) {
  using F = Float<P>;
  using Sampled = Float<sampling_precision(P)>;
  const Vec4<Sampled> colour = sample_lanes_at_level(texture, sampler, Sampled(uv.x.v), Sampled(uv.y.v), Sampled(level.v), bits_of(live));
  return {F(colour.x.v), F(colour.y.v), F(colour.z.v), F(colour.w.v)};
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
