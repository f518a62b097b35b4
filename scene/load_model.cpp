#include "scene/load_model.hpp"

#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>

#include "image/file.hpp"
#include "scene/assimp_log.hpp"
#include "scene/check_model_file.hpp"
#include "scene/convert_assimp.hpp"
#include "scene/find_texture.hpp"
#include "scene/obj_check.hpp"

namespace tuberia {
namespace {

namespace fs = std::filesystem;

Error refusal(const fs::path& path, const std::string& reason) {
  return {"cannot load model " + quoted_path(path) + ": " + reason};
}

/// Assimp's message without line ends and other control characters, runs of space as one.
std::string one_line(std::string_view message) {
  std::string line;
  for (const char letter : message) {
    const bool space = static_cast<unsigned char>(letter) <= 0x20 || letter == 0x7f;
    if (!space) line += letter;
    if (space && !line.empty() && line.back() != ' ') line += ' ';
  }
  while (line.ends_with(' ')) line.pop_back();
  return line.empty() ? "Assimp gives no reason" : line;
}

std::string reason_of_assimp(const Assimp::Importer& importer, const fs::path& path) {
  const std::string_view message = importer.GetErrorString();
  if (message.find("No suitable reader found") == std::string_view::npos) return one_line(message);
  const std::string extension = lower_case_extension(path);
  if (extension.empty() || !importer.IsExtensionSupported(extension)) return "unknown model format";
  return "its content is not that of a " + extension + " file: corrupt or truncated";
}

/// glTF alone says that its colours are linear; of the others see Material.
ColourSpace colour_space_of(const std::string& extension) {
  return extension == ".gltf" || extension == ".glb" ? ColourSpace::linear : ColourSpace::srgb;
}

/// Assimp goes on without a material library that it does not find, and without a word.
void warn_of_missing_libraries(const fs::path& path, std::string_view text, Model& model) {
  for (const std::string& name : material_libraries_of_obj(text)) {
    if (find_beside_model(path.parent_path(), name)) continue;
    model.warnings.push_back("material library " + quoted_path(name) + " of model " + quoted_path(path) +
                             " was not found");
  }
}

/// Some importers bend an index that is out of range to a vertex that exists, or leave the face
/// out, and only log that they did. Empty if nothing of the kind was logged.
std::string why_not_log(const std::vector<std::string>& complaints) {
  for (const std::string& complaint : complaints) {
    for (const char* words : {"out of range", "out-of-range", "index overflow"}) {
      if (complaint.find(words) != std::string::npos) return one_line(complaint);
    }
  }
  return {};
}

/// The part that may throw, for Assimp's importers do where memory does not suffice.
Result<Model> import_model(const fs::path& path) {
  // Assimp's steps trust what its importers made of the file, so look at that first. (Its own
  // aiProcess_ValidateDataStructure would refuse good files for one empty mesh.)
  Assimp::Importer importer;
  const aiScene* scene = nullptr;
  const auto complaints = assimp_complaints_during([&] { scene = importer.ReadFile(path.string(), 0); });
  if (scene == nullptr) return refusal(path, reason_of_assimp(importer, path));
  if (const std::string reason = why_not_log(complaints); !reason.empty()) return refusal(path, reason);
  if (const std::string reason = why_not_scene(*scene); !reason.empty()) return refusal(path, reason);

  // Joining and normals are our own: Assimp joins vertices that are nearer than 1e-5, whatever the
  // model's size, which crushes small models.
  scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_TransformUVCoords |
                                       aiProcess_FlipUVs);
  if (scene == nullptr) return refusal(path, reason_of_assimp(importer, path));

  Model model;
  const ColourSpace colours = colour_space_of(lower_case_extension(path));
  if (const std::string reason = convert_meshes(*scene, colours, model); !reason.empty())
    return refusal(path, reason);
  if (model.meshes.empty()) return refusal(path, "it has no triangles");
  convert_materials(*scene, path, colours, model);
  return model;
}

}  // namespace

Result<Model> load_model(const fs::path& path) {
  const Result<std::vector<std::byte>> bytes = read_file(path);
  if (!bytes) return bytes.error();
  const std::string extension = lower_case_extension(path);
  if (const std::string reason = why_not_model_file(*bytes, extension); !reason.empty())
    return refusal(path, reason);

  try {
    Result<Model> model = import_model(path);
    if (model && extension == ".obj") {
      warn_of_missing_libraries(path, {reinterpret_cast<const char*>(bytes->data()), bytes->size()},
                                *model);
    }
    return model;
  } catch (const std::bad_alloc&) {
    return refusal(path, "it claims more than memory holds");
  } catch (const std::length_error&) {
    return refusal(path, "it claims more than memory holds");
  } catch (const std::exception& exception) {
    return refusal(path, one_line(exception.what()));
  }
}

}  // namespace tuberia
