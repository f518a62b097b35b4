// Compiles the including file once for every instruction set. Before including this, define
// TUBERIA_KERNEL_FILE as that file's path from an include directory:
//
//     #undef TUBERIA_KERNEL_FILE
//     #define TUBERIA_KERNEL_FILE "examples/my_program.cpp"
//     #include "raster/simd/every_instruction_set.hpp"
//
// What follows the include is compiled for each set, inside
//
//     HWY_BEFORE_NAMESPACE(); namespace tuberia::HWY_NAMESPACE { ... } HWY_AFTER_NAMESPACE();
//
// and what stands in `#if HWY_ONCE` is compiled once, after all of them.
// (No include guard: it must work for every file that includes it.)

// Three sets are enough: the baseline, AVX2 with FMA, AVX-512. Each further one costs build time.
#ifndef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE TUBERIA_KERNEL_FILE
#include <hwy/foreach_target.h>  // includes the kernel file again for each set but the last

#include <hwy/highway.h>

#include "raster/instruction_set.hpp"

#ifndef TUBERIA_RASTER_SIMD_FOR_INSTRUCTION_SET
#define TUBERIA_RASTER_SIMD_FOR_INSTRUCTION_SET
// Which of the compiled namespaces serves an InstructionSet: expands to a switch that returns
// N_xxx::FUNCTION ARGUMENTS. The baseline is whatever the build assumes of the machine.
#if (HWY_TARGETS & HWY_AVX3) && (HWY_BASELINE_TARGETS & HWY_AVX3) == 0
#define TUBERIA_CASE_AVX3(CALL) case InstructionSet::avx3: return N_AVX3::CALL;
#else
#define TUBERIA_CASE_AVX3(CALL)
#endif
#if (HWY_TARGETS & HWY_AVX2) && (HWY_BASELINE_TARGETS & HWY_AVX2) == 0
#define TUBERIA_CASE_AVX2(CALL) case InstructionSet::avx2: return N_AVX2::CALL;
#else
#define TUBERIA_CASE_AVX2(CALL)
#endif
#define TUBERIA_RETURN_FOR(INSTRUCTION_SET, CALL) \
  switch (INSTRUCTION_SET) {                      \
    TUBERIA_CASE_AVX3(CALL)                       \
    TUBERIA_CASE_AVX2(CALL)                       \
    default: return HWY_NAMESPACE::CALL;   \
  }
#endif
