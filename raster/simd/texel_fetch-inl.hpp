// Texels from memory into registers: a plain load for each lane, and shuffles that put the lanes
// together. Gathers take up to three times as long where they are slow, and instruction sets
// without them do the same less well (docs/decisions/0012-textures-without-gathers.md).

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

/// The four texels that a point lies between, for each lane.
struct FourTexels {
  Int upper_left, upper_right, lower_left, lower_right;
};

/// Two neighbours and the two a row below them, in blocks of four texels: one for each block of four
/// lanes, that of its lane kLane. Each index is used once and soon: there are not registers for more.
template <int kLane, class Tag>
HWY_INLINE hn::Vec<Tag> load_squares(Tag tag, const std::uint32_t* upper, const std::uint32_t* lower, const std::uint64_t* index) {
  const hn::Half<Tag> half;
  if constexpr (hn::MaxLanes(tag) == 4) {
    const std::uint64_t i = kLane % 2 == 0 ? index[kLane / 2] & 0xffffffff : index[kLane / 2] >> 32;
    return hn::Combine(tag, hn::LoadU(half, lower + i), hn::LoadU(half, upper + i));
  } else {
    return hn::Combine(tag, load_squares<kLane>(half, upper, lower, index + hn::MaxLanes(half) / 2),
                       load_squares<kLane>(half, upper, lower, index));
  }
}

/// The texels at the indices of rows of so many texels, those next to them, and the same one row below,
/// all of which must be there.
HWY_INLINE FourTexels squares_at(const std::uint32_t* texels, int width, Int index) {
  const UintTag tag;
  const hn::Repartition<std::uint64_t, UintTag> wide;
  const IndexPairs first(index);
  const auto a = load_squares<0>(tag, texels, texels + width, first.of), b = load_squares<1>(tag, texels, texels + width, first.of);
  const auto c = load_squares<2>(tag, texels, texels + width, first.of), d = load_squares<3>(tag, texels, texels + width, first.of);
  // Transposes 4 by 4 in each block.
  const auto upper_ab = hn::BitCast(wide, hn::InterleaveLower(tag, a, b)), upper_cd = hn::BitCast(wide, hn::InterleaveLower(tag, c, d));
  const auto lower_ab = hn::BitCast(wide, hn::InterleaveUpper(tag, a, b)), lower_cd = hn::BitCast(wide, hn::InterleaveUpper(tag, c, d));
  const auto codes = [](auto v) HWY_ATTR { return Int(hn::BitCast(IntTag{}, v)); };
  return {codes(hn::InterleaveLower(wide, upper_ab, upper_cd)), codes(hn::InterleaveUpper(wide, upper_ab, upper_cd)),
          codes(hn::InterleaveLower(wide, lower_ab, lower_cd)), codes(hn::InterleaveUpper(wide, lower_ab, lower_cd))};
}

/// Byte kByte of each lane, 0 being the lowest.
template <int kByte>
HWY_INLINE Int byte(Int a) {
  if constexpr (kByte == 0) return a & Int(0xff);
  if constexpr (kByte == 3) return shift_right<24>(a);
  constexpr std::uint8_t kZero = 128;
  constexpr int b = kByte;
  alignas(16) static constexpr std::uint8_t kFrom[16] = {b, kZero, kZero, kZero, b + 4, kZero, kZero, kZero, b + 8, kZero, kZero, kZero, b + 12, kZero, kZero, kZero};
  const hn::Repartition<std::uint8_t, IntTag> bytes;
  return Int(hn::BitCast(IntTag{}, hn::TableLookupBytesOr0(hn::BitCast(bytes, a.v), hn::LoadDup128(bytes, kFrom))));
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
