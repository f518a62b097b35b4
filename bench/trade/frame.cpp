#include "bench/trade/frame.hpp"

#include <algorithm>
#include <glm/gtc/constants.hpp>

#include "math/transforms.hpp"

namespace tuberia::bench::trade {
namespace {

/// The means of squares of n x n pixels, divided by `white`. Sums of codes are exact.
template <class Pixel>
Image<Rgba32F> mean_of_squares(const Image<Pixel>& fine, int n, float white) {
  Image<Rgba32F> mean(fine.width() / n, fine.height() / n);
  const float share = 1 / (white * static_cast<float>(n * n));
  for (int y = 0; y < mean.height(); ++y) {
    const std::span<Rgba32F> sums = mean.row(y);
    std::fill(sums.begin(), sums.end(), Rgba32F{0, 0, 0, 0});
    for (int j = 0; j < n; ++j) {
      const Pixel* next = fine.row(y * n + j).data();
      for (Rgba32F& sum : sums)
        for (int i = 0; i < n; ++i, ++next) {
          sum.r += static_cast<float>(next->r);
          sum.g += static_cast<float>(next->g);
          sum.b += static_cast<float>(next->b);
          sum.a += static_cast<float>(next->a);
        }
    }
    for (Rgba32F& sum : sums) sum = {sum.r * share, sum.g * share, sum.b * share, sum.a * share};
  }
  return mean;
}

}  // namespace

Frame::Frame(const Recipe& recipe, const Rgba32F& background, RenderTarget target)
    : recipe_(recipe),
      background_(background),
      pipeline_(std::make_unique<Pipeline>(recipe.pipeline)),
      target_(std::move(target)) {}

Result<Frame> Frame::create(const Recipe& recipe, const Rgba32F& background) {
  RenderTargetDescription description = recipe.target;
  description.width *= recipe.supersampling;
  description.height *= recipe.supersampling;
  auto target = RenderTarget::create(description);
  if (!target) return target.error();
  Frame frame(recipe, background, *std::move(target));
  if (description.samples > 1) {
    description.samples = 1;
    auto resolved = RenderTarget::create(description);
    if (!resolved) return resolved.error();
    frame.resolved_.emplace(*std::move(resolved));
  }
  return frame;
}

PipelineState Frame::state_for(const Eye& eye) const {
  const ClipVolume volume = recipe_.reversed_depth ? ClipVolume::zero_to_w : ClipVolume::minus_w_to_w;
  const double aspect = static_cast<double>(recipe_.target.width) / recipe_.target.height;
  const CameraBasis basis = camera_basis(eye.at, eye.point_of_interest, {0, 1, 0}).value();
  const glm::mat4 clip_from_view = perspective(eye.fovy_degrees * glm::pi<double>() / 180, aspect, eye.near_distance,
                                               eye.far_distance, volume, recipe_.reversed_depth)
                                       .value();
  PipelineState state = recipe_.state;
  state.transform.clip_from_world = compose(clip_from_view, view_from_world(basis, eye.at));
  state.clipping.volume = volume;
  state.depth.test = recipe_.reversed_depth ? Compare::greater : Compare::less;
  return state;
}

void Frame::add(std::shared_ptr<const Shape> shape, FragmentProgram program, const PipelineState& state) {
  draws_.push_back({.mesh = shape->view(), .program = std::move(program), .state = state});
  shapes_.push_back(std::move(shape));
}

Result<Nothing> Frame::draw() {
  pipeline_->clear(target_, background_, recipe_.reversed_depth ? 0.0f : 1.0f);
  for (const DrawCall& each : draws_)
    if (const auto drawn = pipeline_->draw(target_, each); !drawn) return drawn.error();
  if (resolved_)
    if (const auto resolved = resolve(target_, *resolved_, pipeline_->workers()); !resolved) return resolved.error();
  const RenderTarget& drawn = resolved_ ? *resolved_ : target_;
  if (recipe_.supersampling > 1) {
    const bool is_codes = recipe_.target.colour == ColourFormat::rgba8;
    mean_ = is_codes ? mean_of_squares(drawn.colour_image(), recipe_.supersampling, 255)
                     : mean_of_squares(drawn.linear_image(), recipe_.supersampling, 1);
  }
  return Nothing{};
}

Image<Rgba32F> Frame::picture() const {
  return recipe_.supersampling > 1 ? mean_ : (resolved_ ? *resolved_ : target_).linear_image();
}

}  // namespace tuberia::bench::trade
