#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <optional>

#include "tests/fuzz/raster_input.hpp"
#include "tests/fuzz/targets.hpp"
#include "tests/witness/comparison.hpp"

namespace tuberia::fuzz {
namespace {

/// For 18 vertices and 40 rows of 72 pixels, sanitizers and a busy machine included; usually it takes a
/// thousandth of it.
constexpr std::chrono::seconds kLongestDraw{5};

/// All that a target stores.
struct Contents {
  std::vector<Image<Rgba32F>> colours;
  std::vector<Image<std::int32_t>> depths;
  std::vector<Image<std::uint8_t>> stencils;

  explicit Contents(const RenderTarget& target) {
    for (int s = 0; s < target.samples(); ++s) {
      colours.push_back(target.sample_linear_image(s));
      depths.push_back(target.sample_depth_codes(s));
      stencils.push_back(target.sample_stencil_codes(s));
    }
  }
};

/// Not-a-numbers are alike whatever their bits.
bool same(float a, float b) { return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) || (std::isnan(a) && std::isnan(b)); }

/// Where two contents differ, of the pixels in question; nothing if nowhere.
template <class InQuestion>
std::string difference(const Contents& a, const Contents& b, const InQuestion& in_question) {
  for (std::size_t s = 0; s < a.colours.size(); ++s)
    for (int y = 0; y < a.colours[s].height(); ++y)
      for (int x = 0; x < a.colours[s].width(); ++x) {
        if (!in_question(x, y)) continue;
        const Rgba32F &p = a.colours[s].at(x, y), &q = b.colours[s].at(x, y);
        const char* what = !(same(p.r, q.r) && same(p.g, q.g) && same(p.b, q.b) && same(p.a, q.a)) ? "colour"
                           : a.depths[s].at(x, y) != b.depths[s].at(x, y)                           ? "depth"
                           : a.stencils[s].at(x, y) != b.stencils[s].at(x, y)                       ? "stencil code"
                                                                                                    : nullptr;
        if (what != nullptr) return std::string(what) + " of pixel (" + std::to_string(x) + ", " + std::to_string(y) + "), sample " + std::to_string(s);
      }
  return {};
}

struct Outcome {
  std::string refusal;                     // empty: drawn
  std::chrono::steady_clock::duration time{};
};

Outcome drawn(const RasterInput& in, Pipeline& pipeline, RenderTarget& target) {
  const Result<Nothing> cleared = pipeline.clear(target, in.clear);
  if (!cleared) return {cleared.error().message};
  const auto begin = std::chrono::steady_clock::now();
  const Result<DrawStatistics> statistics = pipeline.draw(target, in.call());
  return {statistics ? "" : statistics.error().message, std::chrono::steady_clock::now() - begin};
}

Pipeline& wide_pipeline() {
  static Pipeline pipeline({.threads = 1});
  return pipeline;
}
Pipeline& narrow_pipeline() {
  static Pipeline pipeline({.threads = 2, .instruction_set = InstructionSet::baseline});
  return pipeline;
}
Pipeline& fast_pipeline() {
  static Pipeline pipeline({.threads = 1, .precision = Precision::fast});
  return pipeline;
}

/// The draw as it is: what it must not touch, and what must not depend on the machine.
std::string try_draw(const RasterInput& in) {
  RenderTarget target = *RenderTarget::create(in.target), other = *RenderTarget::create(in.target);
  if (const Result<Nothing> cleared = wide_pipeline().clear(target, in.clear); !cleared) return "the clear was refused: " + cleared.error().message;
  const Contents before(target);
  const Outcome wide = drawn(in, wide_pipeline(), target), narrow = drawn(in, narrow_pipeline(), other);
  if (wide.refusal != narrow.refusal) return "refused differently: '" + wide.refusal + "', '" + narrow.refusal + "'";
  if (wide.time > kLongestDraw) return "the draw took seconds";

  const Contents after(target);
  if (std::string where = difference(after, Contents(other), [](int, int) { return true; }); !where.empty())
    return "another instruction set and number of threads: " + where;
  PixelRect open = wide.refusal.empty() ? target.bounds() : PixelRect{0, 0, 0, 0};
  if (in.state.viewport.viewport) {
    const Viewport& v = *in.state.viewport.viewport;
    open = intersection(open, {v.x, v.y, v.x + v.width_pixels, v.y + v.height_pixels});
  }
  if (in.state.rasterization.scissor) open = intersection(open, *in.state.rasterization.scissor);
  const auto is_outside = [&](int x, int y) { return x < open.left || x >= open.right || y < open.top || y >= open.bottom; };
  if (std::string where = difference(before, after, is_outside); !where.empty()) return "written outside: " + where;

  drawn(in, fast_pipeline(), other);
  if (std::string where = difference(before, Contents(other), is_outside); !where.empty()) return "written outside in fast precision: " + where;
  return {};
}

/// The triangles alone, in the default state, against rational numbers.
std::string try_coverage(const RasterInput& in) {
  static witness::Machines machines;
  witness::Case c;
  c.width = in.target.width;
  c.height = in.target.height;
  c.format = in.target.depth;
  c.view.viewport = {0, 0, c.width, c.height};
  if (in.state.viewport.viewport && in.state.viewport.viewport->width_pixels > 0 && in.state.viewport.viewport->height_pixels > 0) {
    const Viewport& v = *in.state.viewport.viewport;
    c.view.viewport = {v.x, v.y, v.width_pixels, v.height_pixels};
  }
  c.view.lowest_z = in.state.clipping.volume == ClipVolume::minus_w_to_w ? -1 : 0;
  c.view.near_depth = in.state.viewport.depth_range.near_depth;
  c.view.far_depth = in.state.viewport.depth_range.far_depth;
  c.is_counting = in.target.stencil;
  c.instruction_set = best_instruction_set();
  for (std::size_t i = 0; i + 2 < in.clip_positions.size(); i += 3) {
    for (std::size_t k = i; k < i + 3; ++k) {
      const glm::vec4& p = in.clip_positions[k];
      c.vertices.push_back({p.x, p.y, p.z, p.w});
    }
  }
  if (c.vertices.empty()) return {};
  const witness::Finding finding = witness::compare(c, machines);
  return finding.verdict == witness::Verdict::failed ? "against rational numbers: " + witness::explained(c, machines) : "";
}

}  // namespace

std::string try_raster(Input input) {
  Bytes bytes(input);
  const RasterInput in = raster_input(bytes);
  if (std::string wrong = try_draw(in); !wrong.empty()) return wrong;
  return try_coverage(in);
}

}  // namespace tuberia::fuzz
