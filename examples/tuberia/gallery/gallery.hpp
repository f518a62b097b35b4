#pragma once
// The pictures of the gallery, and the page that shows them.

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "image/image.hpp"
#include "pipeline/pipeline.hpp"

namespace tuberia::cli {

/// A picture that was made, as the page shows it.
struct GalleryPicture {
  std::string file, title, source, caption, performance;
  int width_pixels = 0;
};

/// Pictures that belong together.
struct GallerySection {
  std::string title, lede;
  std::vector<std::string> names{};        // what to make: scene files without their ending, figures, or models
  std::vector<GalleryPicture> pictures{};  // what was made
  bool traced = false;                     // by rays, where scene files are meant
};

/// The whole gallery in its order.
std::vector<GallerySection> gallery_sections();

/// A picture with what the page says about it; file and name are the caller's.
struct GalleryDrawing {
  Image<Rgba8> image;
  std::string title, source, caption, performance;
  std::string svg{};  // in place of the image
};

/// A scene file. Errors: those of reading and drawing it.
Result<GalleryDrawing> scene_drawing(const std::filesystem::path& file, Pipeline& pipeline);

/// The same, its rays traced.
Result<GalleryDrawing> traced_drawing(const std::filesystem::path& file, Workers& workers);

/// The scene file whose picture matters less than the rays of its middle pixel: their tree.
bool is_ray_tree(const std::string& name);
Result<GalleryDrawing> ray_tree_drawing(const std::filesystem::path& file, Workers& workers);

/// Figures of curves and comparisons, which no scene file can say. scenes: the folder of the scene files that
/// some of them show. Nothing if there is no figure of that name.
bool is_figure(const std::string& name);
Result<GalleryDrawing> figure_drawing(const std::string& name, const std::filesystem::path& scenes, Pipeline& pipeline);

/// Models of Debian's packages, which an error names.
bool is_model(const std::string& name);
Result<GalleryDrawing> model_drawing(const std::string& name, int width_pixels, int height_pixels, Pipeline& pipeline);

/// One self-contained page beside its pictures.
std::string gallery_page(const std::vector<GallerySection>& sections, const std::string& machine);

}  // namespace tuberia::cli
