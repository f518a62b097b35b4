#pragma once
// A scene by two witnesses: the pipeline and the ray tracer.                            [A 2.1] [rules Y5]

#include <functional>
#include <glm/vec2.hpp>
#include <string_view>

#include "base/result.hpp"
#include "examples/tuberia/witness/comparison.hpp"
#include "pipeline/pipeline.hpp"
#include "scene/description/scene_description.hpp"

namespace tuberia::witness {

struct WitnessOptions {
  glm::ivec2 size_pixels{240, 160};
  PipelineOptions pipeline{};
  std::function<void(std::string_view step, double done)> progress{};  // done: 0..1, of the step
};

/// Draws one description and traces the other, which is the same but in tests of the witness itself, one sample a pixel, and
/// explains every pixel that differs. Errors: of SceneFrame and of TracedScene.
Result<Comparison> compare_witnesses(const SceneDescription& drawn, const SceneDescription& traced, const WitnessOptions& options);

}  // namespace tuberia::witness
