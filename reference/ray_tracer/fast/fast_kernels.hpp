#pragma once
// What is compiled once for every instruction set.

#include <span>
#include <string_view>

#include "reference/ray_tracer/fast/fast_triangles.hpp"
#include "reference/ray_tracer/fast/wide_tree.hpp"

namespace tuberia::tracer {

struct FastKernels {
  std::string_view instruction_set;
  FastHit (*nearest)(const WideTree& tree, const FastRay& ray) noexcept;
  void (*nearest_of_many)(const WideTree& tree, const FastRay* rays, FastHit* hits, std::int64_t count) noexcept;
};

/// Of the instruction sets that this machine has, narrowest first; never empty.
std::span<const FastKernels> fast_kernels();

}  // namespace tuberia::tracer
