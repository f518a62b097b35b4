// tuberia render MODEL -o FILE

#include <charconv>
#include <cstdio>
#include <memory>
#include <tuple>

#include "examples/tuberia/commands.hpp"
#include "examples/tuberia/pipeline_options.hpp"
#include "examples/tuberia/render_model.hpp"
#include "image/write_image.hpp"
#include "scene/load_model.hpp"

namespace tuberia::cli {
namespace {

struct RenderArguments {
  std::string model, output, depth_output, size = "1280x720", shading = "auto", filter = "trilinear", format = "srgb8", depth_format = "d24";
  std::vector<float> background{0.035f, 0.04f, 0.055f};
  bool statistics = false;
  RenderOptions options;
  PipelineArguments pipeline;
};

/// "1920x1080" to two numbers.
Result<std::pair<int, int>> parse_size(const std::string& text) {
  int width = 0, height = 0;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, width);
  if (first.ec == std::errc{} && first.ptr != end && *first.ptr == 'x') {
    const auto second = std::from_chars(first.ptr + 1, end, height);
    if (second.ec == std::errc{} && second.ptr == end) return std::pair{width, height};
  }
  return Error{"--size: '" + text + "' is not a size like 1920x1080"};
}

Sampler sampler_named(const std::string& filter) {
  Sampler sampler;
  if (filter == "nearest" || filter == "mipmap-nearest") sampler.texels = TexelFilter::nearest;
  if (filter == "nearest" || filter == "bilinear") sampler.mipmaps = MipmapFilter::none;
  if (filter == "mipmap-nearest") sampler.mipmaps = MipmapFilter::nearest;
  return sampler;
}

void print_statistics(const Rendering& rendering) {
  const DrawStatistics& s = rendering.statistics;
  std::printf("vertices transformed  %s\ntriangles assembled   %s\ntriangles clipped     %s\ntriangles drawn       %s\n",
              with_commas(s.vertices).c_str(), with_commas(s.triangles_in).c_str(),
              with_commas(s.triangles_clipped).c_str(), with_commas(s.triangles_drawn).c_str());
}

Result<Nothing> write_results(const RenderArguments& arguments, const Rendering& rendering) {
  const bool is_float = arguments.output.ends_with(".pfm") || arguments.output.ends_with(".hdr");
  auto written = is_float ? write_image(arguments.output, rendering.target.linear_image())
                          : write_image(arguments.output, rendering.target.colour_image());
  if (!written || arguments.depth_output.empty()) return written;
  return write_image(arguments.depth_output, rendering.target.depth_image());
}

int run_render(RenderArguments& arguments) {
  const auto size = parse_size(arguments.size);
  if (!size) return fail(size.error().message);
  std::tie(arguments.options.width_pixels, arguments.options.height_pixels) = *size;
  RenderOptions& options = arguments.options;
  options.shading = *shading_named(arguments.shading);
  options.sampler = sampler_named(arguments.filter);
  options.background = {arguments.background[0], arguments.background[1], arguments.background[2], 1};
  options.colour_format = arguments.format == "rgba8" ? ColourFormat::rgba8 : arguments.format == "rgba32f" ? ColourFormat::rgba32f : ColourFormat::srgb8;
  options.depth_format = arguments.depth_format == "d16" ? DepthFormat::d16 : arguments.depth_format == "d32f" ? DepthFormat::d32f : DepthFormat::d24;
  const auto pipeline_options = options_of(arguments.pipeline);
  if (!pipeline_options) return fail(pipeline_options.error().message);

  const auto model = load_model(arguments.model);
  if (!model) return fail(model.error().message);
  for (const std::string& warning : model->warnings) std::fprintf(stderr, "tuberia: warning: %s\n", warning.c_str());
  Pipeline pipeline(*pipeline_options);
  const auto rendering = render(*model, options, pipeline);
  if (!rendering) return fail(arguments.model + ": " + rendering.error().message);
  if (const auto written = write_results(arguments, *rendering); !written) return fail(written.error().message);

  std::printf("%s: %s, %s\n", arguments.output.c_str(), performance_line(*model, *rendering).c_str(),
              description_of(*pipeline_options, pipeline.workers().thread_count()).c_str());
  if (arguments.statistics) print_statistics(*rendering);
  return kFine;
}

void add_camera_options(CLI::App& command, CameraOptions& camera) {
  command.add_option("--azimuth", camera.azimuth_degrees, "Degrees around the model, 0 is in front")->group("Camera");
  command.add_option("--elevation", camera.elevation_degrees, "Degrees above the horizon")->check(CLI::Range(-90.0, 90.0))->group("Camera");
  command.add_option("--fovy", camera.fovy_degrees, "Vertical opening in degrees")->check(CLI::Range(0.1, 179.0))->group("Camera");
  command.add_option("--zoom", camera.zoom, "Magnification by a narrower field")->check(CLI::Range(1e-3, 1e4))->group("Camera");
  command.add_option("--eye", camera.eye, "Eye position, X Y Z")->expected(3)->group("Camera");
  command.add_option("--look-at", camera.look_at, "Point of interest, X Y Z")->expected(3)->group("Camera");
  command.add_option("--up", camera.up, "The vertical, X Y Z; with --eye")->expected(3)->group("Camera");
  command.add_option("--up-axis", camera.up_axis, "Which way is up in the model's file")
      ->check(CLI::IsMember({"x", "y", "z", "-x", "-y", "-z"}))->group("Camera");
  command.add_flag("--orthographic", camera.orthographic, "Parallel projection")->group("Camera");
}

}  // namespace

Run add_render(CLI::App& parent, CLI::App*& command) {
  const auto arguments = std::make_shared<RenderArguments>();
  command = parent.add_subcommand("render", "Draw a model file to a picture");
  command->add_option("model", arguments->model, "OBJ, glTF, PLY, 3DS, Collada, OFF, STL, ...")->required();
  command->add_option("-o,--output", arguments->output, "Picture to write: .png, .ppm, .tga, .bmp, .jpg, .pfm, .hdr")->required();
  command->add_option("--size", arguments->size, "WIDTHxHEIGHT in pixels");
  std::vector<std::string> names;
  for (const std::string_view name : shading_names()) names.emplace_back(name);
  command->add_option("--program", arguments->shading, "How surfaces are shaded")->check(CLI::IsMember(names));
  command->add_option("--filter", arguments->filter, "Texture filter")
      ->check(CLI::IsMember({"nearest", "bilinear", "mipmap-nearest", "trilinear"}));
  command->add_option("--depth", arguments->depth_output, "Also write the depths: .pfm, or .png in 8 bits");
  command->add_option("--format", arguments->format, "Colours of the target")->check(CLI::IsMember({"srgb8", "rgba8", "rgba32f"}));
  command->add_option("--depth-format", arguments->depth_format, "Depths of the target")->check(CLI::IsMember({"d16", "d24", "d32f"}));
  command->add_flag("--reversed-depth", arguments->options.reversed_depth, "Near depths are 1: even precision with d32f");
  command->add_flag("--cull", arguments->options.cull_back, "Leave out triangles seen from behind");
  command->add_option("--background", arguments->background, "Linear R G B")->expected(3);
  command->add_option("--frames", arguments->options.frames, "Frames to time; the median counts")->check(CLI::Range(1, 10000));
  command->add_flag("--stats", arguments->statistics, "Print what became of vertices and triangles");
  add_camera_options(*command, arguments->options.camera);
  add_pipeline_options(*command, arguments->pipeline);
  return [arguments] { return run_render(*arguments); };
}

}  // namespace tuberia::cli
