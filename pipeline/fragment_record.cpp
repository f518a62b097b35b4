#include "pipeline/fragment_record.hpp"

#include <algorithm>

namespace tuberia {
namespace {

using Weights = std::array<double, 3>;

struct Divided {
  Weights weight;
  double sum;  // of 1/w there, relative to the largest
};

Divided divided(const Weights& linear, const ScreenTriangle& triangle) {
  Divided result{linear, 0};
  for (std::size_t k = 0; k < 3; ++k) result.sum += result.weight[k] *= static_cast<double>(triangle.inverse_w[k]);
  for (double& weight : result.weight) weight /= result.sum;
  return result;
}

/// As the fragment stages correct the weights at a pixel of column x.
Weights corrected(const ScreenTriangle& triangle, const Weights& linear, int x) {
  const int length = triangle.perspective;
  if (length == kIsAffine) return linear;
  const Divided here = divided(linear, triangle);
  if (length == kDividesEachPixel) return here.weight;
  const int along = x % length;
  const auto moved = [&](int pixels) {
    Weights there = linear;
    for (std::size_t k = 1; k < 3; ++k) {
      const double change = static_cast<double>(triangle.per_x[k]) * static_cast<double>(triangle.weight_scale) * pixels;
      there[k] += change;
      there[0] -= change;
    }
    return divided(there, triangle);
  };
  const Divided start = moved(-along), end = moved(length - along);
  const double least = 0.5 * static_cast<double>(*std::min_element(triangle.inverse_w, triangle.inverse_w + 3));
  if (!(start.sum >= least && end.sum >= least)) return here.weight;
  Weights result;
  for (std::size_t k = 0; k < 3; ++k) result[k] = start.weight[k] + (end.weight[k] - start.weight[k]) * along / length;
  return result;
}

/// Weights of all three vertices; the record has those of the last two.
void set_weights(FragmentRecord& fragment, const ScreenTriangle& triangle, const FragmentBlock& block, int index) {
  const double w1 = static_cast<double>(block.weight[0][index]), w2 = static_cast<double>(block.weight[1][index]);
  fragment.weight = {1 - w1 - w2, w1, w2};
  fragment.perspective = corrected(triangle, fragment.weight, fragment.x);
}

bool is_live(const FragmentBlock& block, int sample, int index) { return (block.sample_live[sample] >> index & 1u) != 0; }

}  // namespace

bool FragmentRecord::reached_the_target() const noexcept {
  return std::any_of(samples.begin(), samples.end(), [](const SampleRecord& s) { return !s.died_at; });
}

std::optional<Stage> FragmentRecord::died_at() const noexcept {
  if (reached_the_target() || stages.empty()) return std::nullopt;
  return stages.back();
}

void FragmentWatch::rasterized(const Chunk& chunk, const FragmentBlock& block, const Tile& tile) {
  first_of_block_ = fragments_.size();
  if (intersection(window_, {block.left, block.top, block.left + kBlockSize, block.top + kBlockSize}).empty()) return;
  for (int index = 0; index < kBlockPixels; ++index)
    if ((block.live >> index & 1u) != 0) add(chunk, block, tile, index);
}

void FragmentWatch::add(const Chunk& chunk, const FragmentBlock& block, const Tile& tile, int index) {
  const int x = block.left + block_x(index), y = block.top + block_y(index);
  if (x < window_.left || x >= window_.right || y < window_.top || y >= window_.bottom) return;
  const ScreenTriangle& triangle = *block.triangle;
  FragmentRecord fragment{.draw = draw_, .primitive = triangle.primitive, .x = x, .y = y, .is_back = triangle.is_back != 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t slot = own_slot(chunk.vertices, triangle.vertex[k]);
    fragment.slot[k] = slot;
    fragment.vertex[k] = slot < chunk.vertices.source.size() ? std::int64_t{chunk.vertices.source[slot]} : -1;
  }
  set_weights(fragment, triangle, block, index);
  fragment.stages.push_back(Stage::rasterization);
  const PixelContents contents = pixel_contents(tile, output_.colour_format, x, y);
  for (int s = 0; s < block.samples; ++s)
    if (is_live(block, s, index)) {
      const SampleContents& now = contents[static_cast<std::size_t>(s)];
      fragment.samples.push_back({.sample = s, .depth_value = block.depth_value[s][index], .depth_code = {}, .died_at = {},
                                  .before = now, .after = now});
    }
  fragments_.push_back(std::move(fragment));
}

void FragmentWatch::after(Stage stage, const FragmentBlock& block, const Tile& tile) {
  for (std::size_t i = first_of_block_; i < fragments_.size(); ++i) {
    FragmentRecord& fragment = fragments_[i];
    if (fragment.reached_the_target())  // so far
      update(fragment, stage, block, tile, index_in_block(fragment.x - block.left, fragment.y - block.top));
  }
}

void FragmentWatch::update(FragmentRecord& fragment, Stage stage, const FragmentBlock& block, const Tile& tile, int index) const {
  fragment.stages.push_back(stage);
  if (stage == Stage::fragment_shading)
    fragment.colour = Rgba32F{block.colour[0][index], block.colour[1][index], block.colour[2][index], block.colour[3][index]};
  const PixelContents contents = pixel_contents(tile, output_.colour_format, fragment.x, fragment.y);
  for (SampleRecord& sample : fragment.samples) {
    if (sample.died_at) continue;
    sample.after = contents[static_cast<std::size_t>(sample.sample)];
    update(sample, stage, block, index, fragment.is_back);
  }
}

void FragmentWatch::update(SampleRecord& sample, Stage stage, const FragmentBlock& block, int index, bool is_back) const {
  const bool dies = !is_live(block, sample.sample, index);
  if (dies) sample.died_at = stage;
  if (stage != Stage::depth_test) return;
  if (output_.stencil.enabled && sample.before.stencil) {
    const StencilFace& face = is_back ? output_.stencil.back : output_.stencil.front;
    sample.stencil_failed = !passes(face.test, face.reference & face.read_mask, *sample.before.stencil & face.read_mask);
  }
  if (!sample.stencil_failed) sample.depth_code = block.depth[sample.sample][index];
}

bool passes(Compare test, std::int32_t value, std::int32_t stored) noexcept {
  switch (test) {
    case Compare::never: return false;
    case Compare::less: return value < stored;
    case Compare::equal: return value == stored;
    case Compare::less_equal: return value <= stored;
    case Compare::greater: return value > stored;
    case Compare::not_equal: return value != stored;
    case Compare::greater_equal: return value >= stored;
    case Compare::always: break;
  }
  return true;
}

const char* name_of(Stage stage) noexcept {
  switch (stage) {
    case Stage::vertex_transform: return "vertex transform";
    case Stage::primitive_assembly: return "primitive assembly";
    case Stage::clipping: return "clipping";
    case Stage::perspective_divide: return "perspective divide";
    case Stage::culling: return "culling";
    case Stage::vertex_attributes: return "vertex attributes";
    case Stage::set_up: return "setup";
    case Stage::binning: return "binning";
    case Stage::rasterization: return "rasterization";
    case Stage::fragment_shading: return "fragment shading";
    case Stage::alpha_test: return "alpha test";
    case Stage::depth_test: return "depth test";
    case Stage::blending: break;
  }
  return "blending";
}

}  // namespace tuberia
