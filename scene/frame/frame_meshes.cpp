#include "scene/frame/frame_meshes.hpp"

#include <algorithm>
#include <map>

namespace tuberia {
namespace {

/// Textures of a model's pictures, each made once.
class OwnTextures {
 public:
  Result<std::shared_ptr<const Texture>> texture(const std::shared_ptr<const Image<Rgba8>>& picture, TextureEncoding encoding) {
    if (picture == nullptr) return std::shared_ptr<const Texture>();
    std::shared_ptr<const Texture>& known = textures_[picture.get()];
    if (known != nullptr) return known;
    auto made = Texture::create(*picture, encoding);
    if (!made) return made.error();
    known = std::make_shared<const Texture>(*std::move(made));
    return known;
  }

 private:
  std::map<const Image<Rgba8>*, std::shared_ptr<const Texture>> textures_;
};

Result<FramePart> frame_part(ContentPart from, OwnTextures& textures) {
  const auto texture = textures.texture(from.own_texture, TextureEncoding::srgb);
  if (!texture) return Error{"its texture: " + texture.error().message};
  const auto normals = textures.texture(from.own_normals, TextureEncoding::linear);
  if (!normals) return Error{"its normals: " + normals.error().message};
  return FramePart{.mesh = std::move(from.mesh), .material = std::move(from.material), .own_texture = *texture, .own_normals = *normals,
                   .alpha_cutoff = from.alpha_cutoff};
}

void warn(const SceneDescription& scene, const description::Object& object, const std::string& name, const std::vector<FramePart>& parts, std::vector<std::string>& warnings) {
  const bool reads_colours = object.shading == description::Shading::flat || object.shading == description::Shading::gouraud;
  for (const FramePart& part : parts)
    if (!part.mesh.colours.empty() && !reads_colours) warnings.push_back(name + ": the colours at its vertices are seen with flat and gouraud shading only");
  const auto is_clear = [](const FramePart& part) { return part.material.transmission != glm::vec3(0); };
  if (std::any_of(parts.begin(), parts.end(), is_clear))
    warnings.push_back(name + ": what is behind it shows through straight on, not refracted, and it casts no shadow; both take rays (tuberia trace)");
  const auto is_mirror = [](const FramePart& part) { return part.material.mirror != glm::vec3(0); };
  if (!scene.environment && std::any_of(parts.begin(), parts.end(), is_mirror))
    warnings.push_back(name + ": it mirrors nothing, since the scene has no environment; to mirror other objects takes one or rays (tuberia trace)");
}

}  // namespace

Result<std::vector<FramePart>> parts_of(const SceneDescription& scene, const description::Object& object, std::vector<std::string>& warnings) {
  auto content = content_of(scene, object, warnings);
  if (!content) return content.error();
  const std::string name = name_of_object(scene, object);
  OwnTextures textures;
  std::vector<FramePart> parts;
  for (ContentPart& from : *content) {
    auto part = frame_part(std::move(from), textures);
    if (!part) return Error{name + ": " + part.error().message};
    parts.push_back(*std::move(part));
  }
  warn(scene, object, name, parts, warnings);
  return parts;
}

}  // namespace tuberia
