#pragma once
// Everything that `tuberia stages` shows: gathered once, then printed, or written as JSON or a page.

#include <optional>

#include "examples/tuberia/frame_maps.hpp"
#include "examples/tuberia/render_model.hpp"
#include "pipeline/pixel_recorder.hpp"
#include "pipeline/primitive_recorder.hpp"

namespace tuberia::cli {

struct PixelPlace {
  int x = 0, y = 0;
};

struct StageRequest {
  std::optional<std::int64_t> primitive;  // in the frame, or in `draw`; none: the one in the middle of the picture
  std::optional<int> draw;
  std::optional<PixelPlace> pixel;
};

struct StageReport {
  Frame frame;                       // drawn
  std::string caption;               // what was drawn
  std::vector<std::string> mesh_of_draw;
  std::vector<std::int64_t> first_primitive;  // of each draw in the frame; one more at the end
  DrawStatistics statistics;
  FrameMaps maps;
  bool chosen = false;               // the primitive was asked for, not found
  int draw = 0;
  std::int64_t primitive = 0;        // in its draw
  PrimitiveLife life;
  PixelRect window;                  // where the life's fragments are recorded
  std::optional<PixelHistory> pixel;
};

/// Errors: as prepare(); a primitive, draw or pixel that the frame does not have.
Result<StageReport> stage_report(const Model& model, const RenderOptions& options, const StageRequest& request, Pipeline& pipeline);

}  // namespace tuberia::cli
