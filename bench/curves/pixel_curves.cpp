// Time against layers, the target's size, interpolated attributes, and threads: whole frames.

#include <cstdlib>

#include "bench/curves/attribute_programs.hpp"
#include "bench/curves/curves.hpp"
#include "bench/curves/memory.hpp"
#include "bench/curves/timing.hpp"
#include "bench/peers/tuberia_peer.hpp"

namespace tuberia::bench {
namespace {

double frame_milliseconds(const Workload& workload, const CurveOptions& options, int threads) {
  TuberiaPeer peer(threads, options.instruction_set, options.precision);
  if (const auto prepared = peer.prepare(workload); !prepared) {
    std::fprintf(stderr, "script/bench curves: %s\n", prepared.error().message.c_str());
    std::abort();
  }
  return 1e3 * seconds_of([&] { peer.frame(); }, options.quick ? 0.1 : 0.5);
}

}  // namespace

Curve layer_curve(const CurveOptions& options) {
  Curve curve{
      .name = "layers",
      .title = "Layers of overdraw",
      .explanation = "So many quads over the whole of 1920 &times; 1080, colours interpolated; clearing included.",
      .chart = {.x = {"layers"}, .y = {"ms a frame"}, .series = {}}};
  const struct {
    const char* name;
    LayerOrder order;
    bool blend;
  } kinds[] = {{"back to front", LayerOrder::back_to_front, false},
               {"front to back", LayerOrder::front_to_back, false},
               {"blended", LayerOrder::back_to_front, true}};
  for (const auto& [name, order, blend] : kinds) {
    Series series{.name = name, .points = {}};
    for (int layers = 1; layers <= 64; layers *= options.quick ? 4 : 2) {
      const Workload workload{.mesh = filling_quads(layers, true, blend ? 64 : 255, order), .blend = blend};
      series.points.push_back({static_cast<double>(layers), frame_milliseconds(workload, options, options.threads)});
      tell(curve.name, name, layers, series.points.back().y, "ms");
    }
    curve.chart.series.push_back(std::move(series));
  }
  return curve;
}

Curve target_size_curve(const CurveOptions& options) {
  constexpr double kBytesPerPixel = 8, kRoomBeside = 1 << 30;
  Curve curve{.name = "target size",
              .title = "Size of the target",
              .explanation =
                  "A quad over the whole target, depth tested, colours interpolated; clearing included. Square "
                  "targets from 64 to 16384 pixels a side; the larger ones exceed the caches, which is the step in "
                  "the curve.",
              .chart = {.x = {"pixels"}, .y = {"ms a frame"}, .series = {}}};
  Series clearing{.name = "clear", .points = {}}, filling{.name = "clear and fill", .points = {}};
  for (int side = 64; side <= (options.quick ? 4096 : 16384); side *= options.quick ? 4 : 2) {
    const double pixels = static_cast<double>(side) * side;
    if (const auto room = static_cast<double>(available_bytes());
        room > 0 && room < pixels * kBytesPerPixel + kRoomBeside) {
      curve.remark_html =
          "<p>Not measured for want of memory: " + count_text(side) + " &times; " + count_text(side) + ".</p>\n";
      break;
    }
    Workload workload{.width_pixels = side, .height_pixels = side};
    clearing.points.push_back({pixels, frame_milliseconds(workload, options, options.threads)});
    workload.mesh = filling_quads(1, true, 255, LayerOrder::back_to_front);
    filling.points.push_back({pixels, frame_milliseconds(workload, options, options.threads)});
    tell(curve.name, filling.name, pixels, filling.points.back().y, "ms");
  }
  curve.chart.series = {std::move(filling), std::move(clearing)};
  return curve;
}

Curve attribute_curve(const CurveOptions& options) {
  constexpr int kLayers = 8;
  Curve curve{.name = "attributes",
              .title = "Interpolated attributes",
              .explanation =
                  "Eight layers over 1920 &times; 1080, blended so that every fragment is shaded; the program adds "
                  "all scalars that it gets, interpolated in perspective.",
              .chart = {.x = {"scalars interpolated", false}, .y = {"ns a fragment", false}, .series = {}}};
  const Workload workload{.mesh = filling_quads(kLayers, true, 64, LayerOrder::back_to_front), .blend = true};
  const double fragments = static_cast<double>(workload.width_pixels) * workload.height_pixels * kLayers;
  TuberiaPeer peer(options.threads, options.instruction_set, options.precision);
  if (const auto prepared = peer.prepare(workload); !prepared) std::abort();
  const std::vector<glm::vec4> custom(workload.mesh.positions.size(), glm::vec4(0.25f));
  Series series{.name = std::to_string(options.threads) + " threads", .points = {}};
  for (const AttributeProgram& program : attribute_programs()) {
    DrawCall draw = peer.draws()[0];
    draw.mesh.custom = custom;
    draw.program = program.program;
    peer.clear();
    const double seconds = seconds_of(
        [&] {
          if (const auto drawn = peer.pipeline().draw(peer.target(), draw); !drawn) std::abort();
        },
        options.quick ? 0.1 : 0.5);
    series.points.push_back({static_cast<double>(program.scalars), 1e9 * seconds / fragments});
    tell(curve.name, series.name, program.scalars, series.points.back().y, "ns a fragment");
  }
  curve.chart.series.push_back(std::move(series));
  return curve;
}

Curve thread_curve(const CurveOptions& options) {
  Curve curve{.name = "threads",
              .title = "Threads",
              .explanation =
                  "Whole frames of the workloads that peers are compared on. <code>script/bench account</code> has "
                  "all of them, and what more threads than this machine's would do. An exponent of -1 were perfect.",
              .chart = {.x = {"threads"}, .y = {"ms a frame"}, .series = {}}};
  for (const char* name : {"fill_blend", "fill_tex_trilinear", "small_tris", "vertex_bound_lit", "scene_textured"}) {
    const auto workload = make_workload(name);
    if (!workload) continue;
    Series series{.name = name, .points = {}};
    for (int threads = 1; threads <= options.threads; ++threads) {
      series.points.push_back({static_cast<double>(threads), frame_milliseconds(*workload, options, threads)});
      tell(curve.name, name, threads, series.points.back().y, "ms");
    }
    curve.chart.series.push_back(std::move(series));
  }
  return curve;
}

}  // namespace tuberia::bench
