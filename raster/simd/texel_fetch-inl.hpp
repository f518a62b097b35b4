// Texels from memory into registers: a plain load for each lane, and shuffles that put the lanes
// together. Gathers take up to three times as long where they are slow, and instruction sets
// without them do the same less well.

#if defined(TUBERIA_RASTER_SIMD_TEXEL_FETCH_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_TEXEL_FETCH_INL
#undef TUBERIA_RASTER_SIMD_TEXEL_FETCH_INL
#else
#define TUBERIA_RASTER_SIMD_TEXEL_FETCH_INL
#endif

#include "raster/simd/number-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// The indices of all lanes, two in each number, the lower lane's in its lower half: compilers take them
/// out of a register so, with half as many instructions as one by one. None may be below zero.
struct IndexPairs {
  alignas(64) std::uint64_t of[kLanes / 2];
  HWY_INLINE explicit IndexPairs(Int index) {
    const hn::Repartition<std::uint64_t, IntTag> tag;
    hn::Store(hn::BitCast(tag, index.v), tag, of);
  }
};

/// A register's worth of runs of kRun neighbours, one behind the other: the texels from the first
/// index on, then those from the second, and so on.
template <int kRun, class Tag>
HWY_INLINE hn::Vec<Tag> load_runs(Tag tag, const hn::TFromD<Tag>* texels, const std::uint64_t* index) {
  const hn::Half<Tag> half;
  constexpr int kPairsInHalf = static_cast<int>(hn::MaxLanes(half)) / kRun / 2;
  if constexpr (kPairsInHalf == 0)
    return hn::Combine(tag, hn::LoadU(half, texels + (*index >> 32)), hn::LoadU(half, texels + (*index & 0xffffffff)));
  else
    return hn::Combine(tag, load_runs<kRun>(half, texels, index + kPairsInHalf), load_runs<kRun>(half, texels, index));
}

/// The texel at each lane's index.
HWY_INLINE Int texels_at(const std::uint32_t* texels, Int index) {
  return Int(hn::BitCast(IntTag{}, load_runs<1>(UintTag{}, texels, IndexPairs(index).of)));
}

/// Two texels of a row for each lane.
struct TexelPairs {
  Int left, right;
};

/// The texels at the indices and those next to them, all of which must be there.
HWY_INLINE TexelPairs texel_pairs_at(const std::uint32_t* texels, const IndexPairs& index) {
  const UintTag tag;
  const auto of_low_lanes = load_runs<2>(tag, texels, index.of);
  const auto of_high_lanes = load_runs<2>(tag, texels, index.of + kLanes / 4);
  return {Int(hn::BitCast(IntTag{}, hn::ConcatEven(tag, of_high_lanes, of_low_lanes))),
          Int(hn::BitCast(IntTag{}, hn::ConcatOdd(tag, of_high_lanes, of_low_lanes)))};
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
