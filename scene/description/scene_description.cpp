#include "scene/description/scene_description.hpp"

#include <algorithm>

namespace tuberia {
namespace {

template <class Named>
const Named* find_named(const std::vector<Named>& all, std::string_view name) noexcept {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

const description::Texture* find_texture(const SceneDescription& scene, std::string_view name) noexcept { return find_named(scene.textures, name); }
const description::Material* find_material(const SceneDescription& scene, std::string_view name) noexcept { return find_named(scene.materials, name); }

std::filesystem::path file_of(const SceneDescription& scene, const std::string& name) { return scene.folder / std::filesystem::path(name); }

}  // namespace tuberia
