#pragma once
// The history of one pixel, over as many draws as it is shown.

#include "pipeline/fragment_record.hpp"

namespace tuberia {

/// In the order of the machine: `initial`, then each fragment with the pixel before and after it.
/// The last one's `after` is what the pixel holds now (or `initial`, without fragments).
struct PixelHistory {
  int x = 0, y = 0;
  PixelContents initial;
  std::vector<RecordedDraw> draws;       // all that were watched, drawn here or not
  std::vector<FragmentRecord> fragments;
};

///     PixelRecorder recorder(target, 320, 240);
///     for (const DrawCall& draw : frame) pipeline.draw(target, draw, recorder);
///     for (const FragmentRecord& fragment : recorder.history().fragments) ...
class PixelRecorder : public Observer {
 public:
  /// The pixel must lie within the target, which is looked at here and not kept.
  PixelRecorder(RenderTarget& target, int x, int y)
      : watch_({x, y, x + 1, y + 1}), x_(x), y_(y), initial_(pixel_contents(target, x, y)) {}

  void begin(const DrawCall& draw, const AcceptedDraw& accepted) override;
  void after(Stage, const Chunk&) override {}
  void after(Stage stage, const Chunk& chunk, const FragmentBlock& block, const Tile& tile) override;

  PixelHistory history() const { return {x_, y_, initial_, draws_, watch_.fragments()}; }

 private:
  FragmentWatch watch_;
  int x_, y_;
  PixelContents initial_;
  std::vector<RecordedDraw> draws_;
};

}  // namespace tuberia
