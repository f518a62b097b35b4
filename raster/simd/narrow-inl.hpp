// Numbers of 8 and 16 bits in memory: stencil codes and halves.

#if defined(TUBERIA_RASTER_SIMD_NARROW_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_NARROW_INL
#undef TUBERIA_RASTER_SIMD_NARROW_INL
#else
#define TUBERIA_RASTER_SIMD_NARROW_INL
#endif

#include "raster/simd/number-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// One number of 8 or 16 bits a lane: their code, without sign.
template <class Narrow>
HWY_INLINE Int load_narrow(const Narrow* from) {
  return Int(hn::PromoteTo(IntTag{}, hn::LoadU(hn::Rebind<Narrow, IntTag>{}, from)));
}
/// The lanes' lowest bits.
template <class Narrow>
HWY_INLINE void store_narrow(Int a, Narrow* to) {
  const hn::Rebind<Narrow, IntTag> narrow;
  hn::StoreU(hn::TruncateTo(narrow, hn::BitCast(UintTag{}, a.v)), narrow, to);
}
/// The same, where the mask says so.
template <class Narrow>
HWY_INLINE void store_narrow_where(Mask m, Int a, Narrow* to) {
  store_narrow(select(m, a, load_narrow(to)), to);
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
