// Texture sampling of every kind, format and filter: rows, boxes and cube maps, floats and depths,
// anisotropic filtering; with the derivatives of a quad of fragments, or given ones.

#include <span>

#include "raster/sample_texture.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "raster/simd/texture_kinds_kernels.cpp"
#include "raster/simd/every_instruction_set.hpp"

#include "raster/simd/cube_map-inl.hpp"
#include "raster/simd/quad-inl.hpp"
#include "raster/simd/texture-inl.hpp"
#include "raster/simd/texture_grid-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

template <class F>
HWY_INLINE Vec4<F> sample_one_level(const Texture& texture, int number, const Sampler& sampler, const Place<F>& place) {
  const TextureLevel& level = texture.level(number);
  return texture.kind() == TextureKind::cube ? sample_cube(texture, level, sampler, place) : sample_grid(texture, level, sampler, place);
}

template <class F>
HWY_NOINLINE Vec4<F> sample_mixed(const Texture& texture, const Sampler& sampler, const Place<F>& place, const F& level_of_detail, const Mask& live) {
  if (sampler.mipmaps == MipmapFilter::none || texture.level_count() == 1) return sample_one_level(texture, 0, sampler, place);
  return mix_levels(texture, sampler, level_of_detail, live,
                    [&](int level, Mask) HWY_ATTR { return sample_one_level(texture, level, sampler, place); });
}

/// The steps to the next pixels in texels of level 0: for a cube map those of the direction, projected
/// on the face that it meets.
template <class F>
struct Steps {
  Vec3<F> x, y;
};

template <class F>
HWY_INLINE Vec3<F> size_in_texels(const Texture& texture) {
  const TextureLevel& base = texture.level(0);
  const auto of = [](bool has, int size) HWY_ATTR { return F(has ? static_cast<float>(size) : 0.0f); };
  return {of(true, base.width), of(texture.kind() != TextureKind::one_dimensional, base.height),
          of(texture.kind() == TextureKind::three_dimensional, base.slices)};
}

template <class F>
HWY_INLINE Steps<F> projected_steps(const Texture& texture, const Vec3<F>& direction, const Steps<F>& steps) {
  const CubeFace face = face_of(direction);
  const Vec3<F> frame = in_frame(face, direction, -direction);
  const F s = frame.x / frame.z, t = frame.y / frame.z;
  const float half_size = static_cast<float>(texture.level(0).width) * 0.5f;
  const auto projected = [&](const Vec3<F>& step) HWY_ATTR {
    const Vec3<F> moved = in_frame(face, step, -step);
    return Vec3<F>((moved.x - s * moved.z) / frame.z * half_size, (moved.y - t * moved.z) / frame.z * half_size, F(0.0f));
  };
  return {projected(steps.x), projected(steps.y)};
}

/// What a pixel covers of the texture: an ellipse.
template <class F>
struct PixelFootprint {
  F level_of_detail;
  F taps;              // whole, 1..16: how many samples are taken along the longer axis
  F along_x, along_y;  // the longer axis as so many steps to the next pixels, with Euclidean length 1
};

/// Not filtered anisotropically: the larger step decides, or the ellipse's longer axis.  [rules T3]
template <class F>
HWY_INLINE PixelFootprint<F> round_footprint(const Steps<F>& texels, Footprint form) {
  const F x_x = dot(texels.x, texels.x), y_y = dot(texels.y, texels.y);
  const F squared = form == Footprint::ellipse ? squared_longer_axis(x_x, dot(texels.x, texels.y), y_y) : max(x_x, y_y);
  return {log2(squared) * 0.5f, F(1.0f), F(0.0f), F(0.0f)};
}

/// The ellipse whose axes are the singular values of the matrix of both steps: `longest` is the
/// larger one's square, `area` their product. The level follows from the shorter axis, or from the
/// part of the longer one that each of the most samples has to cover.          [rules T3, case 38]
template <class F>
HWY_INLINE PixelFootprint<F> elliptic_footprint(const Steps<F>& texels, float max_anisotropy) {
  const F a = dot(texels.x, texels.x), b = dot(texels.x, texels.y), c = dot(texels.y, texels.y);
  const F half = (a - c) * 0.5f;
  const F root = sqrt(half * half + b * b);
  const F longest = squared_longer_axis(a, b, c);
  const F area = length(cross(texels.x, texels.y));
  const F ratio = select(area * max_anisotropy > longest, longest / area, F(max_anisotropy));
  const F eta = select((longest > 0.0f) & (ratio > 1.0f), ratio, F(1.0f));

  // The eigenvector of ((a, b), (b, c)) for its eigenvalue `longest`, by the row that loses no digits.
  const Mask x_longer = half >= 0.0f;
  const F along_x = select(x_longer, half + root, b), along_y = select(x_longer, b, root - half);
  const F squared = along_x * along_x + along_y * along_y;
  const Mask is_circle = !(squared > 0.0f);
  const F scale = 1.0f / sqrt(select(is_circle, F(1.0f), squared));
  return {log2(longest) * 0.5f - log2(eta), -floor(-eta), select(is_circle, F(1.0f), along_x * scale), select(is_circle, F(0.0f), along_y * scale)};
}

/// The longer and the shorter step in place of the axes, however they lie to each other.
template <class F>
HWY_INLINE PixelFootprint<F> stepped_footprint(const Steps<F>& texels, float max_anisotropy) {
  const F a = dot(texels.x, texels.x), c = dot(texels.y, texels.y);
  const Mask x_longer = a >= c;
  const F longest = max(a, c), shortest = min(a, c);
  const F ratio = select(shortest * (max_anisotropy * max_anisotropy) > longest, sqrt(longest / shortest), F(max_anisotropy));
  const F eta = select((longest > 0.0f) & (ratio > 1.0f), ratio, F(1.0f));
  return {log2(longest) * 0.5f - log2(eta), -floor(-eta), select(x_longer, F(1.0f), F(0.0f)), select(x_longer, F(0.0f), F(1.0f))};
}

/// The mean of several samples along the footprint's longer axis, evenly spaced; kept as a running
/// mean, which leaves a constant texture's colour exactly as it is.
template <class F>
HWY_NOINLINE Vec4<F> sample_along(const Texture& texture, const Sampler& sampler, const Place<F>& place, const Steps<F>& steps,
                                  const PixelFootprint<F>& footprint, const Mask& live) {
  const Vec3<F> axis = steps.x * footprint.along_x + steps.y * footprint.along_y;
  const Mask several = footprint.taps > 1.0f;
  Vec4<F> mean{F(0.0f), F(0.0f), F(0.0f), F(0.0f)};
  for (int i = 0; i < 16; ++i) {
    const Mask taken = live & (footprint.taps > static_cast<float>(i));
    if (none(taken)) break;
    const F offset = (static_cast<float>(i) + 0.5f) / footprint.taps - 0.5f;
    const auto moved = [&](F at, F along) HWY_ATTR { return select(several, at + along * offset, at); };
    const Place<F> tap{{moved(place.at.x, axis.x), moved(place.at.y, axis.y), moved(place.at.z, axis.z)}, place.reference};
    const Vec4<F> colour = sample_mixed(texture, sampler, tap, footprint.level_of_detail, taken);
    mean = i == 0 ? colour : select(taken, mean + (colour - mean) * F(1.0f / static_cast<float>(i + 1)), mean);
  }
  return mean;
}

/// Samples with the steps in texture coordinates; lanes of `has_level` with the given level instead.
template <class F>
HWY_NOINLINE Vec4<F> sample_with_steps(const Texture& texture, const Sampler& sampler, const Place<F>& place, const Steps<F>& steps,
                                       const Steps<F>& texels, const F& given_level, const Mask& has_level, const Mask& live) {
  const bool is_round = !(sampler.max_anisotropy > 1) || texture.kind() == TextureKind::one_dimensional;
  const float most = sampler.max_anisotropy < 16 ? sampler.max_anisotropy : 16.0f;
  PixelFootprint<F> footprint = is_round ? round_footprint(texels, sampler.footprint)
                                : sampler.footprint == Footprint::steps ? stepped_footprint(texels, most) : elliptic_footprint(texels, most);
  footprint.level_of_detail = select(has_level, given_level, footprint.level_of_detail);
  if (is_round) return sample_mixed(texture, sampler, place, footprint.level_of_detail, live);
  footprint.taps = select(has_level, F(1.0f), footprint.taps);
  return sample_along(texture, sampler, place, steps, footprint, live);
}

template <class F>
HWY_INLINE Vec3<F> load_triple(const float* from) { return {load<F>(from), load<F>(from + kLanes), load<F>(from + 2 * kLanes)}; }

template <class F>
HWY_INLINE void store_colour(const Vec4<F>& colour, float* rgba) {
  store(colour.x, rgba);
  store(colour.y, rgba + kLanes);
  store(colour.z, rgba + 2 * kLanes);
  store(colour.w, rgba + 3 * kLanes);
}

/// Multiplies, and drops the coordinates that the texture lacks even if they are not finite.
template <class F>
HWY_INLINE Vec3<F> scaled(const Vec3<F>& v, const Vec3<F>& size) {
  const auto one = [](F a, F s) HWY_ATTR { return select(s > 0.0f, a * s, F(0.0f)); };
  return {one(v.x, size.x), one(v.y, size.y), one(v.z, size.z)};
}

template <class F>
HWY_INLINE Steps<F> quad_steps(const Vec3<F>& v) {
  const auto x = [](F a) HWY_ATTR { return first_of_quad(first_difference_x(a)); };
  const auto y = [](F a) HWY_ATTR { return first_of_quad(first_difference_y(a)); };
  return {{x(v.x), x(v.y), x(v.z)}, {y(v.x), y(v.y), y(v.z)}};
}

template <Precision P>
void sample_any_lanes(const Texture& texture, const Sampler& sampler, const float* at, std::uint32_t live, float* rgba) {
  using F = Float<P>;
  const Place<F> place{load_triple<F>(at), load<F>(at + 3 * kLanes)};
  const Steps<F> steps = quad_steps(place.at);
  const Steps<F> texels = texture.kind() == TextureKind::cube ? projected_steps(texture, place.at, steps)
                                                               : quad_steps(scaled(place.at, size_in_texels<F>(texture)));
  store_colour(sample_with_steps(texture, sampler, place, steps, texels, F(0.0f), mask_of(0), mask_of(live)), rgba);
}

template void sample_any_lanes<Precision::exact>(const Texture&, const Sampler&, const float*, std::uint32_t, float*);
template void sample_any_lanes<Precision::fused_multiply_add>(const Texture&, const Sampler&, const float*, std::uint32_t, float*);
template void sample_any_lanes<Precision::fast_power>(const Texture&, const Sampler&, const float*, std::uint32_t, float*);
template void sample_any_lanes<Precision::fast>(const Texture&, const Sampler&, const float*, std::uint32_t, float*);

template <Precision P>
void sample_any_lanes_at_level(const Texture& texture, const Sampler& sampler, const float* at, std::uint32_t live, float* rgba) {
  using F = Float<P>;
  const Place<F> place{load_triple<F>(at), F(0.0f)};
  store_colour(sample_mixed(texture, sampler, place, load<F>(at + 3 * kLanes), mask_of(live)), rgba);
}

template void sample_any_lanes_at_level<Precision::exact>(const Texture&, const Sampler&, const float*, std::uint32_t, float*);
template void sample_any_lanes_at_level<Precision::fused_multiply_add>(const Texture&, const Sampler&, const float*, std::uint32_t, float*);
template void sample_any_lanes_at_level<Precision::fast_power>(const Texture&, const Sampler&, const float*, std::uint32_t, float*);
template void sample_any_lanes_at_level<Precision::fast>(const Texture&, const Sampler&, const float*, std::uint32_t, float*);

/// Up to kLanes lookups, side by side.
struct LookupLanes {
  alignas(64) float at[3 * kLanes], dx[3 * kLanes], dy[3 * kLanes], reference[kLanes], level[kLanes];
  std::uint32_t has_level = 0;

  void set(int lane, const TextureLookup& lookup) {
    for (int k = 0; k < 3; ++k) {
      at[k * kLanes + lane] = lookup.at[k];
      dx[k * kLanes + lane] = lookup.dx[k];
      dy[k * kLanes + lane] = lookup.dy[k];
    }
    reference[lane] = lookup.reference;
    level[lane] = lookup.lod.value_or(0.0f);
    if (lookup.lod) has_level |= 1u << lane;
  }
};

template <Precision P>
void sample_lookups(const Texture& texture, const Sampler& sampler, std::span<const TextureLookup> lookups, std::span<Rgba32F> colours) {
  using F = Float<P>;
  const auto count = static_cast<int>(lookups.size());
  for (int first = 0; first < count; first += kLanes) {
    const int lanes = count - first < kLanes ? count - first : kLanes;
    LookupLanes in;
    for (int lane = 0; lane < kLanes; ++lane) in.set(lane, lookups[static_cast<std::size_t>(first + (lane < lanes ? lane : 0))]);

    const Place<F> place{load_triple<F>(in.at), load<F>(in.reference)};
    const Steps<F> steps{load_triple<F>(in.dx), load_triple<F>(in.dy)};
    const Vec3<F> size = size_in_texels<F>(texture);
    const Steps<F> texels = texture.kind() == TextureKind::cube ? projected_steps(texture, place.at, steps)
                                                                 : Steps<F>{scaled(steps.x, size), scaled(steps.y, size)};
    alignas(64) float rgba[4 * kLanes];
    const std::uint32_t live = 0xffffu >> (16 - lanes);
    store_colour(sample_with_steps(texture, sampler, place, steps, texels, load<F>(in.level), mask_of(in.has_level), mask_of(live)), rgba);
    for (int lane = 0; lane < lanes; ++lane)
      colours[static_cast<std::size_t>(first + lane)] = {rgba[lane], rgba[kLanes + lane], rgba[2 * kLanes + lane], rgba[3 * kLanes + lane]};
  }
}

inline void sample_lookups_in(Precision precision, const Texture& texture, const Sampler& sampler, std::span<const TextureLookup> lookups,
                              std::span<Rgba32F> colours) {
  if (precision == Precision::fast) sample_lookups<Precision::fast>(texture, sampler, lookups, colours);
  else sample_lookups<Precision::exact>(texture, sampler, lookups, colours);
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tuberia {

void sample_texture(const Texture& texture, const Sampler& sampler, std::span<const TextureLookup> lookups,
                    std::span<Rgba32F> colours, InstructionSet instruction_set, Precision precision) {
  const std::size_t count = lookups.size() < colours.size() ? lookups.size() : colours.size();
  TUBERIA_RETURN_FOR(instruction_set, sample_lookups_in(precision, texture, sampler, lookups.first(count), colours))
}

Rgba32F sample_texture(const Texture& texture, const Sampler& sampler, const TextureLookup& lookup) {
  Rgba32F colour;
  sample_texture(texture, sampler, std::span(&lookup, 1), std::span(&colour, 1));
  return colour;
}

}  // namespace tuberia
#endif
