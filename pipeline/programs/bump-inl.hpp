// Relief for a register of fragments: the definitions are in math/bump.hpp.            [A 1.2] [B 4.2.1]

#if defined(TUBERIA_PIPELINE_PROGRAMS_BUMP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_PIPELINE_PROGRAMS_BUMP_INL
#undef TUBERIA_PIPELINE_PROGRAMS_BUMP_INL
#else
#define TUBERIA_PIPELINE_PROGRAMS_BUMP_INL
#endif

#include "math/bump.hpp"
#include "pipeline/programs/bump_map.hpp"
#include "pipeline/programs/noise-inl.hpp"
#include "raster/simd/elementary-inl.hpp"
#include "raster/simd/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// Tangents dp/du and dp/dv, lengths kept, and the unit normal.
template <class F>
struct SurfaceBasis {
  Vec3<F> tangent, bitangent, normal;
};

/// The unit normal tilted by a height's slopes, both times `flatness` (>= 0); see perturbed_normal in
/// math/bump.hpp, which is the same with a flatness of 1.                             [FIX 10]
template <class F>
HWY_INLINE Vec3<F> tilted_normal(const SurfaceBasis<F>& basis, Vec2<F> slope, F flatness) {
  const Vec3<F> n = basis.normal;
  const Vec3<F> across_v = cross(n, basis.bitangent), across_u = cross(basis.tangent, n);
  const F area = dot(cross(basis.tangent, basis.bitangent), n);
  const Mask is_frame = (abs(area) > length(across_u) * length(across_v) * 1e-6f) & (abs(area) <= 3.4028235e38f);
  const F steepest = max(abs(slope.x), abs(slope.y));
  const Mask tilts = is_frame & (steepest > 0.0f) & (abs(slope.x) + abs(slope.y) <= 3.4028235e38f);
  if (none(tilts)) return n;

  const Mask mirrored = area < 0.0f;
  const F slope_u = select(mirrored, -slope.x, slope.x), slope_v = select(mirrored, -slope.y, slope.y);
  const Vec3<F> tilted = normalize(n * (flatness * abs(area)) + across_v * slope_u + across_u * slope_v);
  return {select(tilts, tilted.x, n.x), select(tilts, tilted.y, n.y), select(tilts, tilted.z, n.z)};
}

template <class F>
HWY_NOINLINE Vec2<F> wave_slope(const Vec2<F>& uv, float scale) {
  const F u = uv.x * scale, v = uv.y * scale;
  const F both = sine_cosine_of_turns(u + v).cosine, slope(6.28318531f / 3 * scale);
  return {slope * (sine_cosine_of_turns(u).cosine + both), slope * (sine_cosine_of_turns(v).cosine + both)};
}

template <class F>
HWY_NOINLINE Vec2<F> orange_slope(const Vec2<F>& uv, float scale, std::uint32_t seed) {
  const float period = static_cast<float>(relief_period(static_cast<double>(scale)));
  const F x = bounded_lattice_coordinate(uv.x * scale), y = bounded_lattice_coordinate(uv.y * scale);
  const F cell_x = floor(x), cell_y = floor(y), within_x = x - cell_x, within_y = y - cell_y;
  Vec2<F> slope{F(0.0f), F(0.0f)};
  for (int square = 0; square < 9; ++square) {
    const float i = static_cast<float>(square % 3 - 1), j = static_cast<float>(square / 3 - 1);
    const Int h = scrambled(lattice_term(wrapped_cell(cell_x + i, period), 0) + lattice_term(wrapped_cell(cell_y + j, period), 1) + seed_term(seed));
    const auto tenbits = [](Int bits) HWY_ATTR { return to_float<F>(bits & Int(1023)) * (1.0f / 1024); };
    const Vec2<F> away{within_x - i - tenbits(h), within_y - j - tenbits(shift_right<10>(h))};
    const F radius = mul_add(tenbits(shift_right<20>(h)), F(0.3f), F(0.35f));
    const F inverse_square = reciprocal(radius * radius);
    const F inside = positive_part(1.0f - dot(away, away) * inverse_square);
    slope = slope + away * (inside * inverse_square * (4 * scale));
  }
  return slope;
}

template <class F>
HWY_INLINE Vec2<F> rough_slope(const Vec2<F>& uv, float scale, std::uint32_t seed) {
  const float period = static_cast<float>(relief_period(static_cast<double>(scale)));
  const Vec2<F> coarse = gradient_noise(uv * F(scale), period, seed).slope;
  return (coarse + gradient_noise(uv * F(2 * scale), 2 * period, seed + 1).slope) * F(scale / 1.5f);
}

/// Central differences over one texel of the first level each way, so that neighbouring fragments that see
/// one smooth picture get one smooth relief.                                                  [A 1.2]
template <class Reader, class F>
HWY_INLINE Vec2<F> texture_slope(Reader& in, const BumpMap& bump, Vec2<F> uv) {
  const TextureLevel& base = bump.texture->level(0);
  const float step_u = 1.0f / static_cast<float>(base.width), step_v = 1.0f / static_cast<float>(base.height);
  // One call in a loop: sampling is a good deal of code.
  F height[4];
  for (int i = 0; i < 4; ++i) {
    const float sign = i % 2 == 0 ? 1.0f : -1.0f;
    const Vec2<F> at{uv.x + (i < 2 ? sign * step_u : 0.0f), uv.y + (i < 2 ? 0.0f : sign * step_v)};
    height[i] = in.sample(*bump.texture, bump.sampler, at).x;
  }
  return {(height[0] - height[1]) * (0.5f / step_u), (height[2] - height[3]) * (0.5f / step_v)};
}

template <class Reader, class F>
HWY_INLINE Vec3<F> normal_from_picture(Reader& in, const BumpMap& bump, Vec2<F> uv, const SurfaceBasis<F>& basis) {
  const Vec4<F> code = in.sample(*bump.texture, bump.sampler, uv);
  const auto component = [](F c) HWY_ATTR { return mul_add(c, F(2.0f), F(-1.0f)); };
  const F x = component(code.x) * bump.gain, y = component(code.y) * bump.gain;
  return tilted_normal(basis, {-x * length(basis.tangent), y * length(basis.bitangent)}, max(component(code.z), 0.0f));
}

/// The unit normal that relief gives a surface. in: samples textures.
template <class Reader, class F>
HWY_INLINE Vec3<F> bumped_normal(Reader& in, const BumpMap& bump, Vec2<F> uv, const SurfaceBasis<F>& basis) {
  if (bump.kind == BumpMap::Kind::none || bump.gain == 0) return basis.normal;
  if (bump.kind == BumpMap::Kind::normal_map) return normal_from_picture(in, bump, uv, basis);
  const Vec2<F> slope = bump.kind == BumpMap::Kind::height_texture ? texture_slope(in, bump, uv)
                        : bump.kind == BumpMap::Kind::waves        ? wave_slope(uv, bump.scale)
                        : bump.kind == BumpMap::Kind::orange       ? orange_slope(uv, bump.scale, bump.seed)
                                                                   : rough_slope(uv, bump.scale, bump.seed);
  return tilted_normal(basis, slope * F(bump.gain), F(1.0f));
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
