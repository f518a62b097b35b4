#pragma once
// A scene made ready to be drawn by one recipe, over and over.

#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "bench/trade/recipe.hpp"
#include "bench/trade/shapes.hpp"
#include "image/image.hpp"

namespace tuberia::bench::trade {

/// What the eye sees of world space; the target's aspect.
struct Eye {
  glm::dvec3 at{0, 0, 3}, point_of_interest{0, 0, 0};
  double fovy_degrees = 45, near_distance = 0.1, far_distance = 100;
};

class Frame {
 public:
  /// Error for a target that cannot be.
  static Result<Frame> create(const Recipe& recipe, const Rgba32F& background);

  const Recipe& recipe() const noexcept { return recipe_; }

  /// The recipe's state with the eye's matrix and a depth test that suits it.
  PipelineState state_for(const Eye& eye) const;

  void add(std::shared_ptr<const Shape> shape, FragmentProgram program, const PipelineState& state);

  /// Clears, draws, and makes several samples, or many pixels, one. Error for a draw that is refused.
  Result<Nothing> draw();

  /// Linear colours of the picture drawn last.
  Image<Rgba32F> picture() const;

 private:
  Frame(const Recipe& recipe, const Rgba32F& background, RenderTarget target);

  Recipe recipe_;
  Rgba32F background_;
  std::unique_ptr<Pipeline> pipeline_;  // its threads make it stay where it is
  RenderTarget target_;
  std::optional<RenderTarget> resolved_{};  // of several samples
  Image<Rgba32F> mean_{};                   // of what was supersampled
  std::vector<std::shared_ptr<const Shape>> shapes_{};
  std::vector<DrawCall> draws_{};
};

}  // namespace tuberia::bench::trade
