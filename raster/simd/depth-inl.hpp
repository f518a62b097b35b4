// The depth test of one group of fragments.

#if defined(TUBERIA_RASTER_SIMD_DEPTH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_DEPTH_INL
#undef TUBERIA_RASTER_SIMD_DEPTH_INL
#else
#define TUBERIA_RASTER_SIMD_DEPTH_INL
#endif

#include "raster/simd/number-inl.hpp"
#include "raster/tile.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// Depth in [0, 1] as the buffer stores it: floor(depth * (2^n - 1) + 1/2), or the float's bits.
/// All codes order as signed integers.                                              [rules Z1, Z2]
template <class F>
HWY_INLINE Int depth_code(F depth, const OutputState& state) {
  // Adding 0 turns -0 into 0, whose bits order before those of every positive number.
  const F clamped = min(max(depth, state.min_depth), state.max_depth) + 0.0f;
  if (state.depth_format == DepthFormat::d32f) return bits_of(clamped);

  const F scaled = clamped * (state.depth_format == DepthFormat::d16 ? 65535.0f : 16777215.0f);
  // Not floor(scaled + 1/2): just below one half that sum rounds up to 1.
  const F whole = floor(scaled);
  return truncate_to_int(select(scaled - whole >= 0.5f, whole + 1.0f, whole));
}

HWY_INLINE Mask compare(Int code, Int stored, Compare test) {
  switch (test) {
    case Compare::less: return code < stored;
    case Compare::less_equal: return !(stored < code);
    case Compare::greater: return stored < code;
    case Compare::greater_equal: return !(code < stored);
    case Compare::equal: return code == stored;
    case Compare::not_equal: return !(code == stored);
    case Compare::always: return all_lanes();
    case Compare::never: break;
  }
  return !all_lanes();
}

/// The live fragments that pass, whose depth is stored if the state says so.
HWY_INLINE Mask depth_test(Mask live, Int code, const OutputState& state, std::int32_t* stored) {
  if (state.depth.test != Compare::always) live = live & compare(code, load(stored), state.depth.test);
  if (state.depth.write) store_where(live, code, stored);
  return live;
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
