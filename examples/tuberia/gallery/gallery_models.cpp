#include <algorithm>

#include "examples/tuberia/gallery/gallery.hpp"
#include "examples/tuberia/render_model.hpp"
#include "scene/load_model.hpp"

namespace tuberia::cli {
namespace {

/// One picture: which model, how, and what to see in it.
struct ModelEntry {
  std::string name, model;   // model: path
  std::string package;       // the Debian package that it comes from
  std::string caption;
  Shading shading = Shading::automatic;
  double azimuth_degrees = 30, elevation_degrees = 15, zoom = 1;
  std::string up_axis = "y";
};

std::vector<ModelEntry> model_entries() {
  const std::string glmark = "/usr/share/glmark2/models/", assimp = "/usr/share/assimp/models/";
  const char* const glmark_package = "glmark2-data";
  const char* const assimp_package = "assimp-testmodels";
  return {
      {"bunny", glmark + "bunny.obj", glmark_package, "The bunny, Blinn's highlights at every fragment.", Shading::blinn, 15, 12, 1},
      {"bunny-gouraud", glmark + "bunny.obj", glmark_package, "The same, lit at the vertices: Gouraud shading.", Shading::gouraud, 15, 12, 1},
      {"bunny-flat", glmark + "bunny.obj", glmark_package, "Close by, one colour a triangle: flat shading shows the mesh.", Shading::flat, 15, 12, 3.2},
      {"horse", glmark + "horse.3ds", glmark_package, "A horse, with Phong's reflection vector instead of the halfway vector.", Shading::phong, 60, 8, 1.2, "-x"},
      {"cat", glmark + "cat.3ds", glmark_package, "A cat from a 3DS file.", Shading::automatic, 30, 15, 1.1, "-z"},
      {"asteroid", glmark + "asteroid-high.3ds", glmark_package, "An asteroid of small triangles.", Shading::automatic, 30, 15, 1},
      {"duck", assimp + "Collada/duck.dae", assimp_package, "A textured and lit duck from a Collada file.", Shading::textured_lit, 35, 18, 1},
      {"spider", assimp + "OBJ/spider.obj", assimp_package, "A spider: five textures, found beside the OBJ file.", Shading::textured_lit, 35, 30, 1.4},
      {"box", assimp + "glTF2/BoxTextured-glTF-Binary/BoxTextured.glb", assimp_package, "A box from a binary glTF file, its texture inside.", Shading::automatic, 40, 25, 0.9},
      {"engine", assimp + "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb", assimp_package, "An engine of many parts, each placed by its node.", Shading::automatic, 35, 25, 1.2},
      {"wuson", assimp + "OBJ/WusonOBJ.obj", assimp_package, "An ox from an OBJ file.", Shading::automatic, 215, 12, 1.3},
      {"teapots", assimp + "Collada/teapots.DAE", assimp_package, "Three teapots; the world is mapped on one.", Shading::automatic, 20, 30, 1.2},
  };
}

std::vector<ModelEntry> entries_named(const std::string& name) {
  std::vector<ModelEntry> entries = model_entries();
  std::erase_if(entries, [&](const ModelEntry& entry) { return entry.name != name; });
  return entries;
}

}  // namespace

bool is_model(const std::string& name) { return !entries_named(name).empty(); }

Result<GalleryDrawing> model_drawing(const std::string& name, int width_pixels, int height_pixels, Pipeline& pipeline) {
  const ModelEntry entry = entries_named(name).front();
  const auto model = load_model(entry.model);
  if (!model) return Error{model.error().message + " (Debian package " + entry.package + ")"};
  RenderOptions options;
  options.width_pixels = width_pixels;
  options.height_pixels = height_pixels;
  options.shading = entry.shading;
  options.camera = {.azimuth_degrees = entry.azimuth_degrees, .elevation_degrees = entry.elevation_degrees, .zoom = entry.zoom,
                    .eye = {}, .look_at = {}, .up_axis = entry.up_axis};
  options.frames = 5;
  const auto rendering = render(*model, options, pipeline);
  if (!rendering) return Error{entry.model + ": " + rendering.error().message};
  return GalleryDrawing{rendering->target.colour_image(), entry.name, "", entry.caption, performance_line(*model, *rendering)};
}

}  // namespace tuberia::cli
