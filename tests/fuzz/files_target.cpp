#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "examples/tuberia/render_model.hpp"
#include "image/read_image.hpp"
#include "scene/description/check_scene.hpp"
#include "scene/description/read_scene.hpp"
#include "scene/load_model.hpp"
#include "tests/fuzz/targets.hpp"

namespace tuberia::fuzz {
namespace {

namespace fs = std::filesystem;

/// Models first. New ones go to the end, or the corpus means something else.
constexpr std::array<std::string_view, 16> kExtensions{".obj", ".ply", ".off", ".stl", ".dae", ".glb", ".gltf", ".3ds",
                                                       ".png", ".jpg", ".tga", ".bmp", ".ppm", ".pgm", ".hdr", ".pfm"};
constexpr std::size_t kModelExtensions = 8;
constexpr std::uint8_t kScene = 0xff;  // beyond the others, so that they go on meaning what they meant

/// A folder of this process, gone when it ends.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("tuberia_fuzz_" + std::to_string(::getpid()))) { fs::create_directories(path_); }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  fs::path write(std::string_view extension, Input bytes) const {
    const fs::path file = path_ / ("input" + std::string(extension));
    std::ofstream(file, std::ios::binary | std::ios::trunc).write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return file;
  }

 private:
  fs::path path_;
};

bool is_one_line(const std::string& message) { return !message.empty() && message.find('\n') == std::string::npos; }

std::string try_mesh(const Mesh& mesh) {
  const std::size_t count = mesh.positions.size();
  for (const std::uint32_t index : mesh.indices)
    if (index >= count) return "an index is out of range";
  if (mesh.indices.size() % 3 != 0 || mesh.normals.size() != count) return "a mesh lacks normals or a corner";
  if ((!mesh.texcoords.empty() && mesh.texcoords.size() != count) || (!mesh.colours.empty() && mesh.colours.size() != count)) return "an attribute is short";
  for (const glm::vec3& p : mesh.positions)
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return "a position is not finite";
  return {};
}

std::string try_model(const fs::path& file) {
  const Result<Model> model = load_model(file);
  if (!model) return is_one_line(model.error().message) ? "" : "an error of several lines: " + model.error().message;
  for (const Mesh& mesh : model->meshes)
    if (std::string wrong = try_mesh(mesh); !wrong.empty()) return wrong;
  static Pipeline pipeline({.threads = 1});
  cli::RenderOptions options;
  options.width_pixels = options.height_pixels = 16;
  options.frames = 1;
  // Cameras may refuse a model's size; draws of a model that was read may not be refused.
  auto frame = cli::prepare(*model, options);
  if (!frame) return is_one_line(frame.error().message) ? "" : "an error of several lines: " + frame.error().message;
  const auto statistics = cli::draw(*frame, pipeline);
  return statistics ? "" : "a model that was read cannot be drawn: " + statistics.error().message;
}

/// What is read is written as a text that reads as the same.
std::string try_scene(Input bytes) {
  const auto scene = scene_from_json({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, "scene.json");
  if (!scene) return is_one_line(scene.error().message) ? "" : "an error of several lines: " + scene.error().message;
  const auto again = scene_from_json(json_of_scene(*scene), "again.json");
  if (!again) return "a scene that was read cannot be read again: " + again.error().message;
  if (const auto checked = check_scene(*scene); !checked) return "a scene that was read is said to be out of range: " + checked.error().message;
  return *again == *scene ? "" : "a scene changes when it is written and read";
}

template <class Pixel>
std::string try_image(const Result<Image<Pixel>>& image) {
  if (!image) return is_one_line(image.error().message) ? "" : "an error of several lines: " + image.error().message;
  if (image->width() < 1 || image->height() < 1) return "an image without pixels";
  return {};
}

}  // namespace

std::string try_files(Input input) {
  static const Folder folder;
  if (input.empty()) return {};
  if (input[0] == kScene) return try_scene(input.subspan(1));
  const std::size_t kind = input[0] % kExtensions.size();
  const fs::path file = folder.write(kExtensions[kind], input.subspan(1));
  if (kind < kModelExtensions) return try_model(file);
  if (kExtensions[kind] == ".hdr" || kExtensions[kind] == ".pfm") return try_image(read_float_image(file));
  return try_image(read_image(file));
}

}  // namespace tuberia::fuzz
