#pragma once
// What surfaces are made of, point by point.                                         [A 2.2] [B 4, 5-2]

#include <functional>
#include <memory>
#include <optional>

#include "math/patterns.hpp"
#include "math/reflection.hpp"
#include "reference/ray_tracer/ray.hpp"
#include "reference/ray_tracer/texture_lookup.hpp"
#include "scene/description/material.hpp"

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

/// Texture coordinates by the direction of a point from the middle of its object.               [B 4-2..4-5]
struct GlobeMapping {
  glm::dmat4 object_from_world{1};
  std::function<glm::dvec2(const glm::dvec3& position, const glm::dvec3& normal)> coordinates;  // object space; v upwards
};

/// The material of a part of an object, its textures read.
class SurfaceMaterial {
 public:
  /// The pictures that a material names or a model brings; null: there is none.
  struct Pictures {
    std::shared_ptr<const TextureLookup> colour, relief;
    std::optional<double> texel_distance{};  // of colour: its level is that of the distance from the eye [A 1.1]
    double alpha_cutoff = 0;                 // where its alpha is less there is a hole
  };

  /// eye: world space, for levels by distance.
  SurfaceMaterial(const description::Material& material, Pictures pictures, const glm::dvec3& eye);

  /// For surfaces whose points have their own coordinates, without the material's mapping: meshes have it in them.
  void set_repeat(const glm::dvec2& repeat) noexcept { repeat_ = repeat; }
  void set_globe(GlobeMapping globe) { globe_ = std::move(globe); }

  PointMaterial at(const SurfacePoint& point, const TextureFootprint& footprint) const noexcept;
  bool lets_light_through() const noexcept;

 private:
  /// Coordinates, tangents and footprint that pictures and relief go by.
  struct Place {
    glm::dvec2 uv;
    glm::dvec3 tangent, bitangent;
    TextureFootprint footprint;
    PointFootprint steps;
  };

  Place place_of(const SurfacePoint& point, const TextureFootprint& footprint) const noexcept;
  Place place_on_globe(const SurfacePoint& point, Place place) const noexcept;
  glm::dvec4 own_colour(const SurfacePoint& point, const Place& place) const noexcept;
  glm::dvec3 pattern_colour_at(const SurfacePoint& point, const Place& place) const noexcept;
  glm::dvec3 normal_at(const SurfacePoint& point, const Place& place) const noexcept;
  glm::dvec2 slope_at(const Place& place) const noexcept;

  description::Material material_;
  ReflectionConstants constants_;
  Pattern pattern_;
  Pictures pictures_;
  glm::dvec3 eye_;
  glm::dvec2 repeat_{1, 1};
  std::optional<GlobeMapping> globe_;
};

}  // namespace tuberia::tracer
