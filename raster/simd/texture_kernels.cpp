// Texture sampling where it matters most, rectangles of 8-bit codes: coordinates to texels, filtering
// inside and between mipmap levels. All the rest is in texture_kinds_kernels.cpp.

#include "raster/texture.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "raster/simd/texture_kernels.cpp"
#include "raster/simd/every_instruction_set.hpp"

#include "raster/simd/quad-inl.hpp"
#include "raster/simd/rectangle-inl.hpp"
#include "raster/simd/texture-inl.hpp"
#include "raster/simd/texture_at_level-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// The squared texels of the base level that one pixel step crosses, the larger of the two
/// directions; one for each quad, from its upper left pixel.                         [rules T3]
template <class F>
HWY_INLINE F squared_step(const Texture& texture, F u, F v) {
  const F x = u * static_cast<float>(texture.level(0).width), y = v * static_cast<float>(texture.level(0).height);
  const F dx_dx = first_difference_x(x), dy_dx = first_difference_x(y), dx_dy = first_difference_y(x), dy_dy = first_difference_y(y);
  return first_of_quad(max(dx_dx * dx_dx + dy_dx * dy_dx, dx_dy * dx_dy + dy_dy * dy_dy));
}

template <class F>
HWY_INLINE F level_of_detail(F squared) { return log2(squared) * 0.5f; }

/// Any level of detail, lane by lane. u, v: reduced.
template <class F>
HWY_NOINLINE Vec4<F> sample_any_levels(const CodeReader& from, F u, F v, F squared, std::uint32_t live) {
  return mix_levels(from.texture, from.sampler, level_of_detail(squared), mask_of(live),
                    [&](int level, Mask here) HWY_ATTR { return sample_level(from, level, u, v, here & mask_of(live)); });
}

/// The level of all live lanes, for `linear` the finer one of two; -1 where they differ or where it does
/// not follow from the exponent of the squared step, which comes long before its logarithm.
template <class F>
HWY_INLINE int common_level(const CodeReader& from, F squared_at_least_1, std::uint32_t live, LevelGuess& guess) {
  const int last = from.texture.level_count() - 1;
  const bool nearest = from.sampler.mipmaps == MipmapFilter::nearest;
  if (live == 0 || from.sampler.lod_bias != 0 || from.sampler.min_lod > 0 || from.sampler.max_lod < static_cast<float>(last)) return -1;
  // Levels begin at 4^i, nearest ones at 2 * 4^i: with the exponent's last bit 1 or 0, being biased by 127.
  // The logarithm's rounding may move a step that is within 2^-15 of that place to the other level.
  constexpr std::int32_t kExponentOne = 1 << 23, kBias = 127 * kExponentOne, kDoubt = 1 << 8;
  const Int shifted = bits_of(squared_at_least_1) - Int(nearest ? kBias - kExponentOne : kBias);
  const Int within_level = (nearest ? shifted : shifted + Int(kDoubt)) & Int(2 * kExponentOne - 1);
  const Int level = select(within_level < Int(kDoubt), Int(-1), min(shift_right<24>(shifted), Int(last)));

  const auto is_of_all = [&](int number) HWY_ATTR { return none(!(level == Int(number)) & mask_of(live)); };
  const int guessed = guess.level;
  if (is_of_all(guessed)) return guessed;
  guess.level = lane(level, std::countr_zero(live));
  return is_of_all(guess.level) ? guess.level : -1;
}

template <class F>
HWY_INLINE Vec4<F> filtered(const CodeReader& from, F u, F v, std::uint32_t live, LevelGuess& guess) {
  const auto& [texture, sampler] = from;
  const F reduced_u = reduce_coordinate(u, sampler.wrap_u), reduced_v = reduce_coordinate(v, sampler.wrap_v);
  if (sampler.mipmaps == MipmapFilter::none || texture.level_count() == 1) return sample_level(from, 0, reduced_u, reduced_v, mask_of(live));

  const F squared = squared_step(texture, u, v), squared_at_least_1 = select(squared > 1.0f, squared, F(1.0f));
  const int level = common_level(from, squared_at_least_1, live, guess);
  if (level < 0) return sample_any_levels(from, reduced_u, reduced_v, squared, live);
  const bool is_one_level = sampler.mipmaps == MipmapFilter::nearest || level == texture.level_count() - 1 || none((squared > 1.0f) & mask_of(live));
  if (is_one_level) return sample_level(from, level, reduced_u, reduced_v, mask_of(live));
  const F weight = level_of_detail(squared_at_least_1) - static_cast<float>(level);
  return mix_two_levels(from, level, reduced_u, reduced_v, weight, live);
}

/// Weights of 8 bits and other footprints than the usual are not read on the short way. In one comparison.
HWY_INLINE bool is_usual(const Sampler& sampler) {
  return (static_cast<unsigned>(sampler.weights) | static_cast<unsigned>(sampler.footprint)) == 0;
}

template <Precision P>
Vec4<Float<P>> sample_lanes(const Texture& texture, const Sampler& sampler, Float<P> u, Float<P> v, std::uint32_t live, LevelGuess& guess) {
  using F = Float<P>;
  if (live == 0) return Vec4<F>(F(0.0f), F(0.0f), F(0.0f), F(0.0f));  // a program may ask when it has discarded all
  if (is_everyday(texture, sampler) && is_usual(sampler)) return filtered<F>({texture, sampler}, u, v, live, guess);
  return sample(texture, sampler, {u, v, F(0.0f)}, F(0.0f), mask_of(live));
}

template Vec4<Float<Precision::exact>> sample_lanes(const Texture&, const Sampler&, Float<Precision::exact>, Float<Precision::exact>, std::uint32_t, LevelGuess&);
template Vec4<Float<Precision::fused_multiply_add>> sample_lanes(const Texture&, const Sampler&, Float<Precision::fused_multiply_add>, Float<Precision::fused_multiply_add>, std::uint32_t, LevelGuess&);
template Vec4<Float<Precision::fast_power>> sample_lanes(const Texture&, const Sampler&, Float<Precision::fast_power>, Float<Precision::fast_power>, std::uint32_t, LevelGuess&);
template Vec4<Float<Precision::fast>> sample_lanes(const Texture&, const Sampler&, Float<Precision::fast>, Float<Precision::fast>, std::uint32_t, LevelGuess&);

template <Precision P>
Vec4<Float<P>> sample_lanes_at_level(const Texture& texture, const Sampler& sampler, Float<P> u, Float<P> v, Float<P> level, std::uint32_t live) {
  using F = Float<P>;
  if (live == 0) return Vec4<F>(F(0.0f), F(0.0f), F(0.0f), F(0.0f));
  if (!is_everyday(texture, sampler) || !is_usual(sampler)) return sample_at_level(texture, sampler, Vec3<F>(u, v, F(0.0f)), level, mask_of(live));
  const CodeReader from{texture, sampler};
  const F reduced_u = reduce_coordinate(u, sampler.wrap_u), reduced_v = reduce_coordinate(v, sampler.wrap_v);
  if (sampler.mipmaps == MipmapFilter::none || texture.level_count() == 1) return sample_level(from, 0, reduced_u, reduced_v, mask_of(live));
  return mix_levels(texture, sampler, level, mask_of(live),
                    [&](int number, Mask here) HWY_ATTR { return sample_level(from, number, reduced_u, reduced_v, here & mask_of(live)); });
}

template Vec4<Float<Precision::exact>> sample_lanes_at_level(const Texture&, const Sampler&, Float<Precision::exact>, Float<Precision::exact>, Float<Precision::exact>, std::uint32_t);
template Vec4<Float<Precision::fused_multiply_add>> sample_lanes_at_level(const Texture&, const Sampler&, Float<Precision::fused_multiply_add>, Float<Precision::fused_multiply_add>, Float<Precision::fused_multiply_add>, std::uint32_t);
template Vec4<Float<Precision::fast_power>> sample_lanes_at_level(const Texture&, const Sampler&, Float<Precision::fast_power>, Float<Precision::fast_power>, Float<Precision::fast_power>, std::uint32_t);
template Vec4<Float<Precision::fast>> sample_lanes_at_level(const Texture&, const Sampler&, Float<Precision::fast>, Float<Precision::fast>, Float<Precision::fast>, std::uint32_t);

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();
