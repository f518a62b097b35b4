#pragma once
// The pipeline's documented techniques in double precision on the tracer's own scene: what its ray would bring if
// some of what sets the two apart were the same.                          docs/conventions.md, docs/surfaces.md

#include <glm/vec2.hpp>
#include <optional>
#include <vector>

#include "examples/tuberia/witness/environment_look_up.hpp"
#include "examples/tuberia/witness/light_range.hpp"
#include "examples/tuberia/witness/picture_grid.hpp"
#include "examples/tuberia/witness/retraced_shadow.hpp"
#include "examples/tuberia/witness/verdict.hpp"
#include "reference/ray_tracer/ray_tracer.hpp"
#include "reference/ray_tracer/viewing.hpp"

namespace tuberia::witness {

/// A place of the picture: a little beside a pixel's centre.
struct Place {
  glm::ivec2 pixel{0};
  glm::dvec2 offset{0};  // pixels

  glm::dvec2 at() const { return glm::dvec2(pixel) + 0.5 + offset; }
};

/// Only what the eye sees straight has neighbours: rays through clear bodies read textures at their finest.
enum class RayFrom : std::uint8_t { eye, clear_body };

class Imitation {
 public:
  /// scene must outlive it. Errors: of the lights' views and pictures, and of the environment's.
  static Result<Imitation> create(const tracer::TracedScene& scene, const Camera& camera, const glm::ivec2& size_pixels, Workers& workers);

  tracer::Ray ray(const Place& place) const { return view_.ray(place.at(), true); }

  /// Which techniques might matter to what the ray of a place meets, or to the background.
  Causes techniques_of(const Place& place, const tracer::Ray& ray, const tracer::Hit& hit, tracer::TraceScratch& scratch) const;

  /// Light goes through and on.
  bool is_clear(const tracer::Hit& hit) const;

  /// What the ray of a place that meets `hit` brings, with these of the techniques; edges and depths are up to the caller.
  LightRange light(const Place& place, const tracer::Ray& ray, const tracer::Hit& hit, Causes techniques, tracer::TraceScratch& scratch,
                   RayFrom from = RayFrom::eye) const;

 private:
  /// A point of a triangle, lit or not.
  struct Fragment {
    tracer::Hit hit;
    tracer::SurfacePoint at;
    tracer::PointMaterial material;
    glm::dvec3 normal, smooth_normal, to_eye;
  };
  Imitation(const tracer::TracedScene& scene, const tracer::View& view, const PictureGrid& grid) : scene_(&scene), tracer_(scene), view_(view), grid_(grid) {}

  bool is_lit_at_vertices(const tracer::Hit& hit) const;
  bool is_drawn_otherwise(const Fragment& fragment, tracer::TraceScratch& scratch) const;
  bool has_clear_caster(const Fragment& fragment, tracer::TraceScratch& scratch) const;
  bool mirrors_object(const Fragment& fragment, tracer::TraceScratch& scratch) const;
  static tracer::Ray mirrored_ray(const Fragment& fragment);
  Place in_block(const Place& place, int i, int j) const;
  std::optional<tracer::SurfacePoint> on_triangle(const tracer::Hit& hit, const Place& place) const;
  glm::dvec3 to_eye(const tracer::Ray& ray, const glm::dvec3& point) const;
  tracer::TextureFootprint footprint_in_block(const Place& place, const tracer::Hit& hit) const;
  tracer::PointFootprint steps_between_pixels(const Place& place, const Fragment& fragment, Causes techniques) const;
  tracer::TextureFootprint footprint_of_rays(const Place& place, const tracer::SurfacePoint& at) const;
  const description::Material* material_of(const tracer::Hit& hit) const;
  bool is_blended(const tracer::Hit& hit) const;
  bool has_pattern(const tracer::Hit& hit) const;
  bool has_texture(const tracer::Hit& hit) const;
  void set_triangle_tangents(tracer::SurfacePoint& at, const tracer::Hit& hit, const tracer::Ray& ray) const;
  Fragment fragment(const tracer::Hit& hit, const tracer::SurfacePoint& at, const glm::dvec3& to_eye, const tracer::TextureFootprint& footprint) const;

  Fragment fragment_in_block(const Place& place, const tracer::Hit& hit, const tracer::SurfacePoint& at, const tracer::Ray& ray) const;
  LightRange lit_at_fragment(const Place& place, const Fragment& fragment, Causes techniques, tracer::TraceScratch& scratch) const;
  ShareRange share_of(const Fragment& fragment, std::size_t light, const tracer::TracedLight& traced, bool by_maps, tracer::TraceScratch& scratch) const;
  double nearest_caster(const tracer::Ray& ray, tracer::TraceScratch& scratch) const;
  LightRange lit_at_vertices(const Place& place, const tracer::Ray& ray, const Fragment& here, tracer::TraceScratch& scratch) const;
  Fragment without_texture(Fragment fragment) const;
  glm::dvec3 texel_of(const Fragment& fragment) const;
  LightRange lit_by_cosines(const tracer::Hit& hit, const std::vector<Fragment>& corners, tracer::TraceScratch& scratch) const;
  glm::dvec3 mirrored(const Place& place, const Fragment& fragment, Causes techniques, tracer::TraceScratch& scratch) const;
  glm::dvec3 background(const Place& place, const tracer::Ray& ray, Causes techniques) const;

  const tracer::TracedScene* scene_;
  tracer::RayTracer tracer_;
  tracer::View view_;
  PictureGrid grid_;
  /// What is known of one of the tracer's lights.
  struct LightContent {
    glm::dvec3 intensity;  // without falloff, cone and picture
    std::optional<RetracedShadow> shadow{};
    bool throws_picture = false;
  };
  static Result<std::vector<LightContent>> contents_of(const description::Light& light, const Bounds& seen);

  std::vector<LightContent> lights_;  // in the tracer's order
  std::optional<EnvironmentLookUp> environment_;
};

}  // namespace tuberia::witness
