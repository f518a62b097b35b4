// In place of embree.cpp where there is no Embree.

#include "bench/trace/ray_kernel.hpp"

namespace tuberia::bench {

RayKernels embree_kernels(const TriangleSoup&, int) { return {}; }

std::string embree_sentence() { return {}; }

}  // namespace tuberia::bench
