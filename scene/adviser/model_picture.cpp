#include "scene/adviser/model_picture.hpp"

namespace tuberia {

Result<Nothing> ModelPicture::draw(const Quality& quality, RenderTarget& target, const std::optional<PixelRect>& only) {
  const QualityState state = with_quality({.view = view_}, quality);
  Pipeline& pipeline = state.precision == Precision::exact ? exact_ : fast_;
  const ClearCommand clear{.colour = background_, .depth = view_.reversed_depth ? 0.0f : 1.0f, .scissor = only};
  if (const auto cleared = pipeline.clear(target, clear); !cleared) return cleared.error();
  for (DrawCall& draw : model_.draws(state.view)) {
    if (only) draw.state.rasterization.scissor = *only;
    if (const auto drawn = pipeline.draw(target, draw); !drawn) return drawn.error();
  }
  return Nothing{};
}

}  // namespace tuberia
