#include "scene/frame/frame_environment.hpp"

#include <glm/geometric.hpp>
#include <numbers>

#include "math/transforms.hpp"
#include "scene/environment/environment_maps.hpp"
#include "scene/environment/read_environment.hpp"
#include "scene/environment/sky.hpp"

namespace tuberia {
namespace {

using Source = description::Environment::Source;
using LookUp = description::Environment::LookUp;

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

Surroundings sky_of(const description::Sky& sky) {
  return sky_surroundings({.towards_sun = sky.sun_towards, .sun_radius_radians = sky.sun_degrees / 2 * kRadiansPerDegree, .sun = sky.sun, .glow = sky.glow,
                           .zenith = sky.zenith, .horizon = sky.horizon, .ground = sky.ground, .cloudiness = sky.cloudiness, .seed = sky.seed});
}

Result<CubeImages> cube_images_of(const SceneDescription& scene, const description::Environment& environment, Pipeline& pipeline, const DrawScene& draw_scene) {
  if (environment.source == Source::rendered) {
    const glm::vec3& background = scene.picture.background;
    const CubeView view{.eye = environment.from, .size_pixels = environment.resolution, .near_distance = scene.camera.near_distance,
                        .far_distance = scene.camera.far_distance, .background = {background.r, background.g, background.b, 1}};
    return render_cube(pipeline, view, draw_scene);
  }
  std::array<std::filesystem::path, 6> files;
  for (std::size_t i = 0; i < files.size(); ++i) files[i] = file_of(scene, environment.faces[i]);
  return read_cube_images(files);
}

/// The same, seen in axes that are turned: source_from_map takes a direction of the map to one of the source.
Surroundings turned(Surroundings source, const glm::dmat3& source_from_map) {
  return {.radiance = [radiance = std::move(source.radiance), source_from_map](const glm::dvec3& direction) { return radiance(glm::normalize(source_from_map * direction)); },
          .detail_radians = source.detail_radians};
}

Result<EnvironmentMap> map_of(const Surroundings& surroundings, LookUp look_up, int resolution) {
  if (look_up == LookUp::cube) return cube_map(cube_of(surroundings, resolution));
  if (look_up == LookUp::panorama) return panorama_map(panorama_of(surroundings, 4 * resolution, 2 * resolution));
  return sphere_map(sphere_map_of(surroundings, 2 * resolution));
}

}  // namespace

Result<EnvironmentMap> environment_map_of(const SceneDescription& scene, const description::Environment& environment, const Camera& camera,
                                          Pipeline& pipeline, const DrawScene& draw_scene) {
  const bool is_turnable = environment.source != Source::rendered;
  const glm::mat3 source_from_world(is_turnable ? rotation({0, 1, 0}, -environment.rotation_degrees * kRadiansPerDegree) : glm::mat4(1.0f));
  // What is of the wanted kind already is taken as it is, only turned; all else goes through the directions.
  const auto turned_map = [&](Result<EnvironmentMap> map) {
    if (map) map->map_from_world = source_from_world;
    return map;
  };
  Surroundings surroundings;
  if (environment.source == Source::sky) {
    surroundings = sky_of(environment.sky);
  } else if (environment.source == Source::panorama) {
    const auto image = read_environment_image(file_of(scene, environment.file));
    if (!image) return image.error();
    if (environment.look_up == LookUp::panorama) return turned_map(panorama_map(*image));
    surroundings = panorama_surroundings(*image);
  } else {
    const auto faces = cube_images_of(scene, environment, pipeline, draw_scene);
    if (!faces) return faces.error();
    if (environment.look_up == LookUp::cube) return turned_map(cube_map(*faces));
    surroundings = cube_surroundings(*faces);
  }
  if (environment.look_up != LookUp::sphere) return turned_map(map_of(surroundings, environment.look_up, environment.resolution));
  const auto basis = basis_of(camera);
  if (!basis) return basis.error();
  const glm::dmat3 world_from_view(basis->u, basis->v, basis->w);
  auto map = map_of(turned(std::move(surroundings), glm::dmat3(source_from_world) * world_from_view), LookUp::sphere, environment.resolution);
  if (map) map->map_from_world = glm::mat3(glm::transpose(world_from_view));
  return map;
}

}  // namespace tuberia
