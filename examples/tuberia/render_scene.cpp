#include "examples/tuberia/render_scene.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>

#include "examples/tuberia/commands.hpp"
#include "examples/tuberia/pipeline_options.hpp"
#include "examples/tuberia/render_model.hpp"
#include "image/file.hpp"
#include "image/write_image.hpp"
#include "scene/description/read_scene.hpp"
#include "scene/content/develop.hpp"

namespace tuberia::cli {
namespace {

constexpr std::array<std::string_view, 9> kSceneOptions{"model", "--output", "--size", "--supersample", "--time", "--stats", "--precision", "--threads", "--isa"};

void print_passes(const SceneFrame& frame) {
  for (std::size_t i = 0; i < frame.passes().size(); ++i) std::printf("pass %zu  %s\n", i + 1, frame.passes()[i].c_str());
  const DrawStatistics& s = frame.statistics();
  std::printf("vertices transformed  %s\ntriangles assembled   %s\ntriangles drawn       %s\n", with_commas(s.vertices).c_str(),
              with_commas(s.triangles_in).c_str(), with_commas(s.triangles_drawn).c_str());
}

}  // namespace

Result<Nothing> write_scene_picture(const std::string& output, const Image<Rgba32F>& light, const description::Picture& picture) {
  if (output.ends_with(".pfm") || output.ends_with(".hdr")) return write_image(output, light);
  return write_image(output, srgb_codes_of(developed(light, picture)));
}

bool is_scene_file(const std::string& path) { return lower_case_extension(path) == ".json"; }

Result<Nothing> check_scene_options(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_single_name(), full = (option->get_positional() ? "" : "--") + name;
    if (option->count() > 0 && std::find(kSceneOptions.begin(), kSceneOptions.end(), full) == kSceneOptions.end())
      return Error{full + " goes with model files; a scene file says such things itself"};
  }
  return Nothing{};
}

int render_scene(const SceneArguments& arguments, const PipelineOptions& options) {
  if (const auto good = check_picture_path(arguments.output); !good) return fail(good.error().message);
  auto scene = read_scene(arguments.scene);
  if (!scene) return fail(scene.error().message);
  if (arguments.supersampling) scene->picture.supersampling = *arguments.supersampling;
  const auto begin = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(); };
  const auto report = [&](std::string_view pass) { std::fprintf(stderr, "%6.2f s  %.*s\n", seconds(), static_cast<int>(pass.size()), pass.data()); };
  auto frame = SceneFrame::create(*std::move(scene), {.size_pixels = arguments.size_pixels, .time = arguments.time, .progress = report});
  if (!frame) return fail(arguments.scene + ": " + frame.error().message);
  for (const std::string& warning : frame->warnings()) std::fprintf(stderr, "tuberia: warning: %s\n", warning.c_str());
  Pipeline pipeline(options);
  const auto light = frame->draw(pipeline);
  if (!light) return fail(arguments.scene + ": " + light.error().message);
  if (const auto written = write_scene_picture(arguments.output, *light, frame->scene().picture); !written) return fail(written.error().message);
  std::printf("%s: %s triangles, %zu passes, %.2f s, %s\n", arguments.output.c_str(), with_commas(frame->triangle_count()).c_str(), frame->passes().size(), seconds(),
              description_of(options, pipeline.workers().thread_count()).c_str());
  if (arguments.statistics) print_passes(*frame);
  return kFine;
}

}  // namespace tuberia::cli
