#include "pipeline/pixel_recorder.hpp"

namespace tuberia {

void PixelRecorder::begin(const DrawCall& draw, const AcceptedDraw& accepted) {
  watch_.begin(accepted.output, static_cast<int>(draws_.size()));
  draws_.push_back({std::string(draw.program.interface().name), accepted.output, draw.state.rasterization.flat_shading});
}

void PixelRecorder::after(Stage stage, const Chunk& chunk, const FragmentBlock& block, const Tile& tile) {
  if (stage == Stage::rasterization) watch_.rasterized(chunk, block, tile);
  else watch_.after(stage, block, tile);
}

}  // namespace tuberia
