// Chosen lanes moved to the front of a register.

#if defined(TUBERIA_RASTER_SIMD_PACKING_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_PACKING_INL
#undef TUBERIA_RASTER_SIMD_PACKING_INL
#else
#define TUBERIA_RASTER_SIMD_PACKING_INL
#endif

#include <array>

#include "raster/simd/narrow-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

// Row `chosen` lists the lanes whose bit is set. (The library has such tables, too, but g++ copies
// them to the stack at every use.)
inline constexpr std::size_t kPackingRows = kLanes > 8 ? 1 : std::size_t{1} << kLanes;
inline constexpr auto kPackedLanes = [] {
  std::array<std::array<std::uint8_t, kLanes>, kPackingRows> rows{};
  for (std::size_t chosen = 0; chosen < kPackingRows; ++chosen)
    for (std::size_t lane = 0, next = 0; lane < static_cast<std::size_t>(kLanes); ++lane)
      if ((chosen >> lane & 1u) != 0) rows[chosen][next++] = static_cast<std::uint8_t>(lane);
  return rows;
}();

/// Moves the lanes of `chosen` (bit i is lane i) to the front, in order; what follows them is anything.
class LanePacking {
 public:
#if HWY_TARGET == HWY_AVX3
  HWY_INLINE explicit LanePacking(std::uint32_t chosen) : chosen_(mask_of(chosen)) {}
  HWY_INLINE Int operator()(Int a) const { return Int(hn::Compress(a.v, hn::RebindMask(IntTag{}, chosen_.m))); }

 private:
  Mask chosen_;
#else
  HWY_INLINE explicit LanePacking(std::uint32_t chosen)
      : lanes_(hn::IndicesFromVec(IntTag{}, load_narrow(kPackedLanes[chosen].data()).v)) {}
  HWY_INLINE Int operator()(Int a) const { return Int(hn::TableLookupLanes(a.v, lanes_)); }

 private:
  decltype(hn::IndicesFromVec(IntTag{}, hn::Zero(IntTag{}))) lanes_;
#endif
};

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
