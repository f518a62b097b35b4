// tuberia render MODEL -o FILE, and SCENE.json in place of the model

#include <cstdio>
#include <memory>

#include "examples/tuberia/budget_options.hpp"
#include "examples/tuberia/commands.hpp"
#include "examples/tuberia/picture_options.hpp"
#include "examples/tuberia/pipeline_options.hpp"
#include "examples/tuberia/render_model.hpp"
#include "examples/tuberia/render_scene.hpp"
#include "examples/tuberia/views.hpp"
#include "image/box_filter.hpp"
#include "image/write_image.hpp"
#include "math/colour.hpp"
#include "scene/load_model.hpp"

namespace tuberia::cli {
namespace {

struct RenderArguments {
  std::string model, output, depth_output, view = "colour";
  bool statistics = false;
  int supersample = 1;  // pixels drawn each way for every one of the picture
  double time = 0;      // of a scene
  PictureArguments picture;
  PipelineArguments pipeline;
  BudgetArguments budget;
};

void print_statistics(const Rendering& rendering) {
  const DrawStatistics& s = rendering.statistics;
  std::printf("vertices transformed  %s\ntriangles assembled   %s\ntriangles clipped     %s\ntriangles drawn       %s\n",
              with_commas(s.vertices).c_str(), with_commas(s.triangles_in).c_str(),
              with_commas(s.triangles_clipped).c_str(), with_commas(s.triangles_drawn).c_str());
}

/// Of linear intensities, as the target would have stored them.
Image<Rgba8> codes_of(const Image<Rgba32F>& image, ColourFormat format) {
  Image<Rgba8> codes(image.width(), image.height());
  for (std::size_t i = 0; i < codes.pixels().size(); ++i) {
    const Rgba32F& p = image.pixels()[i];
    const auto code = [&](float c) { return format == ColourFormat::srgb8 ? srgb_code_from_linear(static_cast<double>(c)) : unorm8_from_linear(c); };
    codes.pixels()[i] = {code(p.r), code(p.g), code(p.b), unorm8_from_linear(p.a)};
  }
  return codes;
}

Result<Nothing> write_results(const RenderArguments& arguments, const Rendering& rendering) {
  const bool is_float = arguments.output.ends_with(".pfm") || arguments.output.ends_with(".hdr");
  if (arguments.supersample > 1) {
    const Image<Rgba32F> image = box_filtered(rendering.target.linear_image(), arguments.supersample);
    return is_float ? write_image(arguments.output, image) : write_image(arguments.output, codes_of(image, rendering.target.colour_format()));
  }
  auto written = is_float ? write_image(arguments.output, rendering.target.linear_image())
                          : write_image(arguments.output, rendering.target.colour_image());
  if (!written || arguments.depth_output.empty()) return written;
  return write_image(arguments.depth_output, rendering.target.depth_image());
}

/// Any view but the model's own colours.
int run_view(const RenderArguments& arguments, const Model& model, const RenderOptions& options, Pipeline& pipeline) {
  const auto picture = draw_view(*view_named(arguments.view), model, options, pipeline);
  if (!picture) return fail(arguments.model + ": " + picture.error().message);
  if (const auto written = write_image(arguments.output, picture->image); !written) return fail(written.error().message);
  std::printf("%s: %s\n%s\n", arguments.output.c_str(), arguments.view.c_str(), picture->legend.c_str());
  return kFine;
}

int run_scene(const RenderArguments& arguments, const CLI::App& command) {
  if (const auto good = check_scene_options(command); !good) return fail(good.error().message);
  const auto options = render_options_of(arguments.picture);
  if (!options) return fail(options.error().message);
  const auto pipeline_options = options_of(arguments.pipeline);
  if (!pipeline_options) return fail(pipeline_options.error().message);
  SceneArguments scene{.scene = arguments.model, .output = arguments.output, .size_pixels = {}, .supersampling = {}, .time = arguments.time, .statistics = arguments.statistics};
  if (command.count("--size") > 0) scene.size_pixels = glm::ivec2(options->width_pixels, options->height_pixels);
  if (command.count("--supersample") > 0) scene.supersampling = arguments.supersample;
  return render_scene(scene, *pipeline_options);
}

int run_render(const RenderArguments& arguments) {
  const bool is_map = arguments.view != "colour";
  if (arguments.time != 0) return fail("--time goes with scene files; a model does not move");
  if (is_map && !arguments.depth_output.empty()) return fail("--view " + arguments.view + " draws a map; --depth goes with the model's colours");
  if (is_map && arguments.statistics) return fail("--view " + arguments.view + " draws a map; --stats goes with the model's colours");
  if (arguments.supersample > 1 && (is_map || !arguments.depth_output.empty())) return fail("--supersample goes with the model's colours, not with --view or --depth");
  if (const auto refusal = refusal_of(arguments.budget, is_map); !refusal) return fail(refusal.error().message);
  auto options = render_options_of(arguments.picture);
  if (!options) return fail(options.error().message);
  options->width_pixels *= arguments.supersample;
  options->height_pixels *= arguments.supersample;
  auto pipeline_options = options_of(arguments.pipeline);
  if (!pipeline_options) return fail(pipeline_options.error().message);

  const auto model = load_model(arguments.model);
  if (!model) return fail(model.error().message);
  for (const std::string& warning : model->warnings) std::fprintf(stderr, "tuberia: warning: %s\n", warning.c_str());
  if (arguments.budget.is_given())
    if (const auto kept = keep_budget(arguments.budget, *model, *options, *pipeline_options); !kept)
      return fail(arguments.model + ": " + kept.error().message);
  Pipeline pipeline(*pipeline_options);
  if (is_map) return run_view(arguments, *model, *options, pipeline);
  const auto rendering = render(*model, *options, pipeline);
  if (!rendering) return fail(arguments.model + ": " + rendering.error().message);
  if (const auto written = write_results(arguments, *rendering); !written) return fail(written.error().message);

  std::printf("%s: %s, %s\n", arguments.output.c_str(), performance_line(*model, *rendering).c_str(),
              description_of(*pipeline_options, pipeline.workers().thread_count()).c_str());
  if (arguments.statistics) print_statistics(*rendering);
  return kFine;
}

}  // namespace

Run add_render(CLI::App& parent, CLI::App*& command) {
  const auto arguments = std::make_shared<RenderArguments>();
  command = parent.add_subcommand("render", "Draw a model or scene file to a picture");
  command->add_option("model", arguments->model, "OBJ, glTF, PLY, 3DS, Collada, OFF, STL, ...; or a scene, .json")->required();
  command->add_option("-o,--output", arguments->output, "Picture to write: .png, .ppm, .tga, .bmp, .jpg, .pfm, .hdr")->required();
  command->add_option("--view", arguments->view, "What the picture shows: the model's colours, or a map with a legend")
      ->check(CLI::IsMember(view_names()));
  command->add_option("--depth", arguments->depth_output, "Also write the depths: .pfm, or .png in 8 bits");
  command->add_option("--supersample", arguments->supersample, "Draw so many pixels each way for each of the picture, and take their mean in linear light")
      ->check(CLI::Range(1, 16))->group("Accuracy");
  command->add_option("--frames", arguments->picture.options.frames, "Frames to time; the median counts")->check(CLI::Range(1, 10000));
  command->add_flag("--stats", arguments->statistics, "Print what became of vertices and triangles");
  add_picture_options(*command, arguments->picture);
  add_pipeline_options(*command, arguments->pipeline);
  add_budget_options(*command, arguments->budget);
  command->add_option("--time", arguments->time, "Of a scene: how far its camera has moved")->check(CLI::Range(0.0, 1.0));
  return [arguments, command] { return is_scene_file(arguments->model) ? run_scene(*arguments, *command) : run_render(*arguments); };
}

}  // namespace tuberia::cli
