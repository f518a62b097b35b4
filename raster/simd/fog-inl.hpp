// Fog of one group of fragments, and what their alpha decides.

#if defined(TUBERIA_RASTER_SIMD_FOG_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_FOG_INL
#undef TUBERIA_RASTER_SIMD_FOG_INL
#else
#define TUBERIA_RASTER_SIMD_FOG_INL
#endif

#include "raster/simd/elementary-inl.hpp"
#include "raster/simd/vector-inl.hpp"
#include "raster/tile.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// The share of the fragment's colour that is left at a fog coordinate.
template <class F>
HWY_INLINE F fog_share(F coordinate, const FogState& fog) {
  constexpr float kLog2OfE = 1.44269504f;
  if (fog.mode == FogMode::linear) return saturate((fog.end - coordinate) / F(fog.end - fog.start));
  const F thickness = coordinate * fog.density;
  const F exponent = fog.mode == FogMode::exp ? thickness : thickness * thickness;
  return saturate(exp2(exponent * -kLog2OfE));
}

template <class F>
HWY_INLINE F fogged(F colour, float fog_colour, F share) {
  return mul_add(share, colour - F(fog_colour), F(fog_colour));
}

template <class F>
HWY_INLINE Mask compare_alpha(F alpha, float reference, Compare test) {
  switch (test) {
    case Compare::less: return alpha < reference;
    case Compare::less_equal: return alpha <= reference;
    case Compare::greater: return alpha > reference;
    case Compare::greater_equal: return alpha >= reference;
    case Compare::equal: return alpha == reference;
    case Compare::not_equal: return !(alpha == reference);
    case Compare::always: return all_lanes();
    case Compare::never: break;
  }
  return !all_lanes();
}

/// How many of n samples a fragment of this alpha keeps: floor(alpha n + 1/2), alpha in [0, 1].
template <class F>
HWY_INLINE Int samples_of_alpha(F alpha, int samples) {
  return round_half_up(alpha * static_cast<float>(samples));
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
