#include "scene/environment/environment_maps.hpp"

#include <utility>

#include "scene/environment/read_environment.hpp"

namespace tuberia {
namespace {

Result<EnvironmentMap> map_of(EnvironmentMap::Kind kind, Result<Texture> texture) {
  if (!texture) return texture.error();
  return EnvironmentMap{.kind = kind, .texture = std::make_shared<const Texture>(std::move(*texture)), .sampler = {}};
}

Result<EnvironmentMap> picture_map(EnvironmentMap::Kind kind, const Image<Rgba32F>& image, const char* name) {
  if (auto finite = check_finite(image, name); !finite) return finite.error();
  return map_of(kind, Texture::create(image));
}

}  // namespace

Result<EnvironmentMap> panorama_map(const Image<Rgba32F>& panorama) {
  return picture_map(EnvironmentMap::Kind::panorama, panorama, "panorama");
}

Result<EnvironmentMap> cube_map(const CubeImages& faces) {
  if (auto checked = check_cube(faces); !checked) return checked.error();
  return map_of(EnvironmentMap::Kind::cube, Texture::create_cube(faces));
}

Result<EnvironmentMap> sphere_map(const Image<Rgba32F>& ball) { return picture_map(EnvironmentMap::Kind::sphere, ball, "sphere map"); }

}  // namespace tuberia
