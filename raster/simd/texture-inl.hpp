// Texture sampling as a fragment program calls it. The work is in texture_kernels.cpp and
// texture_kinds_kernels.cpp, compiled once and not once a program: inlined, it is most of a program's
// code and takes most of its build.

#if defined(TUBERIA_RASTER_SIMD_TEXTURE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_TEXTURE_INL
#undef TUBERIA_RASTER_SIMD_TEXTURE_INL
#else
#define TUBERIA_RASTER_SIMD_TEXTURE_INL
#endif

#include "raster/sampler.hpp"
#include "raster/simd/vector-inl.hpp"
#include "raster/texture.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// Where the last register of fragments was sampled. A guess that holds, as nearly all do, lets the
/// texels be loaded before the level of detail is known; no result depends on it.
struct LevelGuess {
  int level = 0;
};

/// Which precision sampling has in a program's: it divides and takes roots exactly whatever that is.
constexpr Precision sampling_precision(Precision p) {
  return p == Precision::fast_reciprocal || p == Precision::fast_inverse_sqrt ? Precision::exact : p;
}

/// Linear intensities at (u, v); live: bit i is lane i, at least one.
/// Defined in texture_kernels.cpp for each precision of sampling.
template <Precision P>
Vec4<Float<P>> sample_lanes(const Texture& texture, const Sampler& sampler, Float<P> u, Float<P> v, std::uint32_t live, LevelGuess& guess);

/// The same for any kind of texture and sampler. at: kLanes each of s, t, r and the reference.
/// Defined in texture_kinds_kernels.cpp for each precision of sampling.
template <Precision P>
void sample_any_lanes(const Texture& texture, const Sampler& sampler, const float* at, std::uint32_t live, float* rgba);

/// The same at a given level of detail. at: kLanes each of s, t, r and the level.
template <Precision P>
void sample_any_lanes_at_level(const Texture& texture, const Sampler& sampler, const float* at, std::uint32_t live, float* rgba);

/// What sample_lanes can do by itself.
HWY_INLINE bool is_everyday(const Texture& texture, const Sampler& sampler) {
  return texture.is_rectangle_of_codes() && !(sampler.max_anisotropy > 1);
}

/// The texture's colour at uv. Lanes that are not live still lend their coordinates to the quad's
/// derivatives; their own result means nothing. Of a box the slice r = 0 is read.
template <Precision P>
HWY_INLINE Vec4<Float<P>> sample(const Texture& texture, const Sampler& sampler, Vec2<Float<P>> uv, Mask live, LevelGuess& guess) {
  using F = Float<P>;
  if constexpr (sampling_precision(P) == P) {
    return sample_lanes(texture, sampler, uv.x, uv.y, bits_of(live), guess);
  } else {
    using Sampled = Float<sampling_precision(P)>;
    const Vec4<Sampled> colour = sample_lanes(texture, sampler, Sampled(uv.x.v), Sampled(uv.y.v), bits_of(live), guess);
    return {F(colour.x.v), F(colour.y.v), F(colour.z.v), F(colour.w.v)};
  }
}
template <Precision P>
HWY_INLINE Vec4<Float<P>> sample(const Texture& texture, const Sampler& sampler, Vec2<Float<P>> uv, Mask live) {
  LevelGuess guess;
  return sample(texture, sampler, uv, live, guess);
}

/// The same at (s, t, r) of any texture, or in the direction (x, y, z) of a cube map; `reference` is
/// what the texels of a depth texture are compared with.
template <Precision P>
HWY_INLINE Vec4<Float<P>> sample(const Texture& texture, const Sampler& sampler, Vec3<Float<P>> at, Float<P> reference, Mask live) {
  using F = Float<P>;
  alignas(64) float coordinates[4 * kLanes], rgba[4 * kLanes];
  store(at.x, coordinates);
  store(at.y, coordinates + kLanes);
  store(at.z, coordinates + 2 * kLanes);
  store(reference, coordinates + 3 * kLanes);
  sample_any_lanes<sampling_precision(P)>(texture, sampler, coordinates, bits_of(live), rgba);
  return {load<F>(rgba), load<F>(rgba + kLanes), load<F>(rgba + 2 * kLanes), load<F>(rgba + 3 * kLanes)};
}

/// The same at a level of detail that the program has worked out, in place of the quad's derivatives; the
/// sampler's bias and bounds still apply. One sample, however anisotropic the sampler. Depths are not compared.
template <Precision P>
HWY_INLINE Vec4<Float<P>> sample_at_level(const Texture& texture, const Sampler& sampler, Vec3<Float<P>> at, Float<P> level, Mask live) {
  using F = Float<P>;
  alignas(64) float coordinates[4 * kLanes], rgba[4 * kLanes];
  store(at.x, coordinates);
  store(at.y, coordinates + kLanes);
  store(at.z, coordinates + 2 * kLanes);
  store(level, coordinates + 3 * kLanes);
  sample_any_lanes_at_level<sampling_precision(P)>(texture, sampler, coordinates, bits_of(live), rgba);
  return {load<F>(rgba), load<F>(rgba + kLanes), load<F>(rgba + 2 * kLanes), load<F>(rgba + 3 * kLanes)};
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
