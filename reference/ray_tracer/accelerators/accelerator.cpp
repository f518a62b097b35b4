#include "reference/ray_tracer/accelerators/accelerator.hpp"

#include <chrono>

#include "reference/ray_tracer/accelerators/bounding_spheres.hpp"
#include "reference/ray_tracer/accelerators/bvh.hpp"
#include "reference/ray_tracer/accelerators/grid.hpp"
#include "reference/ray_tracer/accelerators/none.hpp"
#include "reference/ray_tracer/accelerators/octree.hpp"

namespace tuberia::tracer {
namespace {

std::unique_ptr<SearchingAccelerator> made(AcceleratorKind kind, const Items& items, Workers& workers, const AcceleratorSettings& settings) {
  switch (kind) {
    case AcceleratorKind::none: return std::make_unique<NoAccelerator>(items);
    case AcceleratorKind::bounding_spheres: return std::make_unique<BoundingSpheres>(items, workers, settings);
    case AcceleratorKind::bvh: return std::make_unique<Bvh>(items, workers, settings);
    case AcceleratorKind::grid: return std::make_unique<Grid>(items, workers, settings);
    case AcceleratorKind::octree: return std::make_unique<Octree>(items, workers, settings);
  }
  return std::make_unique<NoAccelerator>(items);
}

}  // namespace

TraversalWork& TraversalWork::operator+=(const TraversalWork& other) noexcept {
  rays += other.rays;
  item_tests += other.item_tests;
  volume_tests += other.volume_tests;
  return *this;
}

std::unique_ptr<Accelerator> make_accelerator(AcceleratorKind kind, const Items& items, Workers& workers, const AcceleratorSettings& settings) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  std::unique_ptr<SearchingAccelerator> accelerator = made(kind, items, workers, settings);
  accelerator->set_build_seconds(std::chrono::duration<double>(Clock::now() - begin).count());
  return accelerator;
}

std::string_view name_of(AcceleratorKind kind) noexcept {
  switch (kind) {
    case AcceleratorKind::none: return "none";
    case AcceleratorKind::bounding_spheres: return "bounding-spheres";
    case AcceleratorKind::bvh: return "bvh";
    case AcceleratorKind::grid: return "grid";
    case AcceleratorKind::octree: return "octree";
  }
  return "none";
}

}  // namespace tuberia::tracer
