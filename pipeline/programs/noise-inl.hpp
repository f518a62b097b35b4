// Noise for a register of points, from hashes of whole numbers: the definitions are in
// math/lattice_noise.hpp. Functions are not inlined, since each is hundreds of instructions.

#if defined(TUBERIA_PIPELINE_PROGRAMS_NOISE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef TUBERIA_PIPELINE_PROGRAMS_NOISE_INL
#undef TUBERIA_PIPELINE_PROGRAMS_NOISE_INL
#else
#define TUBERIA_PIPELINE_PROGRAMS_NOISE_INL
#endif

#include "math/lattice_noise.hpp"
#include "raster/simd/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

HWY_INLINE Int scrambled(Int h) {
  h = (h ^ shift_right<16>(h)) * Int(0x7feb352d);
  h = (h ^ shift_right<15>(h)) * Int(static_cast<std::int32_t>(0x846ca68bu));
  return h ^ shift_right<16>(h);
}

/// A cell's number times its axis' factor; hashes add those of all axes and the seed's.
HWY_INLINE Int lattice_term(Int cell, std::size_t axis) { return cell * Int(static_cast<std::int32_t>(kLatticeFactors[axis])); }
HWY_INLINE Int seed_term(std::uint32_t seed) { return Int(static_cast<std::int32_t>(seed * kSeedFactor)); }

template <class F>
HWY_INLINE F bounded_lattice_coordinate(F x) { return select(abs(x) < kLargestLatticeCoordinate, x, F(0.0f)); }

/// Where a coordinate lies; see math/lattice_noise.cpp.
template <class F>
struct LatticePlace {
  F cell, within, weight;
  HWY_INLINE explicit LatticePlace(F coordinate) {
    const F x = bounded_lattice_coordinate(coordinate);
    cell = floor(x);
    within = x - cell;
    weight = within * within * within * mul_add(within, mul_add(within, F(6.0f), F(-15.0f)), F(10.0f));
  }
  HWY_INLINE F slope() const {
    const F bell = within * (within - 1.0f);
    return 30.0f * (bell * bell);
  }
};

/// a with its sign turned round where the hash's bit, counted from the left, is set.
template <int kBitFromLeft, class F>
HWY_INLINE F signed_by(Int hash, F a) {
  const Int sign = shift_left<kBitFromLeft>(hash) & Int(static_cast<std::int32_t>(0x80000000u));
  return float_of_bits<F>(bits_of(a) ^ sign);
}

template <class F>
HWY_NOINLINE F gradient_noise(const Vec3<F>& point, std::uint32_t seed) {
  const LatticePlace<F> x(point.x), y(point.y), z(point.z);
  const Int base = lattice_term(truncate_to_int(x.cell), 0) + lattice_term(truncate_to_int(y.cell), 1) +
                   lattice_term(truncate_to_int(z.cell), 2) + seed_term(seed);
  const auto corner = [&](int i, int j, int k) HWY_ATTR {
    const Int h = scrambled(base + lattice_term(Int(i), 0) + lattice_term(Int(j), 1) + lattice_term(Int(k), 2));
    return signed_by<0>(h, x.within - static_cast<float>(i)) + signed_by<1>(h, y.within - static_cast<float>(j)) +
           signed_by<2>(h, z.within - static_cast<float>(k));
  };
  const auto edge = [&](int j, int k) HWY_ATTR { return mix(corner(0, j, k), corner(1, j, k), x.weight); };
  const auto face = [&](int k) HWY_ATTR { return mix(edge(0, k), edge(1, k), y.weight); };
  return mix(face(0), face(1), z.weight) * (2.0f / 3.0f);
}

template <class F>
HWY_NOINLINE F turbulence(const Vec3<F>& point, std::uint32_t seed) {
  F sum(0.0f);
  float scale = 1;
  for (std::uint32_t octave = 0; octave < 4; ++octave, scale *= 2)
    sum = sum + abs(gradient_noise(point * F(scale), seed + octave)) * F(1 / scale);
  return sum;
}

/// A function of the plane and its derivatives.
template <class F>
struct HeightSlope {
  F height;
  Vec2<F> slope;
};

/// The number of a cell in a lattice that repeats after so many.
template <class F>
HWY_INLINE Int wrapped_cell(F cell, float period) { return truncate_to_int(cell - floor(cell / F(period)) * period); }

template <class F>
HWY_NOINLINE HeightSlope<F> gradient_noise(const Vec2<F>& point, float period, std::uint32_t seed) {
  const LatticePlace<F> x(point.x), y(point.y);
  struct Corner {
    F value, gradient_x, gradient_y;
  };
  const auto corner = [&](float i, float j) HWY_ATTR {
    const Int h = scrambled(lattice_term(wrapped_cell(x.cell + i, period), 0) + lattice_term(wrapped_cell(y.cell + j, period), 1) + seed_term(seed));
    const F gradient_x = signed_by<0>(h, F(1.0f)), gradient_y = signed_by<1>(h, F(1.0f));
    return Corner{gradient_x * (x.within - i) + gradient_y * (y.within - j), gradient_x, gradient_y};
  };
  const Corner a = corner(0, 0), b = corner(1, 0), c = corner(0, 1), d = corner(1, 1);
  const auto interpolated = [&](F p, F q, F r, F s) HWY_ATTR { return mix(mix(p, q, x.weight), mix(r, s, x.weight), y.weight); };
  return {interpolated(a.value, b.value, c.value, d.value),
          {interpolated(a.gradient_x, b.gradient_x, c.gradient_x, d.gradient_x) + x.slope() * mix(b.value - a.value, d.value - c.value, y.weight),
           interpolated(a.gradient_y, b.gradient_y, c.gradient_y, d.gradient_y) + y.slope() * mix(c.value - a.value, d.value - b.value, x.weight)}};
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#endif
