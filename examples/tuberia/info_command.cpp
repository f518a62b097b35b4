// tuberia info MODEL

#include <cstdio>
#include <memory>

#include "examples/tuberia/commands.hpp"
#include "examples/tuberia/render_model.hpp"
#include "scene/load_model.hpp"

namespace tuberia::cli {
namespace {

void print_meshes(const Model& model) {
  for (const Mesh& mesh : model.meshes)
    std::printf("mesh      '%s': %s triangles, %s vertices%s%s, material %d\n", mesh.name.c_str(),
                with_commas(mesh.triangle_count()).c_str(), with_commas(static_cast<std::int64_t>(mesh.positions.size())).c_str(),
                mesh.texcoords.empty() ? "" : ", texture coordinates", mesh.colours.empty() ? "" : ", colours", mesh.material);
}

void print_materials(const Model& model) {
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    const Material& m = model.materials[i];
    std::printf("material  %zu '%s': colour (%.3f %.3f %.3f), opacity %.3f, shininess %.1f%s\n", i, m.name.c_str(),
                static_cast<double>(m.base_colour.r), static_cast<double>(m.base_colour.g), static_cast<double>(m.base_colour.b),
                static_cast<double>(m.base_colour.a), static_cast<double>(m.shininess),
                m.texture >= 0 ? (", texture " + std::to_string(m.texture)).c_str() : "");
  }
  for (std::size_t i = 0; i < model.textures.size(); ++i)
    std::printf("texture   %zu '%s': %dx%d%s\n", i, model.textures[i].name.c_str(), model.textures[i].image.width(),
                model.textures[i].image.height(), model.textures[i].missing ? ", MISSING" : "");
}

int run_info(const std::string& path) {
  const auto model = load_model(path);
  if (!model) return fail(model.error().message);
  const Bounds bounds = model->bounds();
  std::printf("%s: %s triangles, %s vertices\n", path.c_str(), with_commas(model->triangle_count()).c_str(),
              with_commas(model->vertex_count()).c_str());
  std::printf("bounds    (%g %g %g) to (%g %g %g)\n", static_cast<double>(bounds.lower.x), static_cast<double>(bounds.lower.y),
              static_cast<double>(bounds.lower.z), static_cast<double>(bounds.upper.x), static_cast<double>(bounds.upper.y),
              static_cast<double>(bounds.upper.z));
  print_meshes(*model);
  print_materials(*model);
  for (const std::string& warning : model->warnings) std::printf("warning   %s\n", warning.c_str());
  return kFine;
}

}  // namespace

Run add_info(CLI::App& parent, CLI::App*& command) {
  const auto path = std::make_shared<std::string>();
  command = parent.add_subcommand("info", "List what a model file holds");
  command->add_option("model", *path, "Model file")->required();
  return [path] { return run_info(*path); };
}

}  // namespace tuberia::cli
