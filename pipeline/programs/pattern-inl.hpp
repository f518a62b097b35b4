// Procedural textures for a register of fragments: the definitions are in math/patterns.hpp. Boxes and
// bands are as wide as what changes from a fragment to the next of its quad.

#if defined(TUBERIA_PIPELINE_PROGRAMS_PATTERN_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_PIPELINE_PROGRAMS_PATTERN_INL
#undef TUBERIA_PIPELINE_PROGRAMS_PATTERN_INL
#else
#define TUBERIA_PIPELINE_PROGRAMS_PATTERN_INL
#endif

#include "pipeline/programs/noise-inl.hpp"
#include "pipeline/programs/pattern.hpp"
#include "pipeline/programs/transformed-inl.hpp"
#include "raster/simd/elementary-inl.hpp"
#include "raster/simd/quad-inl.hpp"
#include "raster/simd/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// The larger of a number's steps to the next fragment to the right and down.
template <class F>
HWY_INLINE F quad_width(F a) { return bounded_lattice_coordinate(max(abs(difference_x(a)), abs(difference_y(a)))); }

inline constexpr float kNarrowestBox = 1.0f / 1024;  // narrower ones count as points

/// The place within one period, 2, of the checker's wave.
template <class F>
HWY_INLINE F in_period(F x) { return x - 2.0f * floor(x * 0.5f); }

/// The mean over a box of the wave that is 1 on [0, 1), -1 on [1, 2) and so on: differences of its
/// integral, a triangle wave.
template <class F>
HWY_INLINE F mean_square_wave(F x, F width) {
  const F place = in_period(x);
  const F point = select(place < 1.0f, F(1.0f), F(-1.0f));
  const Mask is_box = width >= kNarrowestBox;
  const F box = select(is_box, width, F(1.0f));
  const auto integral = [](F at) HWY_ATTR { return 1.0f - abs(in_period(at) - 1.0f); };
  return select(is_box, (integral(place + box * 0.5f) - integral(place - box * 0.5f)) / box, point);
}

/// The two squares along one axis that a box of at most one square's width reaches.
template <class F>
struct SquareReach {
  Int first;
  F weight_of_second;
  HWY_INLINE SquareReach(F at, F width) {
    const F box = min(max(width, kNarrowestBox), 1.0f);
    const F lower = floor(at - box * 0.5f);
    first = truncate_to_int(lower);
    weight_of_second = saturate(((at - lower) + box * 0.5f - 1.0f) / box);
  }
};

template <class F>
HWY_NOINLINE Vec3<F> random_square_shares(const Vec2<F>& at, const Vec2<F>& width, std::uint32_t seed) {
  const SquareReach<F> x(at.x, width.x), y(at.y, width.y);
  const auto square = [&](int i, int j) HWY_ATTR {
    const Int h = scrambled(lattice_term(x.first + Int(i), 0) + lattice_term(y.first + Int(j), 1) + seed_term(seed));
    const auto channel = [](Int bits) HWY_ATTR { return to_float<F>(bits & Int(1023)) * (1.0f / 1023); };
    return Vec3<F>(channel(h), channel(shift_right<10>(h)), channel(shift_right<20>(h)));
  };
  const auto row = [&](int j) HWY_ATTR { return mix(square(0, j), square(1, j), x.weight_of_second); };
  const Vec3<F> half(F(0.5f)), mean = mix(row(0), row(1), y.weight_of_second);
  return half + (mean - half) * (1.0f / (max(width.x, 1.0f) * max(width.y, 1.0f)));
}

template <class F>
HWY_INLINE F smooth_step_up(F t) { return t * t * (3.0f - 2.0f * t); }

/// band: without turbulence; where it changes fast, bands blur to their mean.
template <class F>
HWY_INLINE F faded_share(F share, float mean, F band) { return mul_add(share - mean, saturate(1.5f - quad_width(band)), F(mean)); }

template <class F>
HWY_NOINLINE F wood_share(const Vec3<F>& point, float turbulence_in_rings, std::uint32_t seed) {
  const F moved = F(turbulence_in_rings) * gradient_noise(Vec3<F>(point.x * 0.5f, point.y * 0.125f, point.z * 0.5f), seed);
  const F radius = sqrt(mul_add(point.z, point.z, point.x * point.x));
  const F ring = bounded_lattice_coordinate(radius + moved);
  const F phase = ring - floor(ring);
  const F share = smooth_step_up(select(phase < 0.75f, phase * (1.0f / 0.75f), (1.0f - phase) * 4.0f));
  return faded_share(share, static_cast<float>(kMeanWoodShare), radius);
}

template <class F>
HWY_NOINLINE F marble_share(const Vec3<F>& point, float turbulence_in_veins, std::uint32_t seed) {
  const F vein = bounded_lattice_coordinate(mul_add(F(turbulence_in_veins), turbulence(point, seed), point.x));
  const F wave = mul_add(sine_cosine_of_turns(vein).sine, F(0.5f), F(0.5f));
  return faded_share(wave * wave, static_cast<float>(kMeanMarbleShare), point.x);
}

/// The pattern's colour, linear RGB. uv: read by checker and random_squares; point: world space, by wood and marble.
/// In exact precision within 1e-5 of math/patterns.hpp's for coordinates up to 64 squares or bands.
template <class F>
HWY_INLINE Vec3<F> pattern_colour(const Pattern& pattern, Vec2<F> uv, Vec3<F> point) {
  if (pattern.kind == Pattern::Kind::none) return Vec3<F>(F(1.0f));
  Vec3<F> shares;
  if (is_of_texture_coordinates(pattern)) {
    const Vec2<F> at{bounded_lattice_coordinate(uv.x * pattern.scale), bounded_lattice_coordinate(uv.y * pattern.scale)};
    const Vec2<F> width{quad_width(at.x), quad_width(at.y)};
    shares = pattern.kind == Pattern::Kind::checker
                 ? Vec3<F>(mul_add(mean_square_wave(at.x, width.x) * F(-0.5f), mean_square_wave(at.y, width.y), F(0.5f)))
                 : random_square_shares(at, width, pattern.seed);
  } else {
    const Vec3<F> solid = transformed(pattern.pattern_from_world, point) * F(pattern.scale);
    shares = Vec3<F>(pattern.kind == Pattern::Kind::wood ? wood_share(solid, pattern.turbulence, pattern.seed)
                                                         : marble_share(solid, pattern.turbulence, pattern.seed));
  }
  const Vec3<F> first(pattern.first), second(pattern.second);
  return {mix(first.x, second.x, shares.x), mix(first.y, second.y, shares.y), mix(first.z, second.z, shares.z)};
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
