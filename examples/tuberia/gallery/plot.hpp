#pragma once
// Curves as pictures, drawn by the pipeline's own lines.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "base/result.hpp"
#include "image/image.hpp"
#include "pipeline/pipeline.hpp"

namespace tuberia::cli {

struct Curve {
  std::vector<glm::vec2> points;  // in the plot's units, at least two
  glm::vec3 colour{1};            // linear RGB
};

struct Plot {
  int width_pixels = 640, height_pixels = 320;
  glm::vec2 lower_left{0, 0}, upper_right{1, 1};  // what the picture shows, in the plot's units
  glm::vec2 grid{0.25f, 0.25f};                   // steps between the lines of the grid, from 0
  std::vector<Curve> curves;
};

/// Lines of two pixels over a thin grid, eight samples a pixel. sRGB codes.
/// Error for a plot without extent, without pixels, or with more than 1000 grid lines.
Result<Image<Rgba8>> drawn(const Plot& plot, Pipeline& pipeline);

/// Pictures of one width, the first one on top.
Image<Rgba8> stacked(const std::vector<Image<Rgba8>>& pictures);

/// Pictures of one height from left to right, with a gap of a few pixels.
Image<Rgba8> side_by_side(const std::vector<Image<Rgba8>>& pictures);

}  // namespace tuberia::cli
