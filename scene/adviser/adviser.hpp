#pragma once
// Picks the setting of the switches that a budget of error or of time allows: from what was measured of
// other scenes, then by trying it on this one.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "raster/render_target.hpp"
#include "scene/adviser/measured_trade.hpp"
#include "scene/adviser/search.hpp"

namespace tuberia {

/// What a picture may cost; at least one of both.
struct Budget {
  std::optional<double> rmse;     // against the reference, of r, g and b as the screen shows them, 0..1
  std::optional<double> seconds;  // a frame, clearing included
};

/// A picture that can be drawn in any quality.
class AdvisedPicture {
 public:
  virtual ~AdvisedPicture() = default;
  /// Clears and draws the whole picture, or only the pixels in a rectangle.
  virtual Result<Nothing> draw(const Quality& quality, RenderTarget& target, const std::optional<PixelRect>& only) = 0;
};

/// One quality, as predicted and as it turned out.
struct Trial {
  Quality quality;
  Effect predicted;
  double rmse = 0;             // over the sampled tiles
  double rmse_at_most = 0;     // over the picture: the sample's, and two standard errors more
  double seconds = 0;          // the shortest of a few frames
};

struct Advice {
  Trial chosen;
  std::vector<Trial> trials;   // in the order in which they were tried, the first as predicted
  double reference_seconds = 0;
  int sampled_tiles = 0, tiles = 0;
  bool keeps_budget = true;    // false: not even the reference does, or nothing is fast enough
  int stepped_up = 0;          // trials that broke the budget although the prediction kept it
};

class Adviser {
 public:
  Adviser(AdvisedPicture& picture, const RenderTargetDescription& target, const SurfaceTraits& traits,
          const MeasuredTrade& trade = MeasuredTrade::built_in());

  /// Draws and measures until the cheapest quality is found that keeps the error (or, with a budget of
  /// time alone, the most accurate one that keeps the time). Error when a draw is refused.
  Result<Advice> advise(const Budget& budget);

  /// One quality, measured on this picture.
  Result<Trial> attempt(const Quality& quality);

 private:
  Result<Nothing> draw_reference_tiles();
  Result<double> seconds_of_a_frame(const Quality& quality);
  Result<Nothing> time_in_turns(std::vector<Trial>& trials);
  Result<Advice> cheapest_within_error(double rmse);
  Result<Advice> best_within_time(double seconds);
  Result<Advice> search_for(const std::function<Outcome(const Effect&)>& predicted, const std::function<Outcome(const Trial&)>& measured,
                            const IsWorse& is_worse);

  AdvisedPicture& picture_;
  RenderTargetDescription description_;
  SurfaceTraits traits_;
  const MeasuredTrade& trade_;
  std::optional<RenderTarget> target_;
  struct ReferenceTile {
    PixelRect rect;
    std::vector<Rgba8> codes;
  };
  std::vector<ReferenceTile> reference_;
  Trial reference_trial_;
};

/// Numbers of `count` of `tiles` tiles, spread evenly; all when there are no more.
std::vector<int> spread_tiles(int tiles, int count);

}  // namespace tuberia
