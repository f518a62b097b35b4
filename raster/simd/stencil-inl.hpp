// The stencil test of one group of fragments.

#if defined(TUBERIA_RASTER_SIMD_STENCIL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_STENCIL_INL
#undef TUBERIA_RASTER_SIMD_STENCIL_INL
#else
#define TUBERIA_RASTER_SIMD_STENCIL_INL
#endif

#include "raster/simd/depth-inl.hpp"
#include "raster/simd/narrow-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// The codes that an operation makes of the stored ones, 0..255.
HWY_INLINE Int stencil_result(StencilOperation operation, Int stored, std::uint8_t reference) {
  const Int most(255);
  switch (operation) {
    case StencilOperation::keep: break;
    case StencilOperation::zero: return Int(0);
    case StencilOperation::replace: return Int(reference);
    case StencilOperation::increment: return min(stored + Int(1), most);
    case StencilOperation::decrement: return max(stored - Int(1), Int(0));
    case StencilOperation::invert: return stored ^ most;
    case StencilOperation::increment_wrap: return (stored + Int(1)) & most;
    case StencilOperation::decrement_wrap: return (stored - Int(1)) & most;
  }
  return stored;
}

/// Stencil test, then depth test of the fragments that pass; both buffers are brought up to date.
/// The live fragments that pass both.
HWY_INLINE Mask stencil_and_depth_test(Mask live, Int code, const StencilFace& face, const OutputState& state,
                                       std::uint8_t* stencil, std::int32_t* depth) {
  const Int stored = load_narrow(stencil);
  const Int mask(face.read_mask);
  const Mask matching = live & compare(Int(face.reference) & mask, stored & mask, face.test);
  const Mask passing = depth_test(matching, code, state, depth);
  const Int of_depth = select(passing, stencil_result(face.pass, stored, face.reference),
                              stencil_result(face.depth_fail, stored, face.reference));
  const Int result = select(matching, of_depth, stencil_result(face.fail, stored, face.reference));
  const Int written(face.write_mask);
  store_narrow_where(live, (stored & ~written) | (result & written), stencil);
  return passing;
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
