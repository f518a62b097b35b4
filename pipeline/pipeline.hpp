#pragma once
// The whole pipeline: a draw call in, pixels out.

#include <memory>
#include <vector>

#include "base/parallel_for.hpp"
#include "base/result.hpp"
#include "pipeline/chunk.hpp"
#include "pipeline/draw_call.hpp"
#include "pipeline/draw_times.hpp"
#include "pipeline/observer.hpp"
#include "raster/render_target.hpp"

namespace tuberia {

struct PipelineOptions {
  int threads = 0;                                    // 0: one a core
  InstructionSet instruction_set = best_instruction_set();
  Precision precision = Precision::exact;
};

/// What a pipeline keeps from draw to draw, for its memory.
struct DrawMemory {
  std::vector<std::unique_ptr<Chunk>> chunks;
  TargetVisibility visibility;                     // what the fused loops remember of every tile
  std::vector<std::vector<FragmentBlock>> blocks;  // the staged loops' scratch memory, one a worker
};

class Pipeline {
 public:
  /// The instruction set must be supported by this machine.
  explicit Pipeline(const PipelineOptions& options = {});

  /// Draws into the target; on an error the target is untouched. In exact precision neither the
  /// threads nor the instruction set change a bit of the result.
  Result<DrawStatistics> draw(RenderTarget& target, const DrawCall& draw_call);

  /// The same on one thread, telling an observer after each stage; the same bits.
  Result<DrawStatistics> draw(RenderTarget& target, const DrawCall& draw_call, Observer& observer);

  /// The same, adding what its parts took to `times`: on the threads and through the loops that it
  /// would take without.
  Result<DrawStatistics> draw(RenderTarget& target, const DrawCall& draw_call, DrawTimes& times);

  /// Linear colour, and depth in [0, 1].
  void clear(RenderTarget& target, const Rgba32F& colour, float depth = 1);
  /// What the command says: with a scissor, masks, stencil. On an error the target is untouched.
  Result<Nothing> clear(RenderTarget& target, const ClearCommand& command) { return target.clear(command, workers_); }

  Workers& workers() noexcept { return workers_; }
  const PipelineOptions& options() const noexcept { return options_; }

 private:
  template <class Tap>
  DrawStatistics run(RenderTarget&, const DrawCall&, const AcceptedDraw&, Workers&, Tap);

  PipelineOptions options_;
  Workers workers_;
  DrawMemory memory_;
};

}  // namespace tuberia
