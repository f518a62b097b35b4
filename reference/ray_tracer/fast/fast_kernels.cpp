#include "reference/ray_tracer/fast/fast_kernels.hpp"

#include <vector>

// Three sets are enough: the baseline, AVX2, AVX-512. Each further one costs build time.
#ifndef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#endif
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "reference/ray_tracer/fast/fast_kernels.cpp"
#include <hwy/foreach_target.h>  // includes this file again for each set but the last

#include <hwy/highway.h>

#include "reference/ray_tracer/fast/bundle-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace tuberia::tracer {
namespace HWY_NAMESPACE {

FastHit nearest(const WideTree& tree, const FastRay& ray) noexcept {
  FilterRay filter;
  return !tree.nodes.empty() && set_up(filter, tree, ray) ? nearest_of_one(tree, ray, filter) : FastHit{};
}

void nearest_of_many(const WideTree& tree, const FastRay* rays, FastHit* hits, std::int64_t count) noexcept {
  for (std::int64_t first = 0; first < count; first += kMostInBundle) {
    const int size = static_cast<int>(std::min<std::int64_t>(count - first, kMostInBundle));
    FilterBundle bundle;
    if (!tree.nodes.empty() && set_up(bundle, tree, rays + first, size)) {
      BundleTraversal traversal(bundle, rays + first, size);
      traversal.run(tree);
      traversal.store(hits + first);
    } else {
      for (std::int64_t i = first; i < first + size; ++i) hits[i] = nearest(tree, rays[i]);
    }
  }
}

FastKernels kernels(std::string_view name) { return {name, nearest, nearest_of_many}; }

}  // namespace HWY_NAMESPACE
}  // namespace tuberia::tracer
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace tuberia::tracer {
namespace {

// The baseline is what the build assumes of every machine.
std::vector<FastKernels> kernels_of_this_machine() {
#if HWY_ARCH_X86
  std::vector<FastKernels> found{HWY_NAMESPACE::kernels("sse4")};
#else
  std::vector<FastKernels> found{HWY_NAMESPACE::kernels("baseline")};
#endif
  [[maybe_unused]] const auto has = [](std::int64_t target) { return (static_cast<std::int64_t>(hwy::SupportedTargets()) & target) != 0; };
#if (HWY_TARGETS & HWY_AVX2) && (HWY_BASELINE_TARGETS & HWY_AVX2) == 0
  if (has(HWY_AVX2)) found.push_back(N_AVX2::kernels("avx2"));
#endif
#if (HWY_TARGETS & HWY_AVX3) && (HWY_BASELINE_TARGETS & HWY_AVX3) == 0
  if (has(HWY_AVX3)) found.push_back(N_AVX3::kernels("avx3"));
#endif
  return found;
}

}  // namespace

std::span<const FastKernels> fast_kernels() {
  static const std::vector<FastKernels> found = kernels_of_this_machine();
  return found;
}

}  // namespace tuberia::tracer
#endif
