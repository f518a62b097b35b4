// Records of 16 bytes in memory, a field a register: loaded by index and stored in order.

#if defined(TUBERIA_RASTER_SIMD_RECORDS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_RECORDS_INL
#undef TUBERIA_RASTER_SIMD_RECORDS_INL
#else
#define TUBERIA_RASTER_SIMD_RECORDS_INL
#endif

#include <cstddef>

#include "raster/simd/number-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

// Four numbers of 32 bits: what a register is made of on every machine.
using BlockTag = hn::FixedTag<std::int32_t, 4>;
inline constexpr int kBlocks = kLanes / 4;

/// Rows and columns of the 4x4 numbers in each block of four registers change places.
HWY_INLINE void transpose_blocks(Int& a, Int& b, Int& c, Int& d) {
  const hn::RepartitionToWide<IntTag> wide;
  const auto ab_low = hn::BitCast(wide, hn::InterleaveLower(IntTag{}, a.v, b.v));
  const auto ab_high = hn::BitCast(wide, hn::InterleaveUpper(IntTag{}, a.v, b.v));
  const auto cd_low = hn::BitCast(wide, hn::InterleaveLower(IntTag{}, c.v, d.v));
  const auto cd_high = hn::BitCast(wide, hn::InterleaveUpper(IntTag{}, c.v, d.v));
  a = Int(hn::BitCast(IntTag{}, hn::InterleaveLower(wide, ab_low, cd_low)));
  b = Int(hn::BitCast(IntTag{}, hn::InterleaveUpper(wide, ab_low, cd_low)));
  c = Int(hn::BitCast(IntTag{}, hn::InterleaveLower(wide, ab_high, cd_high)));
  d = Int(hn::BitCast(IntTag{}, hn::InterleaveUpper(wide, ab_high, cd_high)));
}

/// A register of blocks: block b is the 16 bytes at at(b).
template <class At>
HWY_INLINE Int load_blocks(const At& at) {
  const auto block = [&](int b) HWY_ATTR { return hn::LoadU(BlockTag{}, at(b)); };
  if constexpr (kBlocks == 1) {
    return Int(block(0));
  } else {
    const hn::CappedTag<std::int32_t, 8> two;
    const auto pair = [&](int b) HWY_ATTR { return hn::Combine(two, block(b + 1), block(b)); };
    if constexpr (kBlocks == 2) return Int(pair(0));
    else return Int(hn::Combine(IntTag{}, pair(2), pair(0)));
  }
}

/// The four fields of as many records as a register has lanes; where(lane) is where a record begins.
/// Reads a record at once, which is several times as fast as gathering its fields one by one.
template <class Where>
HWY_INLINE void load_records(const Where& where, Int (&field)[4]) {
  for (int j = 0; j < 4; ++j) field[j] = load_blocks([&](int b) HWY_ATTR { return where(4 * b + j); });
  transpose_blocks(field[0], field[1], field[2], field[3]);
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
