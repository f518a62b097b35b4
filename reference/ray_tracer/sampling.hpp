#pragma once
// Where a picture asks for light, and how the answers become pixels, whoever answers.        [B 5.8] [C]
//
// Each pixel is cut in k x k cells with one sample each. Cells and their corners are numbered across the whole picture: pixel
// (i, j) has the cells from (i k, j k), and corner (a, b) lies at (a / k, b / k) pixels.

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "base/parallel_for.hpp"
#include "image/image.hpp"
#include "reference/ray_tracer/progress.hpp"
#include "scene/description/tracing.hpp"

namespace tuberia::tracer {

/// The light at a point of the picture, linear RGB. The point is in pixels, (0, 0) the upper left corner. The same question must
/// get the same answer from every worker, whose number may index scratch memory.
using LightAt = std::function<glm::dvec3(const glm::dvec2& point, int worker)>;

/// Where samples lie.                                                              [B 5.8.1]
class SamplePattern {
 public:
  explicit SamplePattern(const description::Sampling& sampling) noexcept;

  /// k, 1..32: the root of per_pixel; of adaptive uniform sampling the next power of 2, since areas are cut in four.
  int cells() const noexcept { return cells_; }
  /// How far apart the points are that a picture is made of, in pixels: with adaptive sampling corners of whole pixels are among them.
  double spacing() const noexcept { return spacing_; }
  /// In pixels: the centre of the cell, or a random point of it, which depends on the cell and the seed only.
  glm::dvec2 position(const glm::ivec2& cell) const noexcept;

 private:
  bool jittered_;
  std::uint32_t seed_;
  int cells_;
  double spacing_;
};

/// How much a sample counts, by its distance from the pixel's centre.                          [B 5.8.1]
class PixelFilter {
 public:
  explicit PixelFilter(const description::Sampling& sampling) noexcept;

  /// How many pixels beside its own a pixel wants samples of. A box: 0.
  int margin() const noexcept { return margin_; }
  /// Relative to a sample in the centre. A Gaussian's standard deviation is a third of its radius, where it ends; the radius is
  /// filter_radius, or what it takes to reach a sample. A box: 1 everywhere.
  double weight(const glm::dvec2& offset_pixels) const noexcept;

 private:
  bool gaussian_;
  double radius_;
  int margin_;
};

/// (max - min) / (max + min) of each channel, 0 where the sum is 0.                         [B 5.8.2] [FIX 26]
glm::dvec3 contrast_of(std::span<const glm::dvec3, 4> corners) noexcept;

struct SampledPicture {
  Image<Rgba32F> light;      // linear, not exposed; alpha 1
  std::int64_t questions = 0;  // how often light_at was called
};

/// Same bits for any number of workers. Without `adaptive` each sample is asked for. With it the corners of pixels are, and those
/// of quarters where contrast is above the limits, down to cells [B 5.8.2]; cells within corners that are alike are interpolated.
/// Jittered and adaptive, a pixel whose corners differ takes all of its samples. Corners are asked for once in each tile of 32 x 32
/// pixels, so those on the border of two tiles twice. At the picture's border the filter makes do with the samples that there are.
/// A width or height below 1 gives an empty picture; per_pixel and filter_radius are brought into their ranges.
SampledPicture sample_picture(const LightAt& light_at, int width_pixels, int height_pixels, const description::Sampling& sampling,
                              Workers& workers, const TraceProgress& progress = {});

}  // namespace tuberia::tracer
