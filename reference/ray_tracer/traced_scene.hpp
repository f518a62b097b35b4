#pragma once
// A scene as rays ask for it.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "math/reflection.hpp"
#include "reference/ray_tracer/accelerators/accelerator.hpp"
#include "reference/ray_tracer/geometry.hpp"
#include "scene/description/scene_description.hpp"

namespace tuberia::tracer {

/// The material at a point of a surface, patterns and textures looked up.                    [A 2.2] [B 5-2]
struct PointMaterial {
  ReflectionConstants reflection;      // ka, kd (pattern and texture in it), ks, ...
  glm::dvec3 normal{0, 0, 1};          // outwards, the relief in it; unit
  glm::dvec3 mirrored{0};              // kr (the notes' kps, too): times what comes from the mirror direction
  glm::dvec3 transmitted{0};           // kt: times what comes from the refracted direction
  double refractive_index = 1;         // inside, against 1 outside
  double shadow_density = 0;           // per world unit: light that goes straight through is multiplied by exp(-density * path)
  double alpha = 1;                    // opacity; below 1 what lies straight behind shows through
  bool is_cut_out = false;             // a hole here: the ray goes on as if there were nothing
  bool two_sided = false;              // the side that faces the eye is lit; always so where kt > 0
};

/// How far texture coordinates move from one pixel to the next, to the right and down; 0: unknown, the finest level is read.
struct TextureFootprint {
  glm::dvec2 right{0}, down{0};
};

/// A point or direction that light comes from; areas are several.                                    [B 2.5]
struct TracedLight {
  glm::dvec3 to_light{0, 1, 0};        // unit, from the point that is lit
  double distance = kInfinity;
  glm::dvec3 intensity{1};             // what arrives, falloff, cone and projection in it
  bool casts_shadows = true;
};

/// exact: spheres are spheres. tessellated: the same triangles that the pipeline draws, with their normals.
enum class SurfaceKind : std::uint8_t { exact, tessellated };

struct TracedSceneOptions {
  SurfaceKind surfaces = SurfaceKind::exact;
  AcceleratorKind accelerator = AcceleratorKind::bvh;
  AcceleratorSettings accelerator_settings{};
};

class TracedScene {
 public:
  /// Errors: files that cannot be read, shapes and cameras that are none, constants out of range (set by hand, since scene files
  /// refuse them). They name the object, texture, material or light.
  static Result<TracedScene> create(SceneDescription scene, Workers& workers, const TracedSceneOptions& options = {});

  const SceneDescription& description() const noexcept;
  const Geometry& geometry() const noexcept;
  const Accelerator& accelerator() const noexcept;
  const std::vector<std::string>& warnings() const noexcept;

  int object_of(std::int64_t item) const noexcept;         // its index in the description
  bool casts_shadow(std::int64_t item) const noexcept;
  bool lets_light_through(std::int64_t item) const noexcept;  // kt > 0, alpha < 1 or cut out somewhere
  bool has_only_opaque_casters() const noexcept;           // then anything in a light's way stops all of it

  PointMaterial material(std::int64_t item, const SurfacePoint& at, const TextureFootprint& footprint = {}) const noexcept;
  /// What lights a point, whatever stands in the way: lights below the surface, too. Appends.
  void lights(const glm::dvec3& point, std::vector<TracedLight>& out) const;
  /// What comes from a direction where nothing is.                                  [A 2.3] "background by direction"
  glm::dvec3 background(const glm::dvec3& direction, bool seen_directly) const noexcept;
  glm::dvec3 ambient() const noexcept;                     // Ia
};

}  // namespace tuberia::tracer
