#pragma once
// A scene as rays ask for it.

#include <memory>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "reference/ray_tracer/accelerators/accelerator.hpp"
#include "reference/ray_tracer/geometry.hpp"
#include "reference/ray_tracer/light_source.hpp"
#include "reference/ray_tracer/surface_material.hpp"
#include "scene/description/scene_description.hpp"
#include "scene/environment/surroundings.hpp"

namespace tuberia::tracer {

/// exact: spheres are spheres, unless they are to have normals of a mesh. tessellated: the same triangles that the pipeline draws, with
/// their normals, of all that has triangles.
enum class SurfaceKind : std::uint8_t { exact, tessellated };

struct TracedSceneOptions {
  SurfaceKind surfaces = SurfaceKind::exact;
  AcceleratorKind accelerator = AcceleratorKind::bvh;
  AcceleratorSettings accelerator_settings{};
  double time = 0;                     // 0..1: how far its camera has moved, for texture levels by distance
};

class TracedScene {
 public:
  /// Errors: files that cannot be read, shapes and cameras that are none, constants out of range (set by hand, since scene files
  /// refuse them). They name the object, texture, material or light.
  static Result<TracedScene> create(SceneDescription scene, Workers& workers, const TracedSceneOptions& options = {});

  const SceneDescription& description() const noexcept { return scene_; }
  const Geometry& geometry() const noexcept { return *geometry_; }
  const Accelerator& accelerator() const noexcept { return *accelerator_; }
  /// What was repaired or left out in the files that were read.
  const std::vector<std::string>& warnings() const noexcept { return warnings_; }

  int object_of(std::int64_t item) const noexcept { return part(item).object; }  // its index in the description
  bool casts_shadow(std::int64_t item) const noexcept { return scene_.objects[static_cast<std::size_t>(object_of(item))].casts_shadow; }
  bool lets_light_through(std::int64_t item) const noexcept { return part(item).material.lets_light_through(); }  // kt > 0, alpha < 1 or cut out somewhere
  /// The ray goes on behind what it has met: other objects at the same distance come next, in the order of the description.
  void go_on_behind(const Hit& hit, Ray& ray) const noexcept {
    ray.t_min = hit.t;
    ray.first_item_at_t_min = end_of_object_[static_cast<std::size_t>(object_of(hit.item))];
  }
  /// Everything casts shadows, and all of it is opaque: then anything in a light's way stops all of it.
  bool has_only_opaque_casters() const noexcept { return has_only_opaque_casters_; }

  PointMaterial material(std::int64_t item, const SurfacePoint& at, const TextureFootprint& footprint = {}) const noexcept {
    return part(item).material.at(at, footprint);
  }
  /// What lights a point, whatever stands in the way: lights below the surface, too, and those that send nothing there. Appends.
  /// footprint: for the level at which pictures that lights throw are read.
  void lights(const glm::dvec3& point, std::vector<TracedLight>& out, const PointFootprint& footprint = {}) const {
    for (const LightSource& source : lights_) out.push_back(source.at(point, footprint));
  }
  /// What comes from a direction where nothing is.                                  [A 2.3] "background by direction"
  glm::dvec3 background(const glm::dvec3& direction, bool seen_directly) const noexcept;
  glm::dvec3 ambient() const noexcept { return scene_.ambient; }  // Ia

 private:
  /// What has one material.
  struct Part {
    SurfaceMaterial material;
    int object;
  };
  friend class TracedSceneBuilder;

  TracedScene() = default;
  const Part& part(std::int64_t item) const noexcept { return parts_[static_cast<std::size_t>(geometry_->part_of(item))]; }

  SceneDescription scene_;
  std::unique_ptr<Geometry> geometry_;
  std::vector<Part> parts_;
  std::vector<std::int64_t> end_of_object_;  // the item after its last
  std::vector<LightSource> lights_;
  Surroundings surroundings_;  // without a radiance: nothing but the picture's background
  std::unique_ptr<Accelerator> accelerator_;
  std::vector<std::string> warnings_;
  bool has_only_opaque_casters_ = true;
};

}  // namespace tuberia::tracer
