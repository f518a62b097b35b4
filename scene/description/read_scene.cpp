#include "scene/description/read_scene.hpp"

#include "image/file.hpp"
#include "scene/description/key_reader.hpp"
#include "scene/description/scene_keys.hpp"

namespace tuberia {
namespace {

using namespace description;

/// Control characters as '?', so that the error stays one line.
std::string printable(std::string_view text) {
  std::string line(text);
  for (char& letter : line)
    if (static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f) letter = '?';
  return line;
}

Error refusal(std::string_view name, const JsonError& error) {
  std::string place = std::to_string(error.line);
  if (error.column > 0) place.append(":").append(std::to_string(error.column));
  return {printable(name) + ":" + place + ": " + printable(error.reason)};
}

}  // namespace

Result<SceneDescription> scene_from_json(std::string_view text, std::string_view name) {
  const auto parsed = parse_located_json(text);
  if (const auto* error = std::get_if<JsonError>(&parsed)) return refusal(name, *error);
  const LocatedJson& root = std::get<LocatedJson>(parsed);
  if (root.kind != LocatedJson::Kind::object)
    return refusal(name, {.line = root.line, .column = 0, .reason = "the scene is " + std::string(name_of(root.kind)) + ", but must be an object"});
  SceneDescription scene;
  KeyReader reader(root);
  scene_keys(reader, scene);
  reader.finish(scene);
  if (reader.error()) return refusal(name, *reader.error());
  return scene;
}

Result<SceneDescription> read_scene(const std::filesystem::path& path) {
  const auto bytes = read_file(path);
  if (!bytes) return bytes.error();
  auto scene = scene_from_json({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, path.string());
  if (scene) scene->folder = path.parent_path();
  return scene;
}

}  // namespace tuberia
