#include "examples/tuberia/subject.hpp"

#include <cstdio>

#include "examples/tuberia/demo_models.hpp"
#include "examples/tuberia/render_scene.hpp"
#include "scene/load_model.hpp"

namespace tuberia::cli {

void add_subject(CLI::App& command, SubjectArguments& arguments) {
  arguments.command = &command;
  command.add_option("model", arguments.model, "OBJ, glTF, PLY, 3DS, Collada, OFF, STL, ...; or --demo");
  command.add_option("--demo", arguments.demo, "A built-in model instead")->check(CLI::IsMember(demo_names()));
}

Result<Subject> subject_of(const SubjectArguments& arguments) {
  auto options = render_options_of(arguments.picture);
  if (!options) return options.error();
  if (arguments.demo.empty() == arguments.model.empty())
    return Error{arguments.command->get_name() + ": name a model file or --demo, one of the two"};
  if (arguments.demo.empty()) {
    if (is_scene_file(arguments.model)) return Error{arguments.model + " is a scene, and this command looks at models; tuberia render draws scenes"};
    auto model = load_model(arguments.model);
    if (!model) return model.error();
    for (const std::string& warning : model->warnings) std::fprintf(stderr, "tuberia: warning: %s\n", warning.c_str());
    return Subject{arguments.model, *std::move(model), *options};
  }
  // A demo brings its own framing; the size and the target can still be chosen.
  Demo demo = demo_named(arguments.demo);
  const RenderOptions& wished = *options;
  const auto is_given = [&](const char* option) { return arguments.command->count(option) > 0; };
  if (is_given("--size")) demo.options.width_pixels = wished.width_pixels, demo.options.height_pixels = wished.height_pixels;
  if (is_given("--program")) demo.options.shading = wished.shading;
  demo.options.sampler = wished.sampler;
  demo.options.cull_back = wished.cull_back;
  demo.options.colour_format = wished.colour_format;
  demo.options.depth_format = wished.depth_format;
  demo.options.background = wished.background;
  return Subject{"demo '" + demo.name + "'", std::move(demo.model), demo.options};
}

}  // namespace tuberia::cli
