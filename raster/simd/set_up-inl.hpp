// Set-up in bulk of small triangles: 32-bit integers and floats, whole records at a time.

#if defined(TUBERIA_RASTER_SIMD_SET_UP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_SET_UP_INL
#undef TUBERIA_RASTER_SIMD_SET_UP_INL
#else
#define TUBERIA_RASTER_SIMD_SET_UP_INL
#endif

#include <algorithm>
#include <cstddef>

#include "raster/simd/set_up_large-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// A cache line of as many records as a register has lanes, a register for every 4 bytes.
struct LineOfRecords {
  Int word[16];
};

/// Writes the lines to records that lie `stride` bytes apart.
HWY_INLINE void store_lines(LineOfRecords& line, std::byte* to, std::size_t stride) {
  Int* const w = line.word;
  for (int k = 0; k < 16; k += 4) transpose_blocks(w[k], w[k + 1], w[k + 2], w[k + 3]);
  // Block b of w[k + j] now belongs to record 4 b + j.
  const auto place = [&](int record) HWY_ATTR { return reinterpret_cast<std::int32_t*>(to + static_cast<std::size_t>(record) * stride); };
  for (int j = 0; j < 4; ++j) {
#if HWY_TARGET == HWY_AVX3
    const __m512i a = w[j].v.raw, b = w[4 + j].v.raw, c = w[8 + j].v.raw, d = w[12 + j].v.raw;
    const __m512i ab_low = _mm512_shuffle_i32x4(a, b, 0x44), ab_high = _mm512_shuffle_i32x4(a, b, 0xee);
    const __m512i cd_low = _mm512_shuffle_i32x4(c, d, 0x44), cd_high = _mm512_shuffle_i32x4(c, d, 0xee);
    _mm512_storeu_si512(place(j), _mm512_shuffle_i32x4(ab_low, cd_low, 0x88));
    _mm512_storeu_si512(place(4 + j), _mm512_shuffle_i32x4(ab_low, cd_low, 0xdd));
    _mm512_storeu_si512(place(8 + j), _mm512_shuffle_i32x4(ab_high, cd_high, 0x88));
    _mm512_storeu_si512(place(12 + j), _mm512_shuffle_i32x4(ab_high, cd_high, 0xdd));
#else
    if constexpr (kBlocks == 1) {
      for (int k = 0; k < 4; ++k) store(w[4 * k + j], place(j) + 4 * k);
    } else {
      for (int k = 0; k < 16; k += 8) {
        store(Int(hn::ConcatLowerLower(IntTag{}, w[k + 4 + j].v, w[k + j].v)), place(j) + k);
        store(Int(hn::ConcatUpperUpper(IntTag{}, w[k + 4 + j].v, w[k + j].v)), place(4 + j) + k);
      }
    }
#endif
  }
}

/// Low 16 bits of two numbers as one of 32.
HWY_INLINE Int paired(Int low, Int high) { return (low & Int(0xffff)) | shift_left<16>(high); }

/// Whole numbers as the two halves of doubles.
HWY_INLINE void split_doubles(Int whole, Int& low, Int& high) {
  const auto a = hn::BitCast(IntTag{}, lower_doubles(whole).v), b = hn::BitCast(IntTag{}, upper_doubles(whole).v);
  low = Int(hn::ConcatEven(IntTag{}, b, a));
  high = Int(hn::ConcatOdd(IntTag{}, b, a));
}

/// What the edges say of small triangles: the record's first line but for the flags, and the constants.
/// Floats are enough for the quotients and give the bits of the general way, which rounds a quotient
/// in double and then to float: with less than 2^24 below the stroke and at most 2^8 above it, no
/// quotient comes near enough to the middle of two floats for the first rounding to matter.
template <bool kHasSamples>
HWY_INLINE void set_up_small_edges(const Corners& c, const PixelBounds& bounds, LineOfRecords& first, LineOfRecords& second) {
  const EdgeValues edges = edges_at(c, bounds.left, bounds.top);
  const ExactFloat area = to_float<ExactFloat>(edges.twice_area());
  Int remainder(0);
  for (int k = 0; k < 3; ++k) {
    const int from = (k + 1) % 3, to = (k + 2) % 3;
    const Int per_x = c.y[from] - c.y[to], per_y = c.x[to] - c.x[from], rule = top_left_rule(per_x, per_y);
    const Int here = edges.at[k] + rule, low_bits = here & Int(kSubpixelUnits - 1);
    // With |per_x|, |per_y| < 2^14 and pixels within 2^15 this fits 32 bits.
    const Int constant = arithmetic_shift_right<kSubpixelBits>(here) - per_x * bounds.left - per_y * bounds.top;
    first.word[2 + k] = per_x;
    first.word[5 + k] = per_y;
    first.word[8 + k] = constant;
    split_doubles(constant, second.word[10 + 2 * k], second.word[11 + 2 * k]);
    if (k > 0) first.word[11 + k] = bits_of(to_float<ExactFloat>(low_bits - rule) / area);
    if constexpr (kHasSamples) remainder = remainder | (k == 0 ? low_bits : k == 1 ? shift_left<8>(low_bits) : shift_left<16>(low_bits));
  }
  first.word[11] = bits_of(ExactFloat(kSubpixelUnits) / area);
  first.word[15] = remainder;
}

/// Depth and 1/w, the latter relative to the largest of the three, so that no scale of w can overflow
/// or lose a bit. In floats: a difference or a quotient of floats that is rounded to double first has
/// the same bits.
HWY_INLINE Mask set_up_small_depth(const Corners& c, LineOfRecords& second) {
  const auto real = [](Int bits) HWY_ATTR { return float_of_bits<ExactFloat>(bits); };
  const ExactFloat w[3] = {real(c.w[0]), real(c.w[1]), real(c.w[2])};
  second.word[0] = c.depth[0];
  second.word[1] = bits_of(real(c.depth[1]) - real(c.depth[0]));
  second.word[2] = bits_of(real(c.depth[2]) - real(c.depth[0]));
  const Mask is_affine = (w[0] == w[1]) & (w[0] == w[2]);
  const ExactFloat least = min(min(w[0], w[1]), w[2]);
  for (int k = 0; k < 3; ++k)
    second.word[3 + k] = all(is_affine) ? bits_of(ExactFloat(1.0f)) : bits_of(max(least / w[k], ExactFloat(static_cast<float>(kLeastInverseW))));
  return is_affine;
}

template <bool kHasSamples>
HWY_INLINE void set_up_small(const Corners& corners, const TriangleArrays& t, int i, ScreenTriangle* out) {
  const PixelBounds bounds = pixel_bounds(corners, kHasSamples ? 1 : 0);
  LineOfRecords first, second;
  set_up_small_edges<kHasSamples>(corners, bounds, first, second);
  const Mask is_affine = set_up_small_depth(corners, second);
  const Int low(-32768), high(32767);
  first.word[0] = paired(max(bounds.left, low), max(bounds.top, low));
  first.word[1] = paired(min(bounds.right, high), min(bounds.bottom, high));
  first.word[14] = select(is_affine, Int(kIsAffine), Int(kDividesEachPixel)) | Int(1 << 8) | shift_left<16>(load_narrow(t.is_back + i));
  second.word[6] = paired(load(t.v0 + i), load(t.v1 + i));
  second.word[7] = paired(load(t.v2 + i), load(t.provoking + i));
  second.word[8] = load(t.primitive + i);
  second.word[9] = Int(0);
  auto* const to = reinterpret_cast<std::byte*>(out);
  store_lines(first, to, sizeof(ScreenTriangle));
  store_lines(second, to + 64, sizeof(ScreenTriangle));
}

/// Whether the quick way may take all triangles of a register.
HWY_INLINE bool are_small(const Corners& corners) {
  if (!all(span_of(corners) < Int(kSmallSpanUnits))) return false;
  const PixelBounds bounds = pixel_bounds(corners, 0);
  return all(edges_at(corners, bounds.left, bounds.top).twice_area() < Int(1 << 24));
}

template <bool kHasSamples>
void set_up_all(const TriangleArrays& t, int count, const ScreenVertex* vertices, ScreenTriangle* out) {
  const auto set_up_register = [&](int i, ScreenTriangle* to) HWY_ATTR {
    const Corners corners = load_corners(t, i, vertices);
    if (are_small(corners)) set_up_small<kHasSamples>(corners, t, i, to);
    else set_up_large<kHasSamples>(corners, t, i, to);
  };
  const int whole = count / kLanes * kLanes;
  for (int i = 0; i < whole; i += kLanes) set_up_register(i, out + i);
  if (whole == count) return;
  ScreenTriangle rest[kLanes];
  set_up_register(whole, rest);
  std::copy_n(rest, count - whole, out + whole);
}

inline void set_up(const TriangleArrays& t, int count, const ScreenVertex* vertices, bool has_samples, ScreenTriangle* out) {
  if (has_samples) set_up_all<true>(t, count, vertices, out);
  else set_up_all<false>(t, count, vertices, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
