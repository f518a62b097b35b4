// tuberia gallery: real models from Debian's packages, each showing something else.

#include "examples/tuberia/gallery.hpp"

#include <cstdio>
#include <fstream>
#include <memory>

#include "examples/tuberia/commands.hpp"
#include "examples/tuberia/pipeline_options.hpp"
#include "image/write_image.hpp"
#include "scene/load_model.hpp"

namespace tuberia::cli {

std::vector<GalleryEntry> gallery_entries() {
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

namespace {

struct GalleryArguments {
  std::string folder = "out/gallery";
  int width_pixels = 1280, height_pixels = 720;
  PipelineArguments pipeline;
};

Result<GalleryPicture> make_picture(const GalleryEntry& entry, const GalleryArguments& arguments, Pipeline& pipeline) {
  const auto model = load_model(entry.model);
  if (!model) return Error{model.error().message + " (Debian package " + entry.package + ")"};
  RenderOptions options;
  options.width_pixels = arguments.width_pixels;
  options.height_pixels = arguments.height_pixels;
  options.shading = entry.shading;
  options.camera = {.azimuth_degrees = entry.azimuth_degrees, .elevation_degrees = entry.elevation_degrees, .zoom = entry.zoom,
                    .eye = {}, .look_at = {}, .up_axis = entry.up_axis};
  options.frames = 5;
  const auto rendering = render(*model, options, pipeline);
  if (!rendering) return Error{entry.model + ": " + rendering.error().message};
  const std::string file = entry.name + ".png";
  if (const auto written = write_image(std::filesystem::path(arguments.folder) / file, rendering->target.colour_image()); !written)
    return written.error();
  return GalleryPicture{file, entry.name, entry.caption, performance_line(*model, *rendering)};
}

int run_gallery(const GalleryArguments& arguments) {
  const auto options = options_of(arguments.pipeline);
  if (!options) return fail(options.error().message);
  std::error_code error;
  std::filesystem::create_directories(arguments.folder, error);
  if (error) return fail("cannot make the folder " + arguments.folder + ": " + error.message());

  Pipeline pipeline(*options);
  const std::vector<GalleryEntry> entries = gallery_entries();
  std::vector<GalleryPicture> pictures;
  int failures = 0;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    std::printf("[%2zu/%zu] %-14s ", i + 1, entries.size(), entries[i].name.c_str());
    std::fflush(stdout);
    auto picture = make_picture(entries[i], arguments, pipeline);
    std::printf("%s\n", picture ? picture->performance.c_str() : picture.error().message.c_str());
    if (picture) pictures.push_back(*std::move(picture));
    else ++failures;
  }

  const std::string page = arguments.folder + "/index.html";
  std::ofstream file(page, std::ios::binary);
  file << gallery_page(pictures, description_of(*options, pipeline.workers().thread_count()));
  file.close();
  if (!file) return fail("cannot write " + page);
  std::printf("%zu pictures: open %s\n", pictures.size(), page.c_str());
  return failures == 0 ? kFine : fail(std::to_string(failures) + " of the gallery's pictures could not be made");
}

}  // namespace

Run add_gallery(CLI::App& parent, CLI::App*& command) {
  const auto arguments = std::make_shared<GalleryArguments>();
  command = parent.add_subcommand("gallery", "Draw the gallery: real models from Debian's packages, and a page that shows them");
  command->add_option("--out", arguments->folder, "Folder for the pictures and index.html");
  add_pipeline_options(*command, arguments->pipeline);
  return [arguments] { return run_gallery(*arguments); };
}

}  // namespace tuberia::cli
