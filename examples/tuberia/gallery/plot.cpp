#include "examples/tuberia/gallery/plot.hpp"

#include <algorithm>
#include <cmath>

#include "pipeline/programs/programs.hpp"

namespace tuberia::cli {
namespace {

constexpr int kGap = 6;  // pixels between pictures
constexpr Rgba8 kGapColour{20, 22, 27, 255};
constexpr int kMostGridLines = 1000;

/// Draws curves in the plot's units, all with lines of one width.
struct Pen {
  RenderTarget& target;
  Pipeline& pipeline;
  glm::vec2 centre, half_extent;

  Result<Nothing> draw(const Curve& curve, float width_pixels) const {
    std::vector<glm::vec4> corners;
    for (const glm::vec2& p : curve.points) corners.emplace_back((p - centre) / half_extent, 0.0f, 1.0f);
    const std::vector<glm::vec4> colours(corners.size(), glm::vec4(curve.colour, 1));
    DrawCall call;
    call.mesh.clip_positions = corners;
    call.mesh.colours = colours;
    call.program = flat();
    call.state.assembly.topology = Topology::line_strip;
    call.state.rasterization.line.width_pixels = width_pixels;
    call.state.depth.test = Compare::always;
    if (const auto done = pipeline.draw(target, call); !done) return done.error();
    return Nothing{};
  }
};

/// The multiples of `step` in [low, high].
std::vector<float> multiples(float step, float low, float high) {
  std::vector<float> values;
  for (double n = std::ceil(double{low} / double{step}); n * double{step} <= double{high} * (1 + 1e-6); ++n) values.push_back(static_cast<float>(n) * step);
  return values;
}

Result<Nothing> draw_grid(const Plot& plot, const Pen& pen) {
  const auto shade = [](float at) { return at == 0 ? glm::vec3(0.25f) : glm::vec3(0.06f); };
  for (const float x : multiples(plot.grid.x, plot.lower_left.x, plot.upper_right.x))
    if (const auto done = pen.draw({{{x, plot.lower_left.y}, {x, plot.upper_right.y}}, shade(x)}, 1); !done) return done;
  for (const float y : multiples(plot.grid.y, plot.lower_left.y, plot.upper_right.y))
    if (const auto done = pen.draw({{{plot.lower_left.x, y}, {plot.upper_right.x, y}}, shade(y)}, 1); !done) return done;
  return Nothing{};
}

bool makes_sense(const Plot& plot) {
  const glm::vec2 extent = plot.upper_right - plot.lower_left, lines = extent / plot.grid;
  return extent.x > 0 && extent.y > 0 && lines.x > 0 && lines.y > 0 && lines.x + lines.y < static_cast<float>(kMostGridLines);
}

}  // namespace

Result<Image<Rgba8>> drawn(const Plot& plot, Pipeline& pipeline) {
  if (!makes_sense(plot)) return Error{"a plot has no extent, or too fine a grid"};
  auto target = RenderTarget::create({.width = plot.width_pixels, .height = plot.height_pixels, .colour = ColourFormat::srgb8, .samples = 8});
  if (!target) return target.error();
  pipeline.clear(*target, {0.012f, 0.013f, 0.017f, 1});
  const Pen pen{*target, pipeline, (plot.lower_left + plot.upper_right) * 0.5f, (plot.upper_right - plot.lower_left) * 0.5f};
  if (const auto done = draw_grid(plot, pen); !done) return done.error();
  for (const Curve& curve : plot.curves)
    if (const auto done = pen.draw(curve, 2); !done) return done.error();
  return target->colour_image();
}

Image<Rgba8> stacked(const std::vector<Image<Rgba8>>& pictures) {
  int width = 0, height = 0;
  for (const auto& picture : pictures) {
    width = std::max(width, picture.width());
    height += picture.height();
  }
  Image<Rgba8> all(width, height);
  std::ranges::fill(all.pixels(), kGapColour);
  int top = 0;
  for (const auto& picture : pictures) {
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) all.at(x, top + y) = picture.at(x, y);
    top += picture.height();
  }
  return all;
}

Image<Rgba8> side_by_side(const std::vector<Image<Rgba8>>& pictures) {
  int width = -kGap, height = 0;
  for (const auto& picture : pictures) {
    width += picture.width() + kGap;
    height = std::max(height, picture.height());
  }
  Image<Rgba8> all(width, height);
  std::ranges::fill(all.pixels(), kGapColour);
  int left = 0;
  for (const auto& picture : pictures) {
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) all.at(left + x, y) = picture.at(x, y);
    left += picture.width() + kGap;
  }
  return all;
}

}  // namespace tuberia::cli
