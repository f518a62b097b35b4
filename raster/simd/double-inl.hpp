// Doubles, half a register's floats of them: for what must be exact or rounded only once.

#if defined(TUBERIA_RASTER_SIMD_DOUBLE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_DOUBLE_INL
#undef TUBERIA_RASTER_SIMD_DOUBLE_INL
#else
#define TUBERIA_RASTER_SIMD_DOUBLE_INL
#endif

#include "raster/simd/number-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

using DoubleTag = hn::CappedTag<double, 8>;
using HalfFloatTag = hn::Rebind<float, DoubleTag>;
using HalfIntTag = hn::Rebind<std::int32_t, DoubleTag>;
inline constexpr int kDoubleLanes = static_cast<int>(hn::MaxLanes(DoubleTag{}));

struct Double {
  hn::Vec<DoubleTag> v;
  Double() = default;
  HWY_INLINE explicit Double(hn::Vec<DoubleTag> lanes) : v(lanes) {}
  HWY_INLINE Double(double all) : v(hn::Set(DoubleTag{}, all)) {}
};
struct DoubleMask {
  hn::Mask<DoubleTag> m;
};

HWY_INLINE Double operator+(Double a, Double b) { return Double(hn::Add(a.v, b.v)); }
HWY_INLINE Double operator-(Double a, Double b) { return Double(hn::Sub(a.v, b.v)); }
HWY_INLINE Double operator*(Double a, Double b) { return Double(hn::Mul(a.v, b.v)); }
HWY_INLINE Double operator/(Double a, Double b) { return Double(hn::Div(a.v, b.v)); }
HWY_INLINE DoubleMask operator>(Double a, Double b) { return {hn::Gt(a.v, b.v)}; }
HWY_INLINE DoubleMask operator<(Double a, Double b) { return {hn::Lt(a.v, b.v)}; }
HWY_INLINE DoubleMask operator>=(Double a, Double b) { return {hn::Ge(a.v, b.v)}; }
HWY_INLINE DoubleMask operator<=(Double a, Double b) { return {hn::Le(a.v, b.v)}; }
HWY_INLINE DoubleMask operator==(Double a, Double b) { return {hn::Eq(a.v, b.v)}; }
HWY_INLINE DoubleMask operator&(DoubleMask a, DoubleMask b) { return {hn::And(a.m, b.m)}; }
HWY_INLINE DoubleMask operator|(DoubleMask a, DoubleMask b) { return {hn::Or(a.m, b.m)}; }
HWY_INLINE DoubleMask operator!(DoubleMask a) { return {hn::Not(a.m)}; }
HWY_INLINE Double select(DoubleMask m, Double yes, Double no) { return Double(hn::IfThenElse(m.m, yes.v, no.v)); }
HWY_INLINE Double min(Double a, Double b) { return Double(hn::Min(a.v, b.v)); }
HWY_INLINE Double max(Double a, Double b) { return Double(hn::Max(a.v, b.v)); }
HWY_INLINE Double floor(Double a) { return Double(hn::Floor(a.v)); }
/// To the nearest whole number, ties to even.
HWY_INLINE Double round(Double a) { return Double(hn::Round(a.v)); }
HWY_INLINE std::uint32_t bits_of(DoubleMask a) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(DoubleTag{}, a.m, bytes);
  return bytes[0];
}

HWY_INLINE Double load_double(const float* from) {
  return Double(hn::PromoteTo(DoubleTag{}, hn::LoadU(HalfFloatTag{}, from)));
}
HWY_INLINE Double gather_double(const float* table, const std::uint32_t* index) {
  return Double(hn::PromoteTo(
      DoubleTag{}, hn::GatherIndex(HalfFloatTag{}, table, hn::LoadU(HalfIntTag{}, reinterpret_cast<const std::int32_t*>(index)))));
}
HWY_INLINE Double gather_double(const std::int32_t* table, const std::uint32_t* index) {
  return Double(hn::PromoteTo(
      DoubleTag{}, hn::GatherIndex(HalfIntTag{}, table, hn::LoadU(HalfIntTag{}, reinterpret_cast<const std::int32_t*>(index)))));
}
/// Rounded to nearest even.
HWY_INLINE void store(Double a, float* to) { hn::StoreU(hn::DemoteTo(HalfFloatTag{}, a.v), HalfFloatTag{}, to); }
/// A whole number of 32 bits.
HWY_INLINE void store(Double a, std::int32_t* to) { hn::StoreU(hn::DemoteTo(HalfIntTag{}, a.v), HalfIntTag{}, to); }
HWY_INLINE void store(Double a, double* to) { hn::StoreU(a.v, DoubleTag{}, to); }

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
