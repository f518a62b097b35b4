#pragma once
// Figures of what rays depend on.

#include <filesystem>

#include "base/result.hpp"
#include "image/image.hpp"
#include "pipeline/pipeline.hpp"

namespace tuberia::cli {

/// The scene of two mirrors at the depths 0, 1, 2 and 3, row by row.                               [B Fig 51]
Result<Image<Rgba8>> draw_depths_of_reflection(const std::filesystem::path& scenes, Pipeline& pipeline);

/// A part of the same scene with 1, 4 and 9 samples a pixel, each pixel shown as a square.         [B Fig 52, 53]
Result<Image<Rgba8>> draw_uniform_samples(const std::filesystem::path& scenes, Pipeline& pipeline);
Result<Image<Rgba8>> draw_jittered_samples(const std::filesystem::path& scenes, Pipeline& pipeline);

}  // namespace tuberia::cli
