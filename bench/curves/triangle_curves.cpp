// Time against the number of triangles, and against their size.

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "bench/curves/curves.hpp"
#include "bench/curves/memory.hpp"
#include "bench/curves/repeated_indices.hpp"
#include "bench/curves/timing.hpp"
#include "bench/peers/meshes.hpp"
#include "pipeline/pipeline.hpp"
#include "pipeline/programs/programs.hpp"

namespace tuberia::bench {
namespace {

constexpr double kMebibyte = 1 << 20;
constexpr std::int64_t kMemoryBudgetBytes = 256 << 20;  // beside the targets, however many triangles

/// A mesh in the terms of a draw.
struct DrawableMesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec4> colours;
  std::vector<std::uint32_t> indices;

  DrawCall draw(std::span<const std::uint32_t> some_indices) const {
    DrawCall call;
    call.mesh.positions = positions;
    call.mesh.colours = colours;
    call.mesh.indices = some_indices;
    call.program = gouraud();
    call.state.depth = {.test = Compare::less_equal};
    return call;
  }
};

PipelineOptions pipeline_options(const CurveOptions& options, int threads) {
  return {.threads = threads, .instruction_set = options.instruction_set, .precision = options.precision};
}

void draw_or_abort(Pipeline& pipeline, RenderTarget& target, const DrawCall& draw) {
  if (const auto drawn = pipeline.draw(target, draw); !drawn) {
    std::fprintf(stderr, "script/bench curves: %s\n", drawn.error().message.c_str());
    std::abort();
  }
}

// 65,536 triangles of 4 pixels that cover a target of 512 x 512: their indices fill whole pages.
constexpr int kGridColumns = 256, kGridRows = 128, kGridTargetPixels = 512;

DrawableMesh repeated_grid() {
  WorkloadMesh grid = jittered_grids(kGridColumns, kGridRows, 1, LayerOrder::back_to_front);
  DrawableMesh mesh{.positions = std::move(grid.positions), .colours = {}, .indices = std::move(grid.indices)};
  for (const Rgba8& c : grid.colours) mesh.colours.push_back(glm::vec4(c.r, c.g, c.b, c.a) / 255.0f);
  return mesh;
}

/// What one draw of so many triangles took.
struct CountedDraw {
  double seconds = 0;
  std::int64_t heap_bytes = 0, resident_bytes = 0;  // at most, beside the mesh and the target
};

CountedDraw draw_triangles(const DrawableMesh& mesh, std::span<const std::uint32_t> indices,
                           const CurveOptions& options, int threads) {
  RenderTarget target = *RenderTarget::create(kGridTargetPixels, kGridTargetPixels);
  const std::int64_t heap_before = heap_bytes(), resident_before = private_resident_bytes();
  restart_heap_peak();
  Pipeline pipeline(pipeline_options(options, threads));
  const DrawCall draw = mesh.draw(indices);
  CountedDraw counted;
  counted.seconds = seconds_of([&] { draw_or_abort(pipeline, target, draw); }, options.quick ? 0.1 : 1.0);
  counted.heap_bytes = heap_peak_bytes() - heap_before;
  counted.resident_bytes =
      std::max<std::int64_t>(0, private_resident_bytes() - resident_before);  // the pipeline keeps its memory
  return counted;
}

std::string mebibytes(std::int64_t bytes) { return number_text(static_cast<double>(bytes) / kMebibyte); }

std::string budget_sentence(double triangles, std::int64_t bytes) {
  const bool holds = bytes < kMemoryBudgetBytes;
  const std::string text = "A draw of " + count_text(triangles) + " triangles took at most " + mebibytes(bytes) +
                           " MiB beside the target, " + (holds ? "under" : "MORE THAN") + " " +
                           mebibytes(kMemoryBudgetBytes) + " MiB.";
  return holds ? "<p><b>" + text + "</b></p>\n" : "<p class=\"alarm\">" + text + "</p>\n";
}

/// An equilateral triangle of this area around a centre, turned anyhow; corners may lie outside.
void add_triangle(DrawableMesh& mesh, glm::dvec2 centre_pixels, double area_pixels, double target_pixels, float depth,
                  std::mt19937& random) {
  const double radius = std::sqrt(area_pixels * 4 / (3 * std::numbers::sqrt3));  // of the circumcircle
  std::uniform_real_distribution<float> unit(0, 1);
  const double turn = unit(random) * 2 * std::numbers::pi;
  for (int corner = 0; corner < 3; ++corner) {
    const double angle = turn + corner * 2 * std::numbers::pi / 3;
    const glm::dvec2 at = centre_pixels + radius * glm::dvec2(std::cos(angle), std::sin(angle));
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.push_back(
        {static_cast<float>(2 * at.x / target_pixels - 1), static_cast<float>(2 * at.y / target_pixels - 1), depth});
    mesh.colours.push_back({unit(random), unit(random), unit(random), 0.5f});
  }
}

/// One after the other along bands of 64 pixels, as the triangles of a model are neighbours; with an
/// order at random every chunk would meet every tile. Each keeps to the target as far as its size lets it.
DrawableMesh scattered_triangles(int count, double area_pixels, double target_pixels) {
  constexpr double kBandPixels = 64;
  const double bands = target_pixels / kBandPixels;
  DrawableMesh mesh;
  std::mt19937 random(20240501);
  std::uniform_real_distribution<double> unit(0, 1);
  const double margin = std::min(std::sqrt(area_pixels), target_pixels / 2);
  for (int i = 0; i < count; ++i) {
    const double along = bands * i / count, band = std::floor(along);
    const glm::dvec2 centre((along - band) * target_pixels, (band + unit(random)) * kBandPixels);
    add_triangle(mesh, glm::clamp(centre, margin, target_pixels - margin), area_pixels, target_pixels,
                 0.9f - 1.8f * static_cast<float>(i) / static_cast<float>(count), random);
  }
  return mesh;
}

}  // namespace

Curve triangle_count_curve(const CurveOptions& options) {
  Curve curve{.name = "triangles",
              .title = "Triangles in one draw",
              .explanation =
                  "One draw of so many triangles of 4 pixels into 512 &times; 512, depth tested, colours "
                  "interpolated. The index list is one piece of memory mapped many times in a row, so that only its "
                  "addresses grow.",
              .chart = {.x = {"triangles"}, .y = {"ms"}, .series = {}}};
  const DrawableMesh mesh = repeated_grid();
  Table table{.headings = {"triangles", "ms", "M triangles<br>a second", "peak heap<br>MiB", "resident<br>MiB more"},
              .rows = {}};
  Series many{.name = std::to_string(options.threads) + " threads", .points = {}},
      one{.name = "1 thread", .points = {}};
  for (double triangles = 1e3; triangles <= (options.quick ? 1e6 : 1e8); triangles *= 10) {
    const auto indices = RepeatedIndices::create(mesh.indices, static_cast<std::size_t>(3 * triangles));
    if (!indices) {
      curve.remark_html +=
          "<p class=\"alarm\">" + escaped(count_text(triangles) + " triangles: " + indices.error().message) + "</p>\n";
      break;
    }
    const CountedDraw drawn = draw_triangles(mesh, indices->indices(), options, options.threads);
    many.points.push_back({triangles, 1e3 * drawn.seconds});
    tell(curve.name, many.name, triangles, 1e3 * drawn.seconds, "ms");
    if (options.threads > 1 && triangles <= 1e7) {
      one.points.push_back({triangles, 1e3 * draw_triangles(mesh, indices->indices(), options, 1).seconds});
      tell(curve.name, one.name, triangles, one.points.back().y, "ms");
    }
    table.rows.push_back({count_text(triangles), number_text(1e3 * drawn.seconds),
                          number_text(1e-6 * triangles / drawn.seconds), mebibytes(drawn.heap_bytes),
                          mebibytes(drawn.resident_bytes)});
    const std::int64_t bytes = std::max(drawn.heap_bytes, drawn.resident_bytes);
    curve.remark_html = budget_sentence(triangles, bytes);
    curve.table_html = table.html();
  }
  curve.chart.series.push_back(std::move(many));
  if (options.threads > 1) curve.chart.series.push_back(std::move(one));
  return curve;
}

Curve triangle_size_curve(const CurveOptions& options) {
  constexpr int kTargetPixels = 2048;
  constexpr double kFragments = 3e7;
  Curve curve{.name = "triangle size",
              .title = "Size of triangles",
              .explanation =
                  "Triangles of one area all over 2048 &times; 2048, in random directions, neighbours after "
                  "neighbours, back to front. Blended ones are shaded wherever they are; of opaque ones those behind "
                  "need not be.",
              .chart = {.x = {"pixels a triangle"}, .y = {"ns a triangle"}, .series = {}}};
  std::vector<double> areas;
  for (double area = 0.5; area < 1e6; area *= options.quick ? 16 : 4) areas.push_back(area);
  areas.push_back(1e6);
  RenderTarget target = *RenderTarget::create(kTargetPixels, kTargetPixels);
  Pipeline pipeline(pipeline_options(options, options.threads));
  for (const bool blend : {false, true}) {
    Series series{.name = blend ? "blended" : "opaque, depth tested", .points = {}};
    for (const double area : areas) {
      const int count = static_cast<int>(std::clamp(kFragments / area, 30.0, options.quick ? 1e5 : 1e6));
      const DrawableMesh mesh = scattered_triangles(count, area, kTargetPixels);
      DrawCall draw = mesh.draw(mesh.indices);
      if (blend) draw.state.blend.mode = BlendMode::source_over;
      if (blend) draw.state.depth = kDepthOff;
      pipeline.clear(target, {0, 0, 0, 0});
      const double seconds = seconds_of(
          [&] {
            if (!blend) target.clear_depth(1, pipeline.workers());
            draw_or_abort(pipeline, target, draw);
          },
          options.quick ? 0.1 : 0.6);
      series.points.push_back({area, 1e9 * seconds / count});
      tell(curve.name, series.name, area, series.points.back().y, "ns a triangle");
    }
    curve.chart.series.push_back(std::move(series));
  }
  return curve;
}

}  // namespace tuberia::bench
