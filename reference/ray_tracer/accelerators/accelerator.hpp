#pragma once
// Finding the nearest of many items without asking each.                            [B 5.7]

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "base/parallel_for.hpp"
#include "reference/ray_tracer/items.hpp"

namespace tuberia::tracer {

/// none: every item is asked [C]; bounding_spheres: a hierarchy of them [B 5.7.1]; bvh: a hierarchy of boxes, split by the surface
/// area heuristic; grid: equal voxels, walked one by one [B Fig 43]; octree: voxels cut in eight where there are many items [B Fig 44].
enum class AcceleratorKind : std::uint8_t { none, bounding_spheres, bvh, grid, octree };

/// What rays cost, of all rays that a Traversal was used for.
struct TraversalWork {
  std::int64_t rays = 0;
  std::int64_t item_tests = 0;
  std::int64_t volume_tests = 0;  // boxes, spheres, or voxels walked through
  TraversalWork& operator+=(const TraversalWork& other) noexcept;
  bool operator==(const TraversalWork&) const = default;
};

/// The memory of one worker between rays: its counts, and which items the present ray has met already [B 5.7.2].
struct Traversal {
  TraversalWork work;
  std::vector<std::uint32_t> mailboxes;  // the number of the ray that asked each item last
  std::uint32_t ray_number = 0;
};

struct AcceleratorFacts {
  double build_seconds = 0;
  std::int64_t memory_bytes = 0;
  std::int64_t volumes = 0;  // nodes or voxels
  int depth = 0;             // of the deepest one; a grid's is 1
};

struct AcceleratorSettings {
  int most_items = 4;            // in a leaf or an octree's voxel before it is split
  int most_depth = 24;           // of an octree
  double voxels_per_item = 4;    // of a grid, about
};

/// The same nearest hit whichever it is, to the last bit. Items whose box is infinite are asked by every ray.
class Accelerator {
 public:
  virtual ~Accelerator() = default;
  /// An unsound ray meets nothing.
  virtual Hit nearest(const Ray& ray, Traversal& traversal) const noexcept = 0;
  /// Whether there is anything between t_min and t_max.
  virtual bool any(const Ray& ray, Traversal& traversal) const noexcept = 0;
  virtual AcceleratorFacts facts() const noexcept = 0;
};

/// items must outlive it. The same hierarchy for any number of workers.
std::unique_ptr<Accelerator> make_accelerator(AcceleratorKind kind, const Items& items, Workers& workers, const AcceleratorSettings& settings = {});

std::string_view name_of(AcceleratorKind kind) noexcept;  // "none", "bounding-spheres", "bvh", "grid", "octree"

}  // namespace tuberia::tracer
