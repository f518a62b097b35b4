#pragma once
// The SIMD room's functions on arrays, for tests.

#include <span>

#include "image/image.hpp"
#include "raster/instruction_set.hpp"
#include "raster/sampler.hpp"
#include "raster/texture.hpp"

namespace tuberia::test {

/// Counts are multiples of 16; every array holds `count` floats.
struct SimdKernels {
  void (*log2)(const float* a, int count, float* out);
  void (*exp2)(const float* a, int count, float* out);
  void (*pow)(const float* base, const float* exponent, int count, float* out);
  void (*sine_cosine)(const float* a, int count, float* sine, float* cosine);
  void (*sine_cosine_of_turns)(const float* a, int count, float* sine, float* cosine);
  void (*acos)(const float* a, int count, float* out);
  void (*atan2)(const float* y, const float* x, int count, float* out);
  void (*reciprocal)(const float* a, int count, float* out);
  void (*inverse_sqrt)(const float* a, int count, float* out);
  void (*normalize)(const float* x, const float* y, const float* z, int count, float* out_x, float* out_y, float* out_z);
  /// Each four neighbours are a quad: upper left, upper right, lower left, lower right.
  void (*sample)(const Texture& texture, const Sampler& sampler, const float* u, const float* v, int count, Rgba32F* out);
  /// The same with s, t, r and the reference, for any kind of texture.
  void (*sample_any)(const Texture& texture, const Sampler& sampler, const float* const strq[4], int count, Rgba32F* out);
};

const SimdKernels& simd_kernels(InstructionSet, Precision);

}  // namespace tuberia::test
