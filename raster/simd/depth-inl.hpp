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

/// The nearest 16-bit code of a depth in [0, 1]. The product with 65535 would be rounded, past the
/// border of two codes for one depth in 250; 65536 times the depth is exact, and what is too much in
/// it, once the depth, only decides about one code up or down.
template <class F>
HWY_INLINE Int code16(F depth) {
  const F scaled = depth * 65536.0f;
  const F whole = floor(scaled), rest = scaled - whole;
  const Int one_more = select(rest - 0.5f >= depth, Int(1), Int(0));
  const Int one_less = select(rest < depth - 0.5f, Int(1), Int(0));
  return truncate_to_int(whole) + one_more - one_less;
}

/// The nearest 24-bit code of a depth in [0, 1]: floor(depth * 16777215 + 1/2). With one rounding, towards
/// zero, or with the usual three: the code is right for every float there is (tried out).
template <class F>
HWY_INLINE Int code24(F depth) {
#if HWY_TARGET == HWY_AVX3
  return truncate_to_int(F(hn::Vec<FloatTag>{_mm512_fmadd_round_ps(depth.v.raw, F(16777215.0f).v.raw, F(0.5f).v.raw,
                                                                   _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC)}));
#else
  return round_half_up(depth * 16777215.0f);
#endif
}

/// Depth in [0, 1] as the buffer stores it: floor(depth * (2^n - 1) + 1/2), or the float's bits.
/// All codes order as signed integers.                                              [rules Z1, Z2]
template <class F>
HWY_INLINE Int depth_code(F depth, const OutputState& state) {
  const F clamped = min(max(depth, state.min_depth), state.max_depth);
  // Adding 0 turns -0 into 0, whose bits order before those of every positive number.
  if (state.depth_format == DepthFormat::d32f) return bits_of(clamped + 0.0f);
  if (state.depth_format == DepthFormat::d16) return code16(clamped);
  return code24(clamped);
}

HWY_INLINE Mask compare(Int code, Int stored, Compare test) {
  if (test == Compare::less) return code < stored;  // nearly always: no jump by table
  switch (test) {
    case Compare::less: break;
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
