#include "reference/ray_tracer/sampling.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <vector>

#include "math/lattice_noise.hpp"
#include "reference/ray_tracer/sample_rows.hpp"

namespace tuberia::tracer {

using description::Sampling;

namespace {

constexpr int kMostCells = 32;                  // along a pixel: 1024 samples
constexpr double kLargestRadius = 8;            // pixels
constexpr int kTileSize = 32;                   // pixels
constexpr std::int64_t kKeptSamples = 2 << 20;  // about 50 MB, which bounds the memory of large pictures

struct PixelArea {
  int x0, y0, x1, y1;  // without the last ones
};

/// The samples of one tile.
class TileSampler {
 public:
  TileSampler(const LightAt& light_at, const Sampling& sampling, SampleRows& rows, int worker)
      : light_at_(light_at), sampling_(sampling), pattern_(sampling), cells_(pattern_.cells()), rows_(rows), worker_(worker) {}

  /// Returns how often it asked.
  std::int64_t sample(const PixelArea& tile) {
    for (int y = tile.y0; y < tile.y1; ++y)
      for (int x = tile.x0; x < tile.x1; ++x) {
        const glm::ivec2 first = glm::ivec2(x, y) * cells_;
        if (sampling_.adaptive)
          divide(first, cells_);
        else
          ask_for_all(first);
      }
    return questions_;
  }

 private:
  glm::dvec3 ask(const glm::dvec2& point) {
    ++questions_;
    return light_at_(point, worker_);
  }

  /// Corners are shared: by neighbours, and by an area and its parts.
  glm::dvec3 corner(const glm::ivec2& at) {
    const auto key = static_cast<std::uint64_t>(at.y) << 32 | static_cast<std::uint32_t>(at.x);
    const auto [entry, is_new] = corners_.try_emplace(key);
    if (is_new) entry->second = ask(glm::dvec2(at) / static_cast<double>(cells_));
    return entry->second;
  }

  void ask_for_all(const glm::ivec2& first) {
    for (int y = 0; y < cells_; ++y)
      for (int x = 0; x < cells_; ++x) {
        const glm::ivec2 cell = first + glm::ivec2(x, y);
        rows_.at(cell) = ask(pattern_.position(cell));
      }
  }

  /// An area of size x size cells: smooth, or the sum of its quarters.                       [B 5.8.2]
  void divide(const glm::ivec2& first, int size) {
    const std::array corners{corner(first), corner(first + glm::ivec2(size, 0)), corner(first + glm::ivec2(0, size)), corner(first + size)};
    const bool is_smooth = glm::all(glm::lessThanEqual(contrast_of(corners), sampling_.contrast));
    if (!is_smooth && sampling_.pattern == Sampling::Pattern::jittered) return ask_for_all(first);
    if (is_smooth || size == 1) return interpolate(first, size, corners);
    const int half = size / 2;
    for (const glm::ivec2 quarter : {glm::ivec2(0, 0), glm::ivec2(half, 0), glm::ivec2(0, half), glm::ivec2(half, half)})
      divide(first + quarter, half);
  }

  /// Bilinear between the corners; the mean of all cells is that of the corners where they lie evenly.
  void interpolate(const glm::ivec2& first, int size, const std::array<glm::dvec3, 4>& corners) {
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const glm::ivec2 cell = first + glm::ivec2(x, y);
        const glm::dvec2 at = (pattern_.position(cell) * static_cast<double>(cells_) - glm::dvec2(first)) / static_cast<double>(size);
        rows_.at(cell) = glm::mix(glm::mix(corners[0], corners[1], at.x), glm::mix(corners[2], corners[3], at.x), at.y);
      }
  }

  const LightAt& light_at_;
  const Sampling& sampling_;
  SamplePattern pattern_;
  int cells_;
  SampleRows& rows_;
  int worker_;
  std::int64_t questions_ = 0;
  std::unordered_map<std::uint64_t, glm::dvec3> corners_;
};

/// size: of the picture.
glm::dvec3 filtered(const SamplePattern& pattern, const PixelFilter& filter, SampleRows& rows, const glm::ivec2& size, const glm::ivec2& pixel) noexcept {
  const glm::ivec2 first = glm::max(pixel - filter.margin(), glm::ivec2(0)) * pattern.cells();
  const glm::ivec2 end = glm::min(pixel + filter.margin() + 1, size) * pattern.cells();
  glm::dvec3 light(0);
  double weights = 0;
  for (int y = first.y; y < end.y; ++y)
    for (int x = first.x; x < end.x; ++x) {
      const double weight = filter.weight(pattern.position({x, y}) - (glm::dvec2(pixel) + 0.5));
      if (weight == 0) continue;
      light += weight * rows.at({x, y});
      weights += weight;
    }
  return light / weights;
}

}  // namespace

SamplePattern::SamplePattern(const Sampling& sampling) noexcept
    : jittered_(sampling.pattern == Sampling::Pattern::jittered), seed_(sampling.seed),
      cells_(std::clamp(static_cast<int>(std::lround(std::sqrt(std::max(sampling.per_pixel, 1)))), 1, kMostCells)) {
  if (sampling.adaptive && !jittered_) cells_ = static_cast<int>(std::bit_ceil(static_cast<unsigned>(cells_)));
  spacing_ = sampling.adaptive ? 1 : 1.0 / cells_;
}

glm::dvec2 SamplePattern::position(const glm::ivec2& cell) const noexcept {
  glm::dvec2 within(0.5);
  if (jittered_)
    for (int axis = 0; axis < 2; ++axis) within[axis] = lattice_hash(cell.x, cell.y, axis, seed_) * 0x1p-32;
  return (glm::dvec2(cell) + within) / static_cast<double>(cells_);
}

PixelFilter::PixelFilter(const Sampling& sampling) noexcept : gaussian_(sampling.filter == Sampling::Filter::gaussian) {
  // The pixel's centre is the middle of a cell, or the corner of four: no farther than this from the nearest sample.
  const int cells = SamplePattern(sampling).cells();
  const double reach = 1.5 / std::max(cells, 2);
  radius_ = sampling.filter_radius > reach ? std::min(sampling.filter_radius, kLargestRadius) : reach;
  margin_ = gaussian_ ? static_cast<int>(std::ceil(radius_ - 0.5)) : 0;
}

double PixelFilter::weight(const glm::dvec2& offset_pixels) const noexcept {
  if (!gaussian_) return 1;
  const double squared = glm::dot(offset_pixels, offset_pixels) / (radius_ * radius_);
  return squared <= 1 ? std::exp(-4.5 * squared) : 0;
}

glm::dvec3 contrast_of(std::span<const glm::dvec3, 4> corners) noexcept {
  const glm::dvec3 least = glm::min(glm::min(corners[0], corners[1]), glm::min(corners[2], corners[3]));
  const glm::dvec3 most = glm::max(glm::max(corners[0], corners[1]), glm::max(corners[2], corners[3]));
  glm::dvec3 contrast(0);
  for (int channel = 0; channel < 3; ++channel)
    if (most[channel] + least[channel] != 0) contrast[channel] = (most[channel] - least[channel]) / (most[channel] + least[channel]);
  return contrast;
}

SampledPicture sample_picture(const LightAt& light_at, int width, int height, const Sampling& sampling, Workers& workers,
                              const TraceProgress& progress) {
  if (width < 1 || height < 1) return {};
  SampledPicture picture{.light = Image<Rgba32F>(width, height)};
  const SamplePattern pattern(sampling);
  const PixelFilter filter(sampling);
  const int cells = pattern.cells(), margin = filter.margin();
  const int band = static_cast<int>(std::clamp<std::int64_t>(kKeptSamples / (static_cast<std::int64_t>(width) * cells * cells), 1, height));
  std::vector<std::int64_t> questions(static_cast<std::size_t>(workers.thread_count()));
  ProgressReport report(progress, static_cast<double>(width) * height);
  SampleRows rows(width, cells);
  const auto sample_rows = [&](int first, int end) {
    const int across = (width + kTileSize - 1) / kTileSize, down = (end - first + kTileSize - 1) / kTileSize;
    parallel_for(workers, static_cast<std::int64_t>(across) * down, [&](std::int64_t tile, int worker) {
      const int x = static_cast<int>(tile % across) * kTileSize, y = first + static_cast<int>(tile / across) * kTileSize;
      const PixelArea area{x, y, std::min(x + kTileSize, width), std::min(y + kTileSize, end)};
      questions[static_cast<std::size_t>(worker)] += TileSampler(light_at, sampling, rows, worker).sample(area);
      report.add(static_cast<double>(area.x1 - area.x0) * (area.y1 - area.y0));
    });
  };

  // Bands of rows, one after the other; samples that the next band's filter reaches back for are kept.
  for (int top = 0; top < height; top += band) {
    const int bottom = std::min(top + band, height), sampled = rows.end();
    rows.hold(std::max(top - margin, 0), std::min(bottom + margin, height));
    sample_rows(sampled, rows.end());
    parallel_for(workers, bottom - top, [&](std::int64_t row, int) {
      const int y = top + static_cast<int>(row);
      for (int x = 0; x < width; ++x) {
        const glm::vec3 light(filtered(pattern, filter, rows, {width, height}, {x, y}));
        picture.light.at(x, y) = {light.r, light.g, light.b, 1};
      }
    });
  }
  for (const std::int64_t count : questions) picture.questions += count;
  return picture;
}

}  // namespace tuberia::tracer
