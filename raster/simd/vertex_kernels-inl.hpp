// Vertices in bulk: to clip space with outcodes, and on to the snapped screen.

#if defined(TUBERIA_RASTER_SIMD_VERTEX_KERNELS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_VERTEX_KERNELS_INL
#undef TUBERIA_RASTER_SIMD_VERTEX_KERNELS_INL
#else
#define TUBERIA_RASTER_SIMD_VERTEX_KERNELS_INL
#endif

#include "math/fixed_point.hpp"
#include "raster/geometry_kernels.hpp"
#include "raster/simd/double-inl.hpp"
#include "raster/simd/records-inl.hpp"
#include "raster/simd/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// A register of triples. A record of 16 bytes brings one at a time, and 4 bytes too many: only the
/// mesh's last triple has nothing behind it.
HWY_INLINE Vec3<ExactFloat> load_triples(const Triples& from, const std::uint32_t* source) {
  const Int number = load(source);
  if (any(number == Int(static_cast<std::int32_t>(from.count - 1)))) {
    const Int first = number * Int(3);
    return {gather<ExactFloat>(from.first, first), gather<ExactFloat>(from.first + 1, first), gather<ExactFloat>(from.first + 2, first)};
  }
  Int field[4];
  const auto* const begin = reinterpret_cast<const std::int32_t*>(from.first);
  load_records([&](int lane) HWY_ATTR { return begin + std::size_t{3} * source[lane]; }, field);
  return {float_of_bits<ExactFloat>(field[0]), float_of_bits<ExactFloat>(field[1]), float_of_bits<ExactFloat>(field[2])};
}

/// Row `row` of a column-major 4x4 matrix times (p, 1), always summed in this order.
HWY_INLINE ExactFloat transformed(const float* matrix, int row, const Vec3<ExactFloat>& p) {
  return ((ExactFloat(matrix[row]) * p.x + ExactFloat(matrix[4 + row]) * p.y) + ExactFloat(matrix[8 + row]) * p.z) +
         ExactFloat(matrix[12 + row]);
}

HWY_INLINE Int bit_where(Mask m, std::uint32_t bit) { return select(m, Int(static_cast<std::int32_t>(bit)), Int(0)); }

HWY_INLINE Int outcode_of(const Vec4<ExactFloat>& p, const ClipLimits& limits) {
  const ExactFloat bound_x = p.w * limits.guard_x, bound_y = p.w * limits.guard_y;
  const ExactFloat largest = max(max(abs(p.x), abs(p.y)), max(abs(p.z), abs(p.w)));
  // Max may drop a not-a-number, a sum does not.
  const ExactFloat sum = ((p.x * 0.0f + p.y * 0.0f) + p.z * 0.0f) + p.w * 0.0f;
  const Mask finite = (largest <= 3.4028235e38f) & (sum == 0.0f);
  return bit_where(p.x < -bound_x, outcode::left) | bit_where(p.x > bound_x, outcode::right) |
         bit_where(p.y < -bound_y, outcode::bottom) | bit_where(p.y > bound_y, outcode::top) |
         bit_where(p.z < p.w * limits.z_low, outcode::near) | bit_where(p.z > p.w, outcode::far) |
         bit_where(p.w <= 0.0f, outcode::behind) | bit_where(!finite, outcode::invalid);
}

inline void transform_positions(const float* matrix, const Triples& positions, const std::uint32_t* source, int count,
                                const ClipLimits& limits, const ClipArrays& out) {
  for (int i = 0; i < count; i += kLanes) {
    const Vec3<ExactFloat> object = load_triples(positions, source + i);
    const Vec4<ExactFloat> clip{transformed(matrix, 0, object), transformed(matrix, 1, object),
                                transformed(matrix, 2, object), transformed(matrix, 3, object)};
    store(clip.x, out.x + i);
    store(clip.y, out.y + i);
    store(clip.z, out.z + i);
    store(clip.w, out.w + i);
    store(outcode_of(clip, limits), out.outcode + i);
  }
}

/// Pixels to 24.8 units, inside the guard band; rounded to so many steps a pixel.
HWY_INLINE Double snapped(Double pixels, Double steps, Double units_per_step) {
  return min(max(round(pixels * steps) * units_per_step, Double(-kGuardBandUnits)), Double(kGuardBandUnits));
}

inline void project(const ClipArrays& clip, int count, const ScreenMap& map, ScreenVertex* out) {
  const Double steps(1 << map.subpixel_bits), units_per_step(kSubpixelUnits >> map.subpixel_bits);
  for (int i = 0; i < count; i += kDoubleLanes) {
    const Double w = load_double(clip.w + i);
    // Vertices behind the eye, or not finite, have no place on the screen; clipping has replaced
    // them, but they still occupy their slots. The comparison is false for not-a-number, too.
    const DoubleMask in_front = (w > Double(0.0)) & (w <= Double(3.4028235e38));
    const Double inverse = Double(1.0) / select(in_front, w, Double(1.0));
    const auto screen = [&](const float* from, double scale, double offset) HWY_ATTR {
      const Double ndc = load_double(from + i) * inverse;
      const DoubleMask placed = in_front & (ndc <= Double(1e30)) & (ndc >= Double(-1e30));
      return select(placed, ndc, Double(0.0)) * Double(scale) + Double(offset);
    };
    const auto x = hn::DemoteTo(HalfIntTag{}, snapped(screen(clip.x, map.x_scale, map.x_offset), steps, units_per_step).v);
    const auto y = hn::DemoteTo(HalfIntTag{}, snapped(screen(clip.y, map.y_scale, map.y_offset), steps, units_per_step).v);
    const auto depth = hn::DemoteTo(HalfFloatTag{}, screen(clip.z, map.depth_scale, map.depth_offset).v);
    const auto clip_w = hn::LoadU(HalfFloatTag{}, clip.w + i);
    hn::StoreInterleaved4(x, y, hn::BitCast(HalfIntTag{}, depth), hn::BitCast(HalfIntTag{}, clip_w), HalfIntTag{}, &out[i].x);
  }
}

HWY_INLINE void store_triple(const Vec3<ExactFloat>& v, int i, int pitch, float* out) {
  store(v.x, out + i);
  store(v.y, out + pitch + i);
  store(v.z, out + 2 * pitch + i);
}

HWY_INLINE int padded(int count) {
  constexpr int kPadding = static_cast<int>(kKernelPadding);
  return (count + kPadding - 1) / kPadding * kPadding;
}

inline void transform_points(const float* matrix, const Triples& positions, const std::uint32_t* source, int count, float* out) {
  for (int i = 0; i < count; i += kLanes) {
    const Vec3<ExactFloat> p = load_triples(positions, source + i);
    store_triple({transformed(matrix, 0, p), transformed(matrix, 1, p), transformed(matrix, 2, p)}, i, padded(count), out);
  }
}

inline void transform_normals(const float* matrix, const Triples& normals, const std::uint32_t* source, int count, float* out) {
  const auto row = [&](int r, const Vec3<ExactFloat>& n) HWY_ATTR {
    return (ExactFloat(matrix[r]) * n.x + ExactFloat(matrix[3 + r]) * n.y) + ExactFloat(matrix[6 + r]) * n.z;
  };
  for (int i = 0; i < count; i += kLanes) {
    const Vec3<ExactFloat> n = load_triples(normals, source + i);
    store_triple(normalize(Vec3<ExactFloat>{row(0, n), row(1, n), row(2, n)}), i, padded(count), out);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
