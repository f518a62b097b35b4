#pragma once
// A figure of light by wavelengths.

#include <filesystem>

#include "base/result.hpp"
#include "image/image.hpp"
#include "pipeline/pipeline.hpp"

namespace tuberia::cli {

/// Two reflectances (columns) that look alike in light of equal energy (upper row), and differ in a warm light:
/// 41 wavelengths, in 14 passes of three.                                               [B 2.9]
Result<Image<Rgba8>> draw_metamers(const std::filesystem::path& scenes, Pipeline& pipeline);

}  // namespace tuberia::cli
