// tuberia info MODEL, tuberia info SCENE.json, tuberia info --scene-keys

#include <array>
#include <cstdio>
#include <memory>

#include "examples/tuberia/commands.hpp"
#include "examples/tuberia/render_model.hpp"
#include "examples/tuberia/render_scene.hpp"
#include "scene/description/read_scene.hpp"
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

constexpr std::array<const char*, 12> kShapes{"plane", "cube", "sphere", "cylinder", "cone", "torus", "disc", "teapot", "Bezier patches", "height field", "mesh", "model"};
constexpr std::array<const char*, 4> kLights{"directional", "point", "spot", "area"}, kShadings{"flat", "Gouraud", "dot-product", "Phong"},
    kSurroundings{"a sky", "a panorama", "six faces", "the scene itself"};

std::string in_quotes(const std::string& name) { return name.empty() ? "" : " '" + name + "'"; }

int run_scene_info(const std::string& path) {
  const auto scene = read_scene(path);
  if (!scene) return fail(scene.error().message);
  std::printf("%s: %s\n", path.c_str(), scene->title.empty() ? "a scene" : scene->title.c_str());
  if (!scene->source.empty()) std::printf("source    %s\n", scene->source.c_str());
  if (!scene->caption.empty()) std::printf("caption   %s\n", scene->caption.c_str());
  std::printf("image     %dx%d, %d sample%s a pixel\n", scene->picture.width, scene->picture.height, scene->picture.supersampling * scene->picture.supersampling,
              scene->picture.supersampling == 1 ? "" : "s");
  for (const description::Light& light : scene->lights)
    std::printf("light     %s%s%s%s\n", kLights[static_cast<std::size_t>(light.kind)], in_quotes(light.name).c_str(), light.shadow ? ", casts shadows" : "",
                light.projection ? ", throws a picture" : "");
  for (const description::Texture& texture : scene->textures) std::printf("texture  %s %s\n", in_quotes(texture.name).c_str(), texture.file.empty() ? "made" : texture.file.c_str());
  for (const description::Material& material : scene->materials)
    std::printf("material %s%s%s%s\n", in_quotes(material.name).c_str(), material.texture.empty() && !material.pattern ? "" : ", textured", material.bump ? ", with relief" : "",
                material.mirror == glm::vec3(0) ? "" : ", mirrors");
  if (scene->environment) std::printf("around it %s\n", kSurroundings[static_cast<std::size_t>(scene->environment->source)]);
  for (const description::Object& object : scene->objects)
    std::printf("object    %s%s, %s shading, material%s\n", kShapes[object.shape.index()], in_quotes(object.name).c_str(), kShadings[static_cast<std::size_t>(object.shading)],
                object.material.empty() ? " of its own" : in_quotes(object.material).c_str());
  return kFine;
}

}  // namespace

Run add_info(CLI::App& parent, CLI::App*& command) {
  const auto path = std::make_shared<std::string>();
  const auto keys = std::make_shared<bool>(false);
  command = parent.add_subcommand("info", "List what a model or scene file holds");
  command->add_option("model", *path, "Model or scene file");
  command->add_flag("--scene-keys", *keys, "Print the page of all keys that a scene file may have");
  return [path, keys] {
    if (*keys) return std::fputs(scene_file_page().c_str(), stdout) < 0 ? kFailed : kFine;
    if (path->empty()) return fail("model is required");
    return is_scene_file(*path) ? run_scene_info(*path) : run_info(*path);
  };
}

}  // namespace tuberia::cli
