#include "tests/witness/comparison.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <sstream>

#include "pipeline/programs/programs.hpp"
#include "reference/oracle/coverage.hpp"

namespace tuberia::witness {
namespace {

/// Of all pixels of a small target.
struct Picture {
  int width, height;
  std::vector<int> counts;           // how many triangles cover it
  std::vector<std::int32_t> codes;   // depths
  std::int64_t cut = 0, fan = 0;     // triangles that crossed a plane; those that all became
  bool is_doubtful = false;          // the contract's roundings may lead to another picture

  Picture(const Case& c, std::int32_t farthest)
      : width(c.width), height(c.height), counts(static_cast<std::size_t>(width * height), 0), codes(counts.size(), farthest) {}
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * width + x); }
};

std::int32_t code_of(float depth, DepthFormat format) {
  switch (format) {
    case DepthFormat::d16: return static_cast<std::int32_t>(std::floor(65535 * static_cast<double>(depth) + 0.5));
    case DepthFormat::d24: return static_cast<std::int32_t>(std::floor(16777215 * static_cast<double>(depth) + 0.5));
    case DepthFormat::d32f: return std::bit_cast<std::int32_t>(depth == 0 ? 0.0f : depth);
  }
  return 0;
}

/// The depths that the contract interpolates, between exact corners.
class ContractDepths {
 public:
  explicit ContractDepths(const rational::ScreenTriangle& t) : primitive_(of(t)), shape_(primitive_, nothing(), 1) {}
  float at(int x, int y) const { return shape_.depth(x, y, 0); }

 private:
  static oracle::ScreenPrimitive of(const rational::ScreenTriangle& t) {
    oracle::ScreenPrimitive primitive;
    for (std::size_t k = 0; k < 3; ++k) {
      oracle::ScreenVertex& v = primitive.vertex[k];
      v.x = t.corner(k).x;
      v.y = t.corner(k).y;
      v.depth = t.corner(k).depth;
      v.w = t.corner(k).w;
    }
    return primitive;
  }
  static const oracle::Draw& nothing() {
    static const oracle::Draw draw;
    return draw;
  }
  oracle::ScreenPrimitive primitive_;
  oracle::Shape shape_;
};

/// One triangle, pixel by pixel between its bounds.
void draw(const rational::ScreenTriangle& t, const Case& c, Picture& picture, Finding& finding) {
  const auto [left, right] = std::minmax({t.corner(0).x, t.corner(1).x, t.corner(2).x});
  const auto [top, bottom] = std::minmax({t.corner(0).y, t.corner(1).y, t.corner(2).y});
  const rational::Viewport& v = c.view.viewport;
  const auto first = [](std::int64_t units, int corner) { return static_cast<int>(std::max<std::int64_t>({units >> 8, corner, 0})); };
  const auto end = [](std::int64_t units, int corner, int size) { return static_cast<int>(std::min<std::int64_t>({(units >> 8) + 1, corner, size})); };
  const int x0 = first(left, v.x), x1 = end(right, v.x + v.width, c.width), y0 = first(top, v.y), y1 = end(bottom, v.y + v.height, c.height);
  if (x0 >= x1 || y0 >= y1) return;
  const auto [least, most] = std::minmax(c.view.near_depth, c.view.far_depth);
  const ContractDepths depths(t);
  const double allowed = t.depth_error();
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x) {
      if (!t.covers(x, y)) continue;
      const float depth = depths.at(x, y);
      finding.depth_error = std::max(finding.depth_error, std::abs(static_cast<double>(depth) - t.depth_at(x, y)) / allowed);
      ++finding.pixels;
      std::int32_t& stored = picture.codes[picture.at(x, y)];
      const std::int32_t code = code_of(std::clamp(depth, least, most), c.format);
      if (!c.is_counting && code >= stored) continue;
      stored = code;
      ++picture.counts[picture.at(x, y)];
    }
}

Picture exact_picture(const Case& c, Finding& finding) {
  Picture picture(c, code_of(1, c.format));
  for (std::size_t i = 0; i < c.triangle_count(); ++i) {
    const rational::Result result = rational::triangles_of(c.triangle(i), c.view);
    picture.cut += result.is_cut ? 1 : 0;
    picture.fan += result.fan_triangles;
    picture.is_doubtful = picture.is_doubtful || result.is_doubtful;
    for (const rational::ScreenTriangle& t : result.triangles) draw(t, c, picture, finding);
  }
  return picture;
}

/// The same from the scalar oracle's geometry, which rounds as the contract does.
Picture contract_picture(const Case& c) {
  oracle::Draw draw_call;
  for (const rational::ClipVertex& v : c.vertices) {
    draw_call.vertices.emplace_back();
    draw_call.vertices.back().position = {v.x, v.y, v.z, v.w};
  }
  draw_call.volume = c.view.lowest_z == -1 ? oracle::ClipVolume::minus_w_to_w : oracle::ClipVolume::zero_to_w;
  draw_call.near_depth = c.view.near_depth;
  draw_call.far_depth = c.view.far_depth;
  const rational::Viewport& v = c.view.viewport;
  const oracle::GeometryResult geometry = oracle::geometry(draw_call, {v.x, v.y, v.width, v.height}, static_cast<oracle::DepthFormat>(c.format));
  Picture picture(c, code_of(1, c.format));
  picture.cut = geometry.clipped;
  picture.fan = geometry.after_clipping;
  Finding ignored;
  for (const oracle::ScreenPrimitive& primitive : geometry.primitives) {
    const auto corner = [&](std::size_t k) {
      const oracle::ScreenVertex& p = primitive.vertex[k];
      return rational::ScreenCorner{p.x, p.y, p.depth, p.w};
    };
    draw(rational::ScreenTriangle(corner(0), corner(1), corner(2)), c, picture, ignored);
  }
  return picture;
}

DrawCall call_of(const Case& c, std::span<const glm::vec4> positions, std::span<const glm::vec4> colours) {
  const rational::Viewport& v = c.view.viewport;
  DrawCall call{.mesh = {.clip_positions = positions, .colours = colours}, .program = flat(), .state = {}};
  call.state.clipping.volume = c.view.lowest_z == -1 ? ClipVolume::minus_w_to_w : ClipVolume::zero_to_w;
  call.state.viewport = {.viewport = Viewport{v.x, v.y, v.width, v.height}, .depth_range = {c.view.near_depth, c.view.far_depth}};
  if (c.is_counting) {
    call.state.depth.test = Compare::always;
    call.state.blend.mode = BlendMode::additive;
  }
  return call;
}

/// What the pipeline draws: each triangle adds one code of colour.
Picture drawn_picture(const Case& c, Machines& machines) {
  std::vector<glm::vec4> positions;
  for (const rational::ClipVertex& v : c.vertices) positions.emplace_back(v.x, v.y, v.z, v.w);
  const std::vector<glm::vec4> colours(positions.size(), glm::vec4(1.0f / 255));
  Pipeline& pipeline = machines.pipeline(c.instruction_set);
  RenderTarget& target = machines.target(c.width, c.height, c.format);
  pipeline.clear(target, {0, 0, 0, 0}, 1);
  const Result<DrawStatistics> statistics = pipeline.draw(target, call_of(c, positions, colours));
  TUBERIA_ASSERT(statistics.ok(), "a case was refused");
  Picture picture(c, 0);
  picture.cut = statistics->triangles_clipped;
  picture.fan = statistics->triangles_after_clipping;
  const Image<Rgba8> colour = target.colour_image();
  const Image<std::int32_t> codes = target.depth_codes();
  for (std::size_t i = 0; i < picture.counts.size(); ++i) {
    picture.counts[i] = colour.pixels()[i].r;
    picture.codes[i] = codes.pixels()[i];
  }
  return picture;
}

/// The first difference, or nothing.
std::string difference(const Case& c, const Picture& drawn, const Picture& wanted) {
  std::ostringstream out;
  if (drawn.cut != wanted.cut) out << "triangles cut: drawn " << drawn.cut << ", exact " << wanted.cut;
  else if (drawn.fan != wanted.fan) out << "triangles after clipping: drawn " << drawn.fan << ", exact " << wanted.fan;
  if (!out.str().empty()) return out.str();
  for (int y = 0; y < c.height; ++y)
    for (int x = 0; x < c.width; ++x) {
      const std::size_t i = wanted.at(x, y);
      const int count = c.is_counting ? wanted.counts[i] : std::min(1, wanted.counts[i]);
      if (drawn.counts[i] != count) out << "pixel (" << x << ", " << y << ") covered: drawn " << drawn.counts[i] << ", exact " << count;
      else if (drawn.codes[i] != wanted.codes[i]) out << "pixel (" << x << ", " << y << ") depth code: drawn " << drawn.codes[i] << ", exact " << wanted.codes[i];
      if (!out.str().empty()) return out.str();
    }
  return {};
}

}  // namespace

Pipeline& Machines::pipeline(InstructionSet set) {
  auto& slot = pipelines_[static_cast<std::size_t>(set)];
  if (!slot) slot = std::make_unique<Pipeline>(PipelineOptions{.threads = 1, .instruction_set = set});
  return *slot;
}

RenderTarget& Machines::target(int width, int height, DepthFormat format) {
  const auto found = std::find_if(targets_.begin(), targets_.end(), [&](const auto& target) {
    return target->width() == width && target->height() == height && target->depth_format() == format;
  });
  if (found != targets_.end()) return **found;
  return *targets_.emplace_back(std::make_unique<RenderTarget>(*RenderTarget::create(width, height, ColourFormat::rgba8, format)));
}

Finding compare(const Case& c, Machines& machines) {
  Finding finding;
  const Picture exact = exact_picture(c, finding), drawn = drawn_picture(c, machines);
  finding.what = difference(c, drawn, exact);
  if (!finding.what.empty()) {
    const bool is_explained = exact.is_doubtful && difference(c, drawn, contract_picture(c)).empty();
    finding.verdict = is_explained ? Verdict::undecided : Verdict::failed;
  } else if (finding.depth_error > 1) {
    finding.verdict = Verdict::failed;
    finding.what = "a depth is " + std::to_string(finding.depth_error) + " times as far from the plane as it may be";
  }
  return finding;
}

}  // namespace tuberia::witness
