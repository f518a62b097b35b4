#include "scene/frame/frame_environment.hpp"

#include "scene/content/environment_picture.hpp"
#include "scene/environment/environment_maps.hpp"

namespace tuberia {
namespace {

using Source = description::Environment::Source;
using LookUp = description::Environment::LookUp;

Result<EnvironmentPicture> rendered(const SceneDescription& scene, const description::Environment& environment, Pipeline& pipeline, const DrawScene& draw_scene) {
  const glm::vec3& background = scene.picture.background;
  const CubeView view{.eye = environment.from, .size_pixels = environment.resolution, .near_distance = scene.camera.near_distance,
                      .far_distance = scene.camera.far_distance, .background = {background.r, background.g, background.b, 1}};
  auto faces = render_cube(pipeline, view, draw_scene);
  if (!faces) return faces.error();
  return EnvironmentPicture(*std::move(faces));
}

Result<EnvironmentMap> map_of(const Surroundings& surroundings, LookUp look_up, int resolution) {
  if (look_up == LookUp::cube) return cube_map(cube_of(surroundings, resolution));
  if (look_up == LookUp::panorama) return panorama_map(panorama_of(surroundings, 4 * resolution, 2 * resolution));
  return sphere_map(sphere_map_of(surroundings, 2 * resolution));
}

/// What is of the wanted kind already is taken as it is; all else goes through the directions.
Result<EnvironmentMap> unturned_map_of(EnvironmentPicture picture, LookUp look_up, int resolution) {
  if (const auto* panorama = std::get_if<Image<Rgba32F>>(&picture); panorama != nullptr && look_up == LookUp::panorama) return panorama_map(*panorama);
  if (const auto* faces = std::get_if<CubeImages>(&picture); faces != nullptr && look_up == LookUp::cube) return cube_map(*faces);
  return map_of(surroundings_of(std::move(picture)), look_up, resolution);
}

}  // namespace

Result<EnvironmentMap> environment_map_of(const SceneDescription& scene, const description::Environment& environment, const Camera& camera,
                                          Pipeline& pipeline, const DrawScene& draw_scene) {
  auto picture = environment.source == Source::rendered ? rendered(scene, environment, pipeline, draw_scene) : environment_picture(scene, environment);
  if (!picture) return picture.error();
  const glm::mat3 map_from_world(source_from_world(environment));
  if (environment.look_up != LookUp::sphere) {
    auto map = unturned_map_of(*std::move(picture), environment.look_up, environment.resolution);
    if (map) map->map_from_world = map_from_world;
    return map;
  }
  const auto basis = basis_of(camera);
  if (!basis) return basis.error();
  const glm::dmat3 world_from_view(basis->u, basis->v, basis->w);
  auto map = map_of(turned(surroundings_of(*std::move(picture)), source_from_world(environment) * world_from_view), LookUp::sphere, environment.resolution);
  if (map) map->map_from_world = glm::mat3(glm::transpose(world_from_view));
  return map;
}

}  // namespace tuberia
