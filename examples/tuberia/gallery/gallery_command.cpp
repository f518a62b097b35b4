// tuberia gallery

#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>

#include "examples/tuberia/commands.hpp"
#include "examples/tuberia/gallery/gallery.hpp"
#include "examples/tuberia/pipeline_options.hpp"
#include "image/write_image.hpp"

namespace tuberia::cli {
namespace {

struct GalleryArguments {
  std::string folder = "out/gallery", scenes = "examples/scenes";
  std::vector<std::string> only;
  PipelineArguments pipeline;
};

constexpr int kModelWidth = 1280, kModelHeight = 720;  // pixels
constexpr int kSvgWidth = 640;                         // on the page; they are as sharp at any

Result<Nothing> write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) return Error{"cannot write " + path.string()};
  return Nothing{};
}

Result<GalleryPicture> make_picture(const std::string& name, bool traced, const GalleryArguments& arguments, Pipeline& pipeline) {
  const std::filesystem::path scene = std::filesystem::path(arguments.scenes) / (name + ".json");
  auto drawing = is_model(name)      ? model_drawing(name, kModelWidth, kModelHeight, pipeline)
                 : is_figure(name)   ? figure_drawing(name, arguments.scenes, pipeline)
                 : is_ray_tree(name) ? ray_tree_drawing(scene, pipeline.workers())
                 : traced            ? traced_drawing(scene, pipeline.workers())
                                     : scene_drawing(scene, pipeline);
  if (!drawing) return drawing.error();
  const bool is_svg = !drawing->svg.empty();
  const std::string file = name + (is_svg ? ".svg" : ".png");
  const std::filesystem::path path = std::filesystem::path(arguments.folder) / file;
  if (const auto written = is_svg ? write_text(path, drawing->svg) : write_image(path, drawing->image); !written) return written.error();
  return GalleryPicture{file, drawing->title, drawing->source, drawing->caption, drawing->performance, is_svg ? kSvgWidth : drawing->image.width()};
}

/// Keeps of the gallery what was asked for. Error for a name that is not in it.
Result<Nothing> keep_only(const std::vector<std::string>& wanted, std::vector<GallerySection>& sections) {
  std::vector<std::string> unknown = wanted;
  for (GallerySection& section : sections) {
    if (wanted.empty()) continue;
    std::erase_if(section.names, [&](const std::string& name) { return std::find(wanted.begin(), wanted.end(), name) == wanted.end(); });
    for (const std::string& name : section.names) std::erase(unknown, name);
  }
  std::erase_if(sections, [](const GallerySection& section) { return section.names.empty(); });
  if (!unknown.empty()) return Error{"the gallery has no picture " + unknown.front()};
  return Nothing{};
}

/// Fills the sections with what could be made; says of each picture what became of it. How many could not.
int make_pictures(const GalleryArguments& arguments, Pipeline& pipeline, std::vector<GallerySection>& sections) {
  std::size_t count = 0, done = 0;
  for (const GallerySection& section : sections) count += section.names.size();
  int failures = 0;
  for (GallerySection& section : sections) {
    for (const std::string& name : section.names) {
      std::printf("[%2zu/%zu] %-28s ", ++done, count, name.c_str());
      std::fflush(stdout);
      auto picture = make_picture(name, section.traced, arguments, pipeline);
      std::printf("%s\n", picture ? picture->performance.c_str() : picture.error().message.c_str());
      if (picture) section.pictures.push_back(*std::move(picture));
      else ++failures;
    }
  }
  return failures;
}

int run_gallery(const GalleryArguments& arguments) {
  const auto options = options_of(arguments.pipeline);
  if (!options) return fail(options.error().message);
  std::vector<GallerySection> sections = gallery_sections();
  if (const auto kept = keep_only(arguments.only, sections); !kept) return fail(kept.error().message);
  std::error_code error;
  std::filesystem::create_directories(arguments.folder, error);
  if (error) return fail("cannot make the folder " + arguments.folder + ": " + error.message());

  const auto start = std::chrono::steady_clock::now();
  Pipeline pipeline(*options);
  const int failures = make_pictures(arguments, pipeline, sections);
  const std::string page = arguments.folder + "/index.html";
  const auto written = write_text(page, gallery_page(sections, description_of(*options, pipeline.workers().thread_count())));
  if (!written) return fail(written.error().message);
  std::size_t count = 0;
  for (const GallerySection& section : sections) count += section.pictures.size();
  std::printf("%zu pictures in %.0f s: open %s\n", count, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), page.c_str());
  return failures == 0 ? kFine : fail(std::to_string(failures) + " of the gallery's pictures could not be made");
}

}  // namespace

Run add_gallery(CLI::App& parent, CLI::App*& command) {
  const auto arguments = std::make_shared<GalleryArguments>();
  command = parent.add_subcommand("gallery", "Draw the gallery: the figures of the course as scenes, models of Debian's packages, and a page that shows them");
  command->add_option("--out", arguments->folder, "Folder for the pictures and index.html");
  command->add_option("--scenes", arguments->scenes, "Folder of the scene files");
  command->add_option("--only", arguments->only, "Names of pictures, without their ending; all others are left out")->delimiter(',');
  add_pipeline_options(*command, arguments->pipeline);
  return [arguments] { return run_gallery(*arguments); };
}

}  // namespace tuberia::cli
