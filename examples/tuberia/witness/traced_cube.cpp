#include "examples/tuberia/witness/traced_cube.hpp"

#include "examples/tuberia/witness/imitation.hpp"
#include "scene/environment/render_cube.hpp"

namespace tuberia::witness {
namespace {

/// Surroundings have none themselves. What is not seen in them casts shadows all the same.
SceneDescription without_surroundings(SceneDescription scene) {
  for (description::Material& material : scene.materials) material.mirror = glm::vec3(0);
  scene.environment.reset();
  return scene;
}

/// The first object that is seen in surroundings; the ray begins behind all others.
tracer::Hit first_seen(const tracer::RayTracer& tracer, tracer::Ray& ray, tracer::TraceScratch& scratch) {
  const tracer::TracedScene& scene = tracer.scene();
  tracer::Hit hit = tracer.first_hit(ray, scratch);
  while (hit && !scene.description().objects[static_cast<std::size_t>(scene.object_of(hit.item))].seen_in_environment) {
    ray.t_min = hit.t;
    hit = tracer.first_hit(ray, scratch);
  }
  return hit;
}

Rgba32F texel_of(const glm::dvec3& light) { return {static_cast<float>(light.r), static_cast<float>(light.g), static_cast<float>(light.b), 1}; }

}  // namespace

Result<CubeImages> traced_cube(const SceneDescription& scene, const description::Environment& environment, Workers& workers) {
  const auto surroundings = tracer::TracedScene::create(without_surroundings(scene), workers, {.surfaces = tracer::SurfaceKind::tessellated});
  if (!surroundings) return surroundings.error();
  const tracer::RayTracer tracer(*surroundings);
  const int size = environment.resolution;
  const CubeView view{.eye = environment.from, .size_pixels = size, .near_distance = scene.camera.near_distance, .far_distance = scene.camera.far_distance};
  std::vector<tracer::TraceScratch> scratches(static_cast<std::size_t>(workers.thread_count()));
  CubeImages faces;
  for (int face = 0; face < 6; ++face) {
    const auto imitation = Imitation::create(*surroundings, cube_face_camera(view, face), {size, size}, workers);
    if (!imitation) return imitation.error();
    Image<Rgba32F>& image = faces[static_cast<std::size_t>(face)] = Image<Rgba32F>(size, size);
    parallel_for(workers, size, [&](std::int64_t row, int worker) {
      tracer::TraceScratch& scratch = scratches[static_cast<std::size_t>(worker)];
      for (int x = 0; x < size; ++x) {
        const Place place{.pixel = {x, static_cast<int>(row)}};
        tracer::Ray ray = imitation->ray(place);
        const tracer::Hit hit = first_seen(tracer, ray, scratch);
        // A camera's picture is the face mirrored left to right.
        image.at(size - 1 - x, static_cast<int>(row)) = texel_of(imitation->light(place, ray, hit, kAllCauses, scratch).low);
      }
    });
  }
  return faces;
}

}  // namespace tuberia::witness
