#pragma once
// A model as the adviser draws it, over and over.

#include <memory>

#include "scene/adviser/adviser.hpp"

namespace tuberia {

class ModelPicture final : public AdvisedPicture {
 public:
  /// view: of the reference but for the switches of quality_switches(). threads as in PipelineOptions;
  /// the model must outlive this. background: linear.
  ModelPicture(const DrawableModel& model, const ModelView& view, const Rgba32F& background, const PipelineOptions& options)
      : model_(model), view_(view), background_(background), exact_(with_precision(options, Precision::exact)),
        fast_(with_precision(options, Precision::fast)) {}

  Result<Nothing> draw(const Quality& quality, RenderTarget& target, const std::optional<PixelRect>& only) override;

 private:
  static PipelineOptions with_precision(PipelineOptions options, Precision precision) {
    options.precision = precision;
    return options;
  }

  const DrawableModel& model_;
  ModelView view_;
  Rgba32F background_;
  Pipeline exact_, fast_;
};

}  // namespace tuberia
