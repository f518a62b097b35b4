#pragma once
// A cube cut in eight wherever it holds many items, so that rays cross large empty voxels at once.  [B 5.7.2, Fig 44] [Glassner]

#include <cstdint>
#include <vector>

#include "reference/ray_tracer/accelerators/search.hpp"

namespace tuberia::tracer {

/// A voxel with more than settings.most_items is cut, down to settings.most_depth; but not where most items would be in
/// most of the eight, nor beyond kMostReferences items in leaves, or kMostVoxels, for each item of the scene. The voxels
/// that it counts are the leaves that a ray passes.
class Octree final : public SearchingAccelerator {
 public:
  static constexpr std::int64_t kMostReferences = 16, kMostVoxels = 16;
  static constexpr int kDeepest = 40;

  Octree(const Items& items, Workers& workers, const AcceleratorSettings& settings);

 private:
  /// count = kCut: nodes[first, first + 8), the bits of the number say on which side of x, y and z. Otherwise a leaf's items.
  struct Node {
    std::uint32_t first = 0, count = 0;
  };
  static constexpr std::uint32_t kCut = 0xffffffff;
  struct Voxel {
    glm::dvec3 lower{0};
    double edge = 0;
    Voxel part(unsigned number) const noexcept;
    Box box() const noexcept { return {lower, lower + edge}; }
  };
  class Builder;

  void search(Search& search) const noexcept override;

  Voxel root_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> items_;
  double largest_coordinate_ = 0;
};

}  // namespace tuberia::tracer
