#include "examples/tuberia/witness/imitation.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "examples/tuberia/witness/departing.hpp"
#include "examples/tuberia/witness/traced_cube.hpp"
#include "scene/frame/frame_lights.hpp"

namespace tuberia::witness {
namespace {

using tracer::Hit;
using tracer::Ray;
using tracer::SurfacePoint;
using tracer::TraceScratch;

/// A box around all triangles.
Bounds bounds_of(const tracer::Geometry& geometry) {
  Bounds box;
  for (std::int64_t item = 0; item < geometry.count(); ++item)
    if (const auto corners = geometry.triangle(item))
      for (const glm::dvec3& corner : *corners) box.add(glm::vec3(corner));
  return box;
}

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

/// What a light sends on, without anything in its way.
glm::dvec3 reflected(const tracer::PointMaterial& material, const glm::dvec3& normal, const glm::dvec3& to_eye, const tracer::TracedLight& light) {
  if (!(glm::dot(normal, light.to_light) > 0)) return glm::dvec3(0);
  return light.intensity * reflected_share(material.reflection, {.normal = normal, .to_light = light.to_light, .to_eye = to_eye});
}

/// Where a ray meets the plane of a triangle: the second and third corner's shares.
std::optional<glm::dvec2> weights_on_plane(const std::array<glm::dvec3, 3>& corners, const Ray& ray) {
  const glm::dvec3 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0], s = ray.origin - corners[0], p = glm::cross(ray.direction, e2);
  const double determinant = glm::dot(e1, p);
  if (determinant == 0) return std::nullopt;
  return glm::dvec2(glm::dot(s, p), glm::dot(ray.direction, glm::cross(s, e1))) / determinant;
}

}  // namespace

Result<std::vector<Imitation::LightContent>> Imitation::contents_of(const description::Light& light, const Bounds& seen) {
  const auto points = lights_of(light);
  if (!points) return points.error();
  std::vector<LightContent> contents;
  for (const Light& point : *points) {
    LightContent& content = contents.emplace_back(LightContent{.intensity = glm::dvec3(point.intensity), .throws_picture = light.projection.has_value()});
    if (light.shadow) {
      const auto view = shadow_view_of(light, point, seen);
      if (!view) return view.error();
      content.shadow.emplace(*light.shadow, *view);
    }
  }
  return contents;
}

Result<Imitation> Imitation::create(const tracer::TracedScene& scene, const Camera& camera, const glm::ivec2& size_pixels, Workers& workers) {
  const auto view = tracer::View::create(camera, size_pixels.x, size_pixels.y);
  if (!view) return view.error();
  Imitation made(scene, *view, PictureGrid(camera, *basis_of(camera), size_pixels));
  const SceneDescription& description = scene.description();
  const Bounds seen = bounds_of(scene.geometry());
  for (const description::Light& light : description.lights) {
    auto contents = contents_of(light, seen);
    if (!contents) return contents.error();
    std::move(contents->begin(), contents->end(), std::back_inserter(made.lights_));
  }
  if (!description.environment) return made;
  if (description.environment->source == description::Environment::Source::rendered) {
    auto faces = traced_cube(description, *description.environment, workers);
    if (!faces) return faces.error();
    made.environment_ = EnvironmentLookUp(*std::move(faces));
    return made;
  }
  auto look_up = EnvironmentLookUp::create(description, *description.environment, camera);
  if (!look_up) return look_up.error();
  made.environment_ = *std::move(look_up);
  return made;
}

/// Pixel (i, j) of the 2 x 2 block that a place's pixel belongs to, moved as the place is.
Place Imitation::in_block(const Place& place, int i, int j) const {
  return {.pixel = glm::ivec2((place.pixel.x & ~1) + i, (place.pixel.y & ~1) + j), .offset = place.offset};
}

/// A place's point of the triangle that was hit, with its corners on the grid, or of what continues it beyond its edges.
std::optional<SurfacePoint> Imitation::on_triangle(const Hit& hit, const Place& place) const {
  const auto corners = scene_->geometry().triangle(hit.item);
  if (!corners) return std::nullopt;
  auto weights = grid_.weights_at(*corners, place.at());
  if (!weights) weights = weights_on_plane(*corners, ray(place));
  if (!weights) return std::nullopt;
  Hit beside = hit;
  beside.at = *weights;
  return scene_->geometry().surface(ray(place), beside);
}

/// By the differences within the block: of its upper left pixel for textures; for patterns, whose width is each fragment's own, to the
/// other pixel of the same row and column.
tracer::TextureFootprint Imitation::footprint_in_block(const Place& place, const Hit& hit) const {
  const glm::ivec2 here = has_pattern(hit) ? glm::ivec2(place.pixel.x & 1, place.pixel.y & 1) : glm::ivec2(0);
  const auto in_block_at = [&](int i, int j) { return on_triangle(hit, in_block(place, i, j)); };
  const auto at = in_block_at(here.x, here.y), right = in_block_at(1 - here.x, here.y), down = in_block_at(here.x, 1 - here.y);
  if (!at || !right || !down) return {};
  return {.right = right->texcoord - at->texcoord, .down = down->texcoord - at->texcoord};
}

/// As the tracer has it.
tracer::TextureFootprint Imitation::footprint_of_rays(const Place& place, const SurfacePoint& at) const {
  const auto beside = [&](int x, int y) { return ray({.pixel = place.pixel + glm::ivec2(x, y), .offset = place.offset}); };
  return tracer::footprint_of(at, {.right = beside(1, 0), .down = beside(0, 1)});
}

/// Of the point itself, for pictures that lights throw on it.
tracer::PointFootprint Imitation::steps_between_pixels(const Place& place, const Fragment& fragment, Causes techniques) const {
  if (std::none_of(lights_.begin(), lights_.end(), [](const LightContent& light) { return light.throws_picture; })) return {};
  if (!techniques.has(Cause::mipmap)) return tracer::point_footprint(fragment.at, footprint_of_rays(place, fragment.at));
  const auto in_block_at = [&](int i, int j) { return on_triangle(fragment.hit, in_block(place, i, j)); };
  const auto at = in_block_at(0, 0), right = in_block_at(1, 0), down = in_block_at(0, 1);
  if (!at || !right || !down) return {};
  return {.right = right->position - at->position, .down = down->position - at->position};
}

/// A colour that is computed.
bool Imitation::has_pattern(const Hit& hit) const {
  const description::Material* material = material_of(hit);
  return material != nullptr && material->pattern && material->texture.empty();
}

/// Tangents that take steps of the texture coordinates to steps on the very triangle, not on the surface that it stands for: what
/// fragments of a block differ by.
void Imitation::set_triangle_tangents(SurfacePoint& at, const Hit& hit, const Ray& ray) const {
  const auto corner = [&](const glm::dvec2& weights) {
    Hit moved = hit;
    moved.at = weights;
    return scene_->geometry().surface(ray, moved);
  };
  const SurfacePoint a = corner({0, 0}), b = corner({1, 0}), c = corner({0, 1});
  const glm::dvec3 e1 = b.position - a.position, e2 = c.position - a.position;
  const glm::dvec2 d1 = b.texcoord - a.texcoord, d2 = c.texcoord - a.texcoord;
  const double determinant = d1.x * d2.y - d2.x * d1.y;
  if (determinant == 0) return;
  at.tangent = (d2.y * e1 - d1.y * e2) / determinant;
  at.bitangent = (d1.x * e2 - d2.x * e1) / determinant;
}

Imitation::Fragment Imitation::fragment(const Hit& hit, const SurfacePoint& at, const glm::dvec3& to_eye, const tracer::TextureFootprint& footprint) const {
  Fragment made{.hit = hit, .at = at, .material = scene_->material(hit.item, at, footprint), .normal = {}, .smooth_normal = {}, .to_eye = to_eye};
  const bool is_turned = made.material.two_sided && glm::dot(at.normal, to_eye) < 0;
  made.normal = is_turned ? -made.material.normal : made.material.normal;
  made.smooth_normal = is_turned ? -at.normal : at.normal;
  return made;
}

/// As the pipeline has it at the place: a pattern's steps are those on the very triangle, relief has the surface's tangents.
Imitation::Fragment Imitation::fragment_in_block(const Place& place, const Hit& hit, const SurfacePoint& at, const Ray& ray) const {
  const tracer::TextureFootprint footprint = footprint_in_block(place, hit);
  Fragment made = fragment(hit, at, -ray.direction, footprint);
  if (!has_pattern(hit)) return made;
  SurfacePoint on_triangle = at;
  set_triangle_tangents(on_triangle, hit, ray);
  made.material.reflection = scene_->material(hit.item, on_triangle, footprint).reflection;
  return made;
}

/// Of what casts shadows in the pipeline: all that is not blended.
double Imitation::nearest_caster(const Ray& ray, TraceScratch& scratch) const {
  Ray beyond = ray;
  for (Hit hit = scene_->accelerator().nearest(beyond, scratch.traversal); hit; hit = scene_->accelerator().nearest(beyond, scratch.traversal)) {
    if (scene_->casts_shadow(hit.item) && !is_blended(hit)) return hit.t;
    beyond.t_min = hit.t;
  }
  return tracer::kInfinity;
}

ShareRange Imitation::share_of(const Fragment& fragment, std::size_t light, const tracer::TracedLight& traced, bool by_maps, TraceScratch& scratch) const {
  if (!lights_[light].shadow) return {1, 1};
  const auto nearest = [&](const Ray& ray) { return nearest_caster(ray, scratch); };
  if (by_maps) return lights_[light].shadow->share_at({.position = fragment.at.position, .normal = fragment.smooth_normal, .to_light = traced.to_light}, nearest);
  const double share = std::isfinite(nearest(leaving(fragment.at, traced.to_light, traced.distance))) ? 0 : 1;
  return {share, share};
}

LightRange Imitation::lit_at_fragment(const Place& place, const Fragment& fragment, Causes techniques, TraceScratch& scratch) const {
  LightRange sum = LightRange::of(glm::dvec3(fragment.material.reflection.ambient) * scene_->ambient());
  scratch.lights.clear();
  scene_->lights(fragment.at.position, scratch.lights, steps_between_pixels(place, fragment, techniques));
  const std::vector<tracer::TracedLight> lights = scratch.lights;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const glm::dvec3 sent = reflected(fragment.material, fragment.normal, fragment.to_eye, lights[i]);
    if (largest(sent) > 0) sum.add(share_of(fragment, i, lights[i], techniques.has(Cause::shadow_map), scratch), sent);
  }
  return sum;
}

Ray Imitation::mirrored_ray(const Fragment& fragment) {
  const double off = kOffSurface * std::max(1.0, glm::length(fragment.at.position));
  return {.origin = fragment.at.position + off * fragment.smooth_normal, .direction = mirror_direction(fragment.normal, fragment.to_eye)};
}

/// What a mirror shows.                                                                                     [A 1.4]
glm::dvec3 Imitation::mirrored(const Place& place, const Fragment& fragment, Causes techniques, TraceScratch& scratch) const {
  const auto direction = [](const Fragment& at) { return mirror_direction(at.normal, at.to_eye); };
  const glm::dvec3 R = direction(fragment);
  if (!techniques.has(Cause::mirror_of_surroundings)) {
    const Ray ray = mirrored_ray(fragment);
    if (tracer_.first_hit(ray, scratch)) return tracer_.radiance(ray, scratch);
  } else if (!scene_->description().environment) {
    return glm::dvec3(0);
  }
  if (!techniques.has(Cause::environment_map) || !environment_) return scene_->background(R, false);
  BlockDirections block{R, R, R};
  for (std::size_t i = 0; i < block.size(); ++i) {
    const Place beside = in_block(place, i == 1, i == 2);
    const auto at = on_triangle(fragment.hit, beside);
    if (at) block[i] = direction(this->fragment(fragment.hit, *at, to_eye(ray(beside), at->position), footprint_in_block(place, fragment.hit)));
  }
  return environment_->radiance(R, block);
}

glm::dvec3 Imitation::background(const Place& place, const Ray& ray, Causes techniques) const {
  if (!techniques.has(Cause::environment_map) || !environment_) return scene_->background(ray.direction, true);
  const auto direction = [&](int i, int j) { return this->ray(in_block(place, i, j)).direction; };
  return environment_->radiance(ray.direction, {direction(0, 0), direction(1, 0), direction(0, 1)});
}

/// Of what is not opaque, or clear, the share that goes straight on shows what is behind.
LightRange Imitation::light(const Place& place, const Ray& ray, const Hit& hit, Causes techniques, TraceScratch& scratch, RayFrom from) const {
  if (!hit) return LightRange::of(background(place, ray, techniques));
  const SurfacePoint at = scene_->geometry().surface(ray, hit);
  const tracer::TextureFootprint by_rays = from == RayFrom::eye ? footprint_of_rays(place, at) : tracer::TextureFootprint{};
  const Fragment here = techniques.has(Cause::mipmap) ? fragment_in_block(place, hit, at, ray) : fragment(hit, at, -ray.direction, by_rays);
  if (is_clear(hit) && here.material.refractive_index != 1 && !techniques.has(Cause::transmission)) return LightRange::of(tracer_.radiance(ray, scratch));
  const bool by_vertices = techniques.has(Cause::vertex_shading) && is_lit_at_vertices(hit);
  LightRange light = by_vertices ? lit_at_vertices(place, ray, here, scratch) : lit_at_fragment(place, here, techniques, scratch);
  if (largest(here.material.mirrored) > 0) light.add(here.material.mirrored * mirrored(place, here, techniques, scratch));
  if (here.material.alpha >= 1 && largest(here.material.transmitted) == 0) return light;
  Ray beyond = ray;
  beyond.t_min = hit.t;
  const LightRange behind = this->light(place, beyond, tracer_.first_hit(beyond, scratch), techniques, scratch, is_clear(hit) ? RayFrom::clear_body : from);
  const double alpha = here.material.alpha;
  const glm::dvec3 share = largest(here.material.transmitted) > 0 ? here.material.transmitted : glm::dvec3(1 - alpha);
  return {alpha * light.low + share * behind.low, alpha * light.high + share * behind.high};
}

}  // namespace tuberia::witness
