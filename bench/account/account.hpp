#pragma once
// Where one frame of a workload spends its time on one thread, and what that is to be seen against.

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "bench/figures/schedule.hpp"
#include "bench/peers/tuberia_peer.hpp"
#include "pipeline/draw_times.hpp"

namespace tuberia::bench {

/// The items of the account, in the order of the pipeline.
enum class Item {
  clear,
  validation,
  fetch,
  transform,
  assembly,
  clipping,
  divide,
  culling,
  attributes,
  set_up,
  binning,
  coverage_and_depth,    // in the tiles: the draw without colour
  shading_and_blending,  // in the tiles: the rest
  other,                 // between the stages: starting loops, growing lists
};
inline constexpr int kItems = 14;
std::string_view name_of(Item item) noexcept;

/// What the machine allows at best, on one core. Measured on the processor the table's aims are for.
struct MachineLimits {
  double memory_bytes_per_second = 50e9;        // writing to the second and third cache
  double first_cache_bytes_per_second = 240e9;  // reading and writing depth in the first cache
  double texels_per_second = 1.9e9;             // gathered from the first cache
  double instructions_per_cycle = 6;            // that can be handed to the arithmetic units
};

/// Lower bounds of a frame's time in seconds, each as if nothing else were to be done.
struct Bounds {
  double memory = 0;        // vertices and indices read once, the target's bytes written once
  double first_cache = 0;   // depth and colour of every visible fragment
  double texels = 0;        // of every visible fragment
  double instructions = 0;  // if they were counted
  double largest() const noexcept { return std::max({memory, first_cache, texels, instructions}); }
};

struct Account {
  std::string workload;
  std::array<double, kItems> seconds{};  // each piece's shortest time of several frames: the undisturbed one
  double frame_seconds = 0;              // the sum of the items
  std::int64_t triangles = 0;
  DrawStatistics counts;
  std::int64_t visible = 0;  // fragments that must be shaded: one a covered pixel; of blended ones all that pass
  std::int64_t instructions = 0;  // if they were counted: of an AVX2 frame
  Bounds bounds;
  Work work;                   // the same pieces, for the schedule
  double speed_up_of_two = 0;  // the least frame on one thread over the least on two

  double of(Item item) const noexcept { return seconds[static_cast<std::size_t>(item)]; }
  double geometry_seconds() const noexcept;
  double tile_seconds() const noexcept { return of(Item::coverage_and_depth) + of(Item::shading_and_blending); }
  Item largest_item() const noexcept;
};

struct AccountOptions {
  InstructionSet instruction_set = best_instruction_set();
  Precision precision = Precision::exact;
  int frames = 7;
  MachineLimits limits{};
};

Result<Account> account_for(const Workload& workload, const AccountOptions& options);

}  // namespace tuberia::bench
