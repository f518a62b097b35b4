// The SIMD numbers: as many floats, integers or truth values as one register of the current
// instruction set holds. Everything else computes with these and names no intrinsic.
//
// This file is compiled once per instruction set (see every_instruction_set.hpp).

#if defined(TUBERIA_RASTER_SIMD_NUMBER_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_NUMBER_INL
#undef TUBERIA_RASTER_SIMD_NUMBER_INL
#else
#define TUBERIA_RASTER_SIMD_NUMBER_INL
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <cstdint>

#include "raster/instruction_set.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::CappedTag<float, 16>;
using IntTag = hn::RebindToSigned<FloatTag>;
using UintTag = hn::RebindToUnsigned<FloatTag>;
inline constexpr int kLanes = static_cast<int>(hn::MaxLanes(FloatTag{}));

/// One truth value a lane.
struct Mask {
  hn::Mask<FloatTag> m;
};

/// One 32-bit integer a lane; arithmetic wraps around.
struct Int {
  hn::Vec<IntTag> v;
  Int() = default;
  HWY_INLINE explicit Int(hn::Vec<IntTag> lanes) : v(lanes) {}
  HWY_INLINE Int(std::int32_t all) : v(hn::Set(IntTag{}, all)) {}
};

/// One float a lane. The precision is part of the type, so that a fragment program, which is
/// written for any Number, says nothing about it.
template <Precision P>
struct Float {
  using IntType = Int;
  using MaskType = Mask;
  static constexpr Precision kPrecision = P;
  hn::Vec<FloatTag> v;
  Float() = default;
  HWY_INLINE explicit Float(hn::Vec<FloatTag> lanes) : v(lanes) {}
  HWY_INLINE Float(float all) : v(hn::Set(FloatTag{}, all)) {}
};

using ExactFloat = Float<Precision::exact>;

// Arithmetic: a pair of numbers, or a number and a scalar that stands for all lanes.
#define TUBERIA_FLOAT_OPERATOR(OP, NAME)                                                             \
  template <Precision P>                                                                             \
  HWY_INLINE Float<P> operator OP(Float<P> a, Float<P> b) { return Float<P>(hn::NAME(a.v, b.v)); }   \
  template <Precision P>                                                                             \
  HWY_INLINE Float<P> operator OP(Float<P> a, float b) { return a OP Float<P>(b); }                  \
  template <Precision P>                                                                             \
  HWY_INLINE Float<P> operator OP(float a, Float<P> b) { return Float<P>(a) OP b; }
TUBERIA_FLOAT_OPERATOR(+, Add)
TUBERIA_FLOAT_OPERATOR(-, Sub)
TUBERIA_FLOAT_OPERATOR(*, Mul)
TUBERIA_FLOAT_OPERATOR(/, Div)
#undef TUBERIA_FLOAT_OPERATOR

#define TUBERIA_FLOAT_COMPARISON(OP, NAME)                                                       \
  template <Precision P>                                                                         \
  HWY_INLINE Mask operator OP(Float<P> a, Float<P> b) { return {hn::NAME(a.v, b.v)}; }           \
  template <Precision P>                                                                         \
  HWY_INLINE Mask operator OP(Float<P> a, float b) { return a OP Float<P>(b); }
TUBERIA_FLOAT_COMPARISON(<, Lt)
TUBERIA_FLOAT_COMPARISON(<=, Le)
TUBERIA_FLOAT_COMPARISON(>, Gt)
TUBERIA_FLOAT_COMPARISON(>=, Ge)
TUBERIA_FLOAT_COMPARISON(==, Eq)
#undef TUBERIA_FLOAT_COMPARISON

template <Precision P>
HWY_INLINE Float<P> operator-(Float<P> a) { return Float<P>(hn::Neg(a.v)); }
template <Precision P>
HWY_INLINE Float<P>& operator+=(Float<P>& a, Float<P> b) { return a = a + b; }
template <Precision P>
HWY_INLINE Float<P>& operator*=(Float<P>& a, Float<P> b) { return a = a * b; }

HWY_INLINE Int operator+(Int a, Int b) { return Int(hn::Add(a.v, b.v)); }
HWY_INLINE Int operator-(Int a, Int b) { return Int(hn::Sub(a.v, b.v)); }
HWY_INLINE Int operator*(Int a, Int b) { return Int(hn::Mul(a.v, b.v)); }
HWY_INLINE Int operator&(Int a, Int b) { return Int(hn::And(a.v, b.v)); }
HWY_INLINE Int operator|(Int a, Int b) { return Int(hn::Or(a.v, b.v)); }
HWY_INLINE Int operator^(Int a, Int b) { return Int(hn::Xor(a.v, b.v)); }
HWY_INLINE Int operator~(Int a) { return Int(hn::Not(a.v)); }
HWY_INLINE Mask operator<(Int a, Int b) { return {hn::RebindMask(FloatTag{}, hn::Lt(a.v, b.v))}; }
HWY_INLINE Mask operator>(Int a, Int b) { return b < a; }
HWY_INLINE Mask operator==(Int a, Int b) { return {hn::RebindMask(FloatTag{}, hn::Eq(a.v, b.v))}; }
template <int kBits>
HWY_INLINE Int shift_left(Int a) { return Int(hn::ShiftLeft<kBits>(a.v)); }
/// Fills with zeros from the left.
template <int kBits>
HWY_INLINE Int shift_right(Int a) {
  return Int(hn::BitCast(IntTag{}, hn::ShiftRight<kBits>(hn::BitCast(UintTag{}, a.v))));
}
/// Fills with the sign from the left: rounds down.
template <int kBits>
HWY_INLINE Int arithmetic_shift_right(Int a) { return Int(hn::ShiftRight<kBits>(a.v)); }
HWY_INLINE Int min(Int a, Int b) { return Int(hn::Min(a.v, b.v)); }
HWY_INLINE Int max(Int a, Int b) { return Int(hn::Max(a.v, b.v)); }
HWY_INLINE std::int32_t largest_lane(Int a) { return hn::GetLane(hn::MaxOfLanes(IntTag{}, a.v)); }

HWY_INLINE Mask operator&(Mask a, Mask b) { return {hn::And(a.m, b.m)}; }
HWY_INLINE Mask operator|(Mask a, Mask b) { return {hn::Or(a.m, b.m)}; }
HWY_INLINE Mask operator!(Mask a) { return {hn::Not(a.m)}; }
HWY_INLINE bool any(Mask a) { return !hn::AllFalse(FloatTag{}, a.m); }
HWY_INLINE bool none(Mask a) { return hn::AllFalse(FloatTag{}, a.m); }
HWY_INLINE bool all(Mask a) { return hn::AllTrue(FloatTag{}, a.m); }
HWY_INLINE Mask all_lanes() { return {hn::MaskFromVec(hn::BitCast(FloatTag{}, hn::Set(IntTag{}, -1)))}; }
/// The lanes whose integer is below zero.
HWY_INLINE Mask is_negative(Int a) {
  return {hn::MaskFromVec(hn::BitCast(FloatTag{}, hn::BroadcastSignBit(a.v)))};
}
/// Bit i is lane i.
HWY_INLINE std::uint32_t bits_of(Mask a) {
#if HWY_TARGET == HWY_AVX3
  return static_cast<std::uint32_t>(a.m.raw);
#elif HWY_TARGET == HWY_AVX2
  return static_cast<std::uint32_t>(_mm256_movemask_ps(a.m.raw));
#elif HWY_TARGET == HWY_SSE4
  return static_cast<std::uint32_t>(_mm_movemask_ps(a.m.raw));
#else
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(FloatTag{}, a.m, bytes);
  return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8;
#endif
}
HWY_INLINE Mask mask_of(std::uint32_t bits) {
#if HWY_TARGET == HWY_AVX3
  return {hn::Mask<FloatTag>{static_cast<__mmask16>(bits)}};
#else
  const hn::Vec<IntTag> bit_of_lane = hn::Shl(hn::Set(IntTag{}, 1), hn::Iota(IntTag{}, 0));
  return {hn::RebindMask(FloatTag{}, hn::TestBit(hn::Set(IntTag{}, static_cast<std::int32_t>(bits)), bit_of_lane))};
#endif
}

/// The number in one lane.
HWY_INLINE std::int32_t lane(Int a, int number) {
  return hn::GetLane(hn::TableLookupLanes(a.v, hn::IndicesFromVec(IntTag{}, hn::Set(IntTag{}, number))));
}

template <Precision P>
HWY_INLINE Float<P> select(Mask m, Float<P> yes, Float<P> no) { return Float<P>(hn::IfThenElse(m.m, yes.v, no.v)); }
HWY_INLINE Int select(Mask m, Int yes, Int no) {
  return Int(hn::IfThenElse(hn::RebindMask(IntTag{}, m.m), yes.v, no.v));
}

// Memory. Pointers need only the alignment of their element.
template <class F>
HWY_INLINE F load(const float* from) { return F(hn::LoadU(FloatTag{}, from)); }
HWY_INLINE Int load(const std::int32_t* from) { return Int(hn::LoadU(IntTag{}, from)); }
HWY_INLINE Int load(const std::uint32_t* from) {
  return Int(hn::BitCast(IntTag{}, hn::LoadU(UintTag{}, from)));
}
template <Precision P>
HWY_INLINE void store(Float<P> a, float* to) { hn::StoreU(a.v, FloatTag{}, to); }
HWY_INLINE void store(Int a, std::int32_t* to) { hn::StoreU(a.v, IntTag{}, to); }
HWY_INLINE void store(Int a, std::uint32_t* to) { hn::StoreU(hn::BitCast(UintTag{}, a.v), UintTag{}, to); }
/// Writes the lanes of the mask and leaves the others as they are. Loads, blends and stores whole
/// registers: processors do not forward a masked store to the next load, and the next triangle
/// often wants the same pixels at once.
template <class T, class V>
HWY_INLINE void store_where(Mask m, V a, T* to) {
  const hn::Rebind<T, FloatTag> d;
  hn::StoreU(hn::IfThenElse(hn::RebindMask(d, m.m), hn::BitCast(d, a.v), hn::LoadU(d, to)), d, to);
}
/// Asks for the cache line of an address that will be wanted soon.
HWY_INLINE void prefetch(const char* address) { hwy::Prefetch(address); }

HWY_INLINE Int gather(const std::int32_t* table, Int index) { return Int(hn::GatherIndex(IntTag{}, table, index.v)); }
template <class F>
HWY_INLINE F gather(const float* table, Int index) { return F(hn::GatherIndex(FloatTag{}, table, index.v)); }

// Conversions.
HWY_INLINE Int int_of_bits(hn::Vec<FloatTag> v) { return Int(hn::BitCast(IntTag{}, v)); }
template <Precision P>
HWY_INLINE Int bits_of(Float<P> a) { return int_of_bits(a.v); }
template <class F>
HWY_INLINE F float_of_bits(Int a) { return F(hn::BitCast(FloatTag{}, a.v)); }
/// Towards zero, for |a| < 2^31. Callers clamp first: what happens beyond differs by machine, and
/// the library's own conversion spends four instructions on making it alike.
template <Precision P>
HWY_INLINE Int truncate_to_int(Float<P> a) {
#if HWY_TARGET == HWY_AVX3
  return Int(hn::Vec<IntTag>{_mm512_cvttps_epi32(a.v.raw)});
#elif HWY_TARGET == HWY_AVX2
  return Int(hn::Vec<IntTag>{_mm256_cvttps_epi32(a.v.raw)});
#elif HWY_TARGET == HWY_SSE4
  return Int(hn::Vec<IntTag>{_mm_cvttps_epi32(a.v.raw)});
#else
  return Int(hn::ConvertTo(IntTag{}, a.v));
#endif
}

/// floor(a + 1/2) of the real number a, for 0 <= a < 2^31. Not by adding 1/2, which would round
/// the sum: just below 1/2 up to 1, and above 2^23 to the wrong whole number.
template <Precision P>
HWY_INLINE Int round_half_up(Float<P> a) { return truncate_to_int(a + 0x1.fffffep-2f); }
template <class F>
HWY_INLINE F to_float(Int a) { return F(hn::ConvertTo(FloatTag{}, a.v)); }

// The functions of one number that every machine computes alike.
template <Precision P>
HWY_INLINE Float<P> min(Float<P> a, Float<P> b) { return Float<P>(hn::Min(a.v, b.v)); }
template <Precision P>
HWY_INLINE Float<P> max(Float<P> a, Float<P> b) { return Float<P>(hn::Max(a.v, b.v)); }
template <Precision P>
HWY_INLINE Float<P> min(Float<P> a, float b) { return min(a, Float<P>(b)); }
template <Precision P>
HWY_INLINE Float<P> max(Float<P> a, float b) { return max(a, Float<P>(b)); }
/// a where it is positive, otherwise 0; not-a-number gives 0.
template <Precision P>
HWY_INLINE Float<P> positive_part(Float<P> a) {
#if HWY_ARCH_X86
  return max(a, 0.0f);  // this machine's maximum is its second argument when the first is no number
#else
  return Float<P>(hn::IfThenElseZero(hn::Gt(a.v, hn::Zero(FloatTag{})), a.v));
#endif
}
template <Precision P>
HWY_INLINE Float<P> abs(Float<P> a) { return Float<P>(hn::Abs(a.v)); }
template <Precision P>
HWY_INLINE Float<P> floor(Float<P> a) { return Float<P>(hn::Floor(a.v)); }
template <Precision P>
HWY_INLINE Float<P> sqrt(Float<P> a) { return Float<P>(hn::Sqrt(a.v)); }

/// a * b + c: two roundings when exact; when fast one, where the machine can.
template <Precision P>
HWY_INLINE Float<P> mul_add(Float<P> a, Float<P> b, Float<P> c) {
  if constexpr (contains(P, Precision::fused_multiply_add)) return Float<P>(hn::MulAdd(a.v, b.v, c.v));
  else return a * b + c;
}

/// 1/a. Largest relative error, fast: 3e-7 for 1e-30 <= |a| <= 1e30 (precision_test).
template <Precision P>
HWY_INLINE Float<P> reciprocal(Float<P> a) {
  if constexpr (contains(P, Precision::fast_reciprocal)) {
    const Float<P> guess(hn::ApproximateReciprocal(a.v));
    return guess * Float<P>(hn::NegMulAdd(guess.v, a.v, hn::Set(FloatTag{}, 2.0f)));
  } else {
    return Float<P>(1.0f) / a;
  }
}

/// 1/sqrt(a) for a > 0. Largest relative error, fast: 5e-7 for 1e-30 <= a <= 1e30 (precision_test).
template <Precision P>
HWY_INLINE Float<P> inverse_sqrt(Float<P> a) {
  if constexpr (contains(P, Precision::fast_inverse_sqrt)) {
    const Float<P> guess(hn::ApproximateReciprocalSqrt(a.v));
    return guess * (1.5f - (a * 0.5f) * (guess * guess));
  } else {
    return Float<P>(1.0f) / sqrt(a);
  }
}

/// Column and row of each lane's pixel in the group of pixels that one register covers: see
/// raster/block.hpp.
HWY_INLINE Int lane_x() {
  const Int lane(hn::Iota(IntTag{}, 0));
  return (lane & Int(1)) | (shift_right<1>(lane) & Int(2));
}
HWY_INLINE Int lane_y() {
  const Int lane(hn::Iota(IntTag{}, 0));
  return (shift_right<1>(lane) & Int(1)) | (shift_right<2>(lane) & Int(2));
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
