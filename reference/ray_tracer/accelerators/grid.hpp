#pragma once
// Equal voxels, each with the items that touch it, walked one by one.                 [B 5.7.2, Fig 43] [Amanatides]

#include <array>
#include <cstdint>
#include <vector>

#include "reference/ray_tracer/accelerators/search.hpp"

namespace tuberia::tracer {

class Slabs;

/// Of about settings.voxels_per_item voxels for each item, as nearly cubes as the box allows; fewer where large items
/// would be in so many that the grid held more than kMostReferences for each item.
class Grid final : public SearchingAccelerator {
 public:
  static constexpr std::int64_t kMostVoxels = 1 << 24, kMostReferences = 16;

  Grid(const Items& items, Workers& workers, const AcceleratorSettings& settings);

 private:
  struct Range {
    std::array<int, 3> first, last;
    std::int64_t count() const noexcept;
  };
  class Walk;

  void search(Search& search) const noexcept override;
  void choose_voxels(const Box& box, double wanted);
  void fill(const std::vector<BoxedItem>& items);
  std::int64_t references(const std::vector<BoxedItem>& items) const noexcept;
  int voxel_at(double coordinate, int axis) const noexcept;
  Range voxels_of(const Box& box) const noexcept;
  template <class Visit>
  void for_each_voxel(const Range& range, Visit&& visit) const;
  std::size_t index(int x, int y, int z) const noexcept;

  Box box_;
  std::array<int, 3> counts_{0, 0, 0};
  glm::dvec3 voxel_size_{0};
  double margin_ = 0;  // items count as larger by it, so that rounding brings no ray past the voxels that it needs
  double largest_coordinate_ = 0;
  std::vector<std::uint32_t> first_of_voxel_, items_;  // items_[first_of_voxel_[i], first_of_voxel_[i + 1])
};

}  // namespace tuberia::tracer
