#pragma once
// Items in spheres, and groups of them in larger spheres: what a ray passes by need not be asked.        [B 5.7.1]

#include <cstdint>
#include <vector>

#include "reference/ray_tracer/accelerators/search.hpp"

namespace tuberia::tracer {

class BoundingSpheres final : public SearchingAccelerator {
 public:
  BoundingSpheres(const Items& items, Workers& workers, const AcceleratorSettings& settings);

 private:
  struct ItemSphere {
    BoundingSphere sphere;
    std::uint32_t item = 0;
  };
  /// count = 0: the groups in it are groups[first] and groups[first + 1]. Otherwise items[first, first + count).
  struct Group {
    BoundingSphere sphere;
    std::uint32_t first = 0, count = 0;
  };
  class Builder;

  void search(Search& search) const noexcept override;

  std::vector<Group> groups_;  // the outermost first
  std::vector<ItemSphere> items_;
  double largest_coordinate_ = 0;
};

}  // namespace tuberia::tracer
