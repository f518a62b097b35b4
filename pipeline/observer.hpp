#pragma once
// Watching a draw: between the stages, on finished batches.

#include <cstdint>
#include <utility>
#include <vector>

#include "pipeline/batch_plan.hpp"
#include "pipeline/chunk.hpp"
#include "pipeline/validate.hpp"
#include "raster/fragment_block.hpp"

namespace tuberia {

/// The borders at which a draw can be watched, in the order of the pipeline. FragmentShading and
/// DepthTest change places when depth is tested early.
enum class Stage : std::uint8_t {
  vertex_transform,    // chunk.vertices: clip space and outcodes
  primitive_assembly,  // chunk.triangles or chunk.lines or chunk.points
  clipping,            // the same, cut; chunk.vertices.clipped has the new vertices
  perspective_divide,  // chunk.vertices: screen
  culling,             // the primitives that are left
  vertex_attributes,   // chunk.vertices.attributes, of vertices still in use
  set_up,              // chunk.screen_triangles, chunk.shapes
  binning,             // chunk.tiles
  rasterization,       // a block: live, weight, depth_value
  fragment_shading,    // a block: live, colour (fog included)
  alpha_test,          // a block: live
  depth_test,          // a block: live, depth; the tile's depth and stencil
  blending,            // the tile's colours
};

/// Derive from it what shall be told. A watched draw goes through the same stages and leaves the
/// same bits; it runs on one thread, so calls come in order. References last until the call returns.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void begin(const DrawCall&, const AcceptedDraw&) {}
  /// A geometry stage has finished with a chunk.
  virtual void after(Stage, const Chunk&) {}
  /// A fragment stage is about to change a block, or the tile through it; and has done so. No call
  /// `before` rasterization, which makes the blocks.
  virtual void before(Stage, const Chunk&, const FragmentBlock&, const Tile&) {}
  virtual void after(Stage, const Chunk&, const FragmentBlock&, const Tile&) {}
  virtual void end(const DrawStatistics&) {}
};

/// Lets several observers watch one draw; they are told in the order of the list.
class Observers : public Observer {
 public:
  explicit Observers(std::vector<Observer*> all) : all_(std::move(all)) {}
  void begin(const DrawCall& draw, const AcceptedDraw& accepted) override {
    for (Observer* each : all_) each->begin(draw, accepted);
  }
  void after(Stage stage, const Chunk& chunk) override {
    for (Observer* each : all_) each->after(stage, chunk);
  }
  void before(Stage stage, const Chunk& chunk, const FragmentBlock& block, const Tile& tile) override {
    for (Observer* each : all_) each->before(stage, chunk, block, tile);
  }
  void after(Stage stage, const Chunk& chunk, const FragmentBlock& block, const Tile& tile) override {
    for (Observer* each : all_) each->after(stage, chunk, block, tile);
  }
  void end(const DrawStatistics& statistics) override {
    for (Observer* each : all_) each->end(statistics);
  }

 private:
  std::vector<Observer*> all_;
};

/// What the stages are compiled with when nobody watches: nothing.
struct NoTap {
  static constexpr bool kWatches = false;
  static void begin_draw(const BatchPlan&, int) noexcept {}
  static void begin(const Chunk&) noexcept {}
  static void fetched(const Chunk&) noexcept {}
  static void begin_tile(std::int64_t, std::int64_t) noexcept {}
  static void end_tile(std::int64_t, std::int64_t) noexcept {}
  static void after(Stage, const Chunk&) noexcept {}
  static void before(Stage, const Chunk&, const FragmentBlock&, const Tile&) noexcept {}
  static void after(Stage, const Chunk&, const FragmentBlock&, const Tile&) noexcept {}
};

/// Passes everything on to an observer.
struct ObserverTap : NoTap {
  explicit ObserverTap(Observer& observer_told) noexcept : observer(observer_told) {}
  static constexpr bool kWatches = true;
  Observer& observer;
  void after(Stage stage, const Chunk& chunk) const { observer.after(stage, chunk); }
  void before(Stage stage, const Chunk& chunk, const FragmentBlock& block, const Tile& tile) const { observer.before(stage, chunk, block, tile); }
  void after(Stage stage, const Chunk& chunk, const FragmentBlock& block, const Tile& tile) const { observer.after(stage, chunk, block, tile); }
};

}  // namespace tuberia
