#include "tests/raster/simd_kernels.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "tests/raster/simd_kernels.cpp"
#include "raster/simd/every_instruction_set.hpp"

#include "raster/simd/elementary-inl.hpp"
#include "raster/simd/texture-inl.hpp"
#include "raster/simd/vector-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

template <Precision P>
struct ArrayKernels {
  using F = Float<P>;

  static void log2_of(const float* a, int count, float* out) {
    for (int i = 0; i < count; i += kLanes) store(log2(load<F>(a + i)), out + i);
  }
  static void exp2_of(const float* a, int count, float* out) {
    for (int i = 0; i < count; i += kLanes) store(exp2(load<F>(a + i)), out + i);
  }
  static void pow_of(const float* base, const float* exponent, int count, float* out) {
    for (int i = 0; i < count; i += kLanes) store(pow(load<F>(base + i), load<F>(exponent + i)), out + i);
  }
  static void sine_cosine_of(const float* a, int count, float* sine, float* cosine) {
    for (int i = 0; i < count; i += kLanes) {
      store(sin(load<F>(a + i)), sine + i);
      store(cos(load<F>(a + i)), cosine + i);
    }
  }
  static void sine_cosine_of_turns_of(const float* a, int count, float* sine, float* cosine) {
    for (int i = 0; i < count; i += kLanes) {
      const SineCosine<F> result = sine_cosine_of_turns(load<F>(a + i));
      store(result.sine, sine + i);
      store(result.cosine, cosine + i);
    }
  }
  static void acos_of(const float* a, int count, float* out) {
    for (int i = 0; i < count; i += kLanes) store(acos(load<F>(a + i)), out + i);
  }
  static void atan2_of(const float* y, const float* x, int count, float* out) {
    for (int i = 0; i < count; i += kLanes) store(atan2(load<F>(y + i), load<F>(x + i)), out + i);
  }
  static void reciprocal_of(const float* a, int count, float* out) {
    for (int i = 0; i < count; i += kLanes) store(reciprocal(load<F>(a + i)), out + i);
  }
  static void inverse_sqrt_of(const float* a, int count, float* out) {
    for (int i = 0; i < count; i += kLanes) store(inverse_sqrt(load<F>(a + i)), out + i);
  }
  static void normalize_of(const float* x, const float* y, const float* z, int count, float* out_x, float* out_y, float* out_z) {
    for (int i = 0; i < count; i += kLanes) {
      const Vec3<F> unit = normalize(Vec3<F>(load<F>(x + i), load<F>(y + i), load<F>(z + i)));
      store(unit.x, out_x + i);
      store(unit.y, out_y + i);
      store(unit.z, out_z + i);
    }
  }
  static void store_colours(const Vec4<F>& colour, Rgba32F* out) {
    float channels[4][kLanes];
    store(colour.x, channels[0]);
    store(colour.y, channels[1]);
    store(colour.z, channels[2]);
    store(colour.w, channels[3]);
    for (int lane = 0; lane < kLanes; ++lane) out[lane] = {channels[0][lane], channels[1][lane], channels[2][lane], channels[3][lane]};
  }
  static void sample_of(const Texture& texture, const Sampler& sampler, const float* u, const float* v, int count, Rgba32F* out) {
    LevelGuess guess;
    for (int i = 0; i < count; i += kLanes)
      store_colours(sample(texture, sampler, Vec2<F>{load<F>(u + i), load<F>(v + i)}, all_lanes(), guess), out + i);
  }
  static void sample_any_of(const Texture& texture, const Sampler& sampler, const float* const strq[4], int count, Rgba32F* out) {
    for (int i = 0; i < count; i += kLanes) {
      const Vec3<F> at{load<F>(strq[0] + i), load<F>(strq[1] + i), load<F>(strq[2] + i)};
      store_colours(sample(texture, sampler, at, load<F>(strq[3] + i), all_lanes()), out + i);
    }
  }

  static constexpr test::SimdKernels kTable{&log2_of, &exp2_of, &pow_of, &sine_cosine_of, &sine_cosine_of_turns_of, &acos_of, &atan2_of, &reciprocal_of, &inverse_sqrt_of, &normalize_of, &sample_of, &sample_any_of};
};

inline const test::SimdKernels& test_kernels(Precision precision) {
  return precision == Precision::exact ? ArrayKernels<Precision::exact>::kTable : ArrayKernels<Precision::fast>::kTable;
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tuberia::test {

const SimdKernels& simd_kernels(InstructionSet instruction_set, Precision precision) {
  TUBERIA_RETURN_FOR(instruction_set, test_kernels(precision))
}

}  // namespace tuberia::test
#endif
