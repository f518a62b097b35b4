// Which of the pipeline's techniques a place calls for: only those can be why it was drawn otherwise.

#include "examples/tuberia/witness/departing.hpp"
#include "examples/tuberia/witness/imitation.hpp"

namespace tuberia::witness {

using tracer::Hit;
using tracer::Ray;
using tracer::SurfacePoint;
using tracer::TraceScratch;

/// Null for the default one, and for those that are named in a model's file.
const description::Material* Imitation::material_of(const Hit& hit) const {
  const SceneDescription& description = scene_->description();
  return find_material(description, description.objects[static_cast<std::size_t>(scene_->object_of(hit.item))].material);
}

bool Imitation::is_blended(const Hit& hit) const {
  const description::Material* material = material_of(hit);
  return material != nullptr && (material->alpha < 1 || material->transmission != glm::vec3(0));
}

bool Imitation::is_lit_at_vertices(const Hit& hit) const {
  return scene_->description().objects[static_cast<std::size_t>(scene_->object_of(hit.item))].shading != description::Shading::phong;
}

bool Imitation::has_texture(const Hit& hit) const {
  const description::Material* material = material_of(hit);
  return material != nullptr && !material->texture.empty();
}

bool Imitation::is_clear(const Hit& hit) const {
  const description::Material* material = hit ? material_of(hit) : nullptr;
  return material != nullptr && material->transmission != glm::vec3(0);
}

/// Whether something clear, which a shadow map leaves out, stands between a point and a light.
bool Imitation::has_clear_caster(const Fragment& fragment, TraceScratch& scratch) const {
  scratch.lights.clear();
  scene_->lights(fragment.at.position, scratch.lights);
  for (std::size_t i = 0; i < scratch.lights.size(); ++i) {
    if (!lights_[i].shadow) continue;
    Ray ray = leaving(fragment.at, scratch.lights[i].to_light, scratch.lights[i].distance);
    for (Hit hit = scene_->accelerator().nearest(ray, scratch.traversal); hit; hit = scene_->accelerator().nearest(ray, scratch.traversal)) {
      if (scene_->casts_shadow(hit.item) && is_blended(hit)) return true;
      ray.t_min = hit.t;
    }
  }
  return false;
}

/// Whether the documents have a clear body drawn otherwise than rays see it: bent, with its shadow, before surroundings that only rays see.
bool Imitation::is_drawn_otherwise(const Fragment& fragment, TraceScratch& scratch) const {
  const bool is_before_other_surroundings = environment_ && !scene_->description().environment->shown;
  return fragment.material.refractive_index != 1 || is_before_other_surroundings || has_clear_caster(fragment, scratch);
}

bool Imitation::mirrors_object(const Fragment& fragment, TraceScratch& scratch) const {
  return static_cast<bool>(tracer_.first_hit(mirrored_ray(fragment), scratch));
}

Causes Imitation::techniques_of(const Place& place, const Ray& ray, const Hit& hit, TraceScratch& scratch) const {
  if (!hit) return environment_ && scene_->description().environment->shown ? Causes(Cause::environment_map) : Causes();
  if (is_lit_at_vertices(hit)) return has_texture(hit) ? Cause::vertex_shading | Causes(Cause::mipmap) : Causes(Cause::vertex_shading);
  Causes causes;
  for (const LightContent& light : lights_) {
    if (light.shadow) causes = causes | Cause::shadow_map;
    if (light.throws_picture) causes = causes | Cause::mipmap;
  }
  const description::Material* material = material_of(hit);
  if (material == nullptr) return causes | Cause::mipmap;  // of a model file: its own
  if (!material->texture.empty() || material->pattern || material->bump) causes = causes | Cause::mipmap;
  if (material->mirror == glm::vec3(0) && !is_clear(hit)) return causes;
  if (material->mirror != glm::vec3(0) && environment_) causes = causes | Cause::environment_map;
  const SurfacePoint at = scene_->geometry().surface(ray, hit);
  const Fragment here = fragment(hit, at, -ray.direction, footprint_of_rays(place, at));
  // Relief has another normal by the block's steps.
  const auto is_mirrored = [&] { return mirrors_object(here, scratch) || (causes.has(Cause::mipmap) && mirrors_object(fragment_in_block(place, hit, at, ray), scratch)); };
  if (material->mirror != glm::vec3(0) && (!environment_ || is_mirrored())) causes = causes | Cause::mirror_of_surroundings;
  if (is_clear(hit) && is_drawn_otherwise(here, scratch)) causes = causes | Cause::transmission;
  return causes;
}

}  // namespace tuberia::witness
