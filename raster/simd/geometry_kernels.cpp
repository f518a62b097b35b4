#include "raster/geometry_kernels.hpp"

#undef TUBERIA_KERNEL_FILE
#define TUBERIA_KERNEL_FILE "raster/simd/geometry_kernels.cpp"
#include "raster/simd/every_instruction_set.hpp"

#include "raster/simd/culling-inl.hpp"
#include "raster/simd/fog-inl.hpp"
#include "raster/simd/set_up-inl.hpp"
#include "raster/simd/vertex_kernels-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia {
namespace HWY_NAMESPACE {

void fog_shares(const FogState& fog, int count, float* coordinates) {
  for (int i = 0; i < count; i += kLanes) store(fog_share(abs(load<ExactFloat>(coordinates + i)), fog), coordinates + i);
}

const GeometryKernels& kernels() {
  static constexpr GeometryKernels kTable{&transform_positions, &project,          &cull,
                                          &set_up,              &transform_points, &transform_normals, &fog_shares};
  return kTable;
}

}  // namespace HWY_NAMESPACE
}  // namespace tuberia
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tuberia {

const GeometryKernels& geometry_kernels(InstructionSet instruction_set) noexcept {
  TUBERIA_RETURN_FOR(instruction_set, kernels())
}

}  // namespace tuberia
#endif
