// Which face of a cube a direction meets, and that face's own axes.

#if defined(TUBERIA_RASTER_SIMD_CUBE_FACE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_RASTER_SIMD_CUBE_FACE_INL
#undef TUBERIA_RASTER_SIMD_CUBE_FACE_INL
#else
#define TUBERIA_RASTER_SIMD_CUBE_FACE_INL
#endif

#include "raster/simd/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

/// A face of the cube: its axis, and whether it lies on the axis' negative side.
struct CubeFace {
  Mask on_x, on_y, negative;
  HWY_INLINE Int number() const {
    return select(on_x, Int(0), select(on_y, Int(2), Int(4))) + select(negative, Int(1), Int(0));
  }
};

/// The face that a direction meets; of equally large coordinates z wins, then y.      [rules T5]
template <class F>
HWY_INLINE CubeFace face_of(const Vec3<F>& d) {
  const F x = abs(d.x), y = abs(d.y), z = abs(d.z);
  const Mask on_z = (z >= x) & (z >= y);
  const Mask on_y = !on_z & (y >= x);
  const Mask on_x = !on_z & !on_y;
  return {on_x, on_y, select(on_x, d.x, select(on_y, d.y, d.z)) < 0.0f};
}

/// A vector in the frame of a face: along its s and t, and outwards. Works for floats and integers.
template <class N>
HWY_INLINE Vec3<N> in_frame(const CubeFace& face, const Vec3<N>& v, const Vec3<N>& negated) {
  const N s_of_x = select(face.negative, v.z, negated.z), s_of_z = select(face.negative, negated.x, v.x);
  const N t_of_y = select(face.negative, negated.z, v.z);
  const N out = select(face.on_x, v.x, select(face.on_y, v.y, v.z)), negated_out = select(face.on_x, negated.x, select(face.on_y, negated.y, negated.z));
  return {select(face.on_x, s_of_x, select(face.on_y, v.x, s_of_z)), select(face.on_y, t_of_y, negated.y),
          select(face.negative, negated_out, out)};
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
