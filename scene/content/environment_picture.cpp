#include "scene/content/environment_picture.hpp"

#include <glm/geometric.hpp>
#include <numbers>

#include "math/transforms.hpp"
#include "scene/environment/read_environment.hpp"
#include "scene/environment/sky.hpp"

namespace tuberia {
namespace {

using Source = description::Environment::Source;

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

Surroundings sky_of(const description::Sky& sky) {
  return sky_surroundings({.towards_sun = sky.sun_towards, .sun_radius_radians = sky.sun_degrees / 2 * kRadiansPerDegree, .sun = sky.sun, .glow = sky.glow,
                           .zenith = sky.zenith, .horizon = sky.horizon, .ground = sky.ground, .cloudiness = sky.cloudiness, .seed = sky.seed});
}

template <class Picture>
Result<EnvironmentPicture> picture_or_error(Result<Picture> picture) {
  if (!picture) return picture.error();
  return EnvironmentPicture(*std::move(picture));
}

}  // namespace

Result<EnvironmentPicture> environment_picture(const SceneDescription& scene, const description::Environment& environment) {
  switch (environment.source) {
    case Source::sky: return EnvironmentPicture(sky_of(environment.sky));
    case Source::panorama: return picture_or_error(read_environment_image(file_of(scene, environment.file)));
    case Source::rendered: return Error{"it is rendered from the scene itself"};
    case Source::faces: break;
  }
  std::array<std::filesystem::path, 6> files;
  for (std::size_t i = 0; i < files.size(); ++i) files[i] = file_of(scene, environment.faces[i]);
  return picture_or_error(read_cube_images(files));
}

Surroundings surroundings_of(EnvironmentPicture picture) {
  if (auto* panorama = std::get_if<Image<Rgba32F>>(&picture)) return panorama_surroundings(std::move(*panorama));
  if (auto* faces = std::get_if<CubeImages>(&picture)) return cube_surroundings(std::move(*faces));
  return std::get<Surroundings>(std::move(picture));
}

glm::dmat3 source_from_world(const description::Environment& environment) noexcept {
  const bool is_turnable = environment.source != Source::rendered;
  return glm::dmat3(is_turnable ? rotation({0, 1, 0}, -environment.rotation_degrees * kRadiansPerDegree) : glm::mat4(1.0f));
}

Surroundings turned(Surroundings source, const glm::dmat3& source_from_map) {
  return {.radiance = [radiance = std::move(source.radiance), source_from_map](const glm::dvec3& direction) { return radiance(glm::normalize(source_from_map * direction)); },
          .detail_radians = source.detail_radians};
}

}  // namespace tuberia
