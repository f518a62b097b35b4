#pragma once
// Why a pixel differs: hypotheses, tested one after the other at the pixel itself.

#include <vector>

#include "examples/tuberia/witness/imitation.hpp"
#include "image/image.hpp"
#include "scene/description/camera.hpp"

namespace tuberia::witness {

/// Within this distance of a pixel's centre an edge explains: corners are rounded to 1/256 pixel each way, which moves edges by
/// up to 0.71/256; float matrices move them by up to 0.25/256 in pictures of 1,000 pixels (picture_grid_test).     [rules Y5]
inline constexpr double kEdgeDistance = 2.0 / 256;

/// Depths of a d32f buffer, 0..1, that it may not tell apart: four steps of a float next to 1.
inline constexpr double kDepthQuantum = 0x1p-22;

/// A channel that differs by no more counts as equal, sRGB codes of 255.
inline constexpr int kToleratedCodes = 1;

/// What a pixel shows in the pipeline's picture.
struct DrawnPixel {
  Rgba8 colour;
  int object = -1;
};

/// From light to codes, as develop.hpp has it.
struct Development {
  double factor = 1;  // of exposure and global scale
  description::Overflow overflow = description::Overflow::clamp;

  Rgba8 code(const glm::dvec3& light) const;
  /// Whether the colour lies between the bounds, give or take kToleratedCodes.
  bool may_be(const Rgba8& colour, const LightRange& light) const;
};

class Explaining {
 public:
  /// Both must outlive it.
  Explaining(const Imitation& imitation, const tracer::RayTracer& tracer, const Camera& camera, const Development& development)
      : imitation_(imitation), tracer_(tracer), camera_(camera), development_(development) {}

  /// Of a pixel that differs: the causes that give what was drawn. Techniques, which leave hardly any room, come before edges and
  /// depths; of each the fewest.
  PixelVerdict verdict(const glm::ivec2& pixel, const DrawnPixel& drawn, tracer::TraceScratch& scratch) const;

 private:
  /// Where a ray near the pixel's centre meets something.
  struct Sight {
    Place place;
    tracer::Ray ray;
    tracer::Hit hit;
  };
  using Sights = std::vector<Sight>;

  Sight nearest(const Place& place, tracer::TraceScratch& scratch) const;
  Sights around(const glm::ivec2& pixel, tracer::TraceScratch& scratch) const;
  void add_behind(Sights& sights, tracer::TraceScratch& scratch) const;
  double depth_of(const Sight& sight) const;
  int object_of(const Sight& sight) const;
  Causes techniques_along(Sight sight, tracer::TraceScratch& scratch) const;
  LightRange light(const Sight& sight, Causes techniques, tracer::TraceScratch& scratch) const;
  bool is_told_truly(const Sight& sight, tracer::TraceScratch& scratch) const;
  bool gives(const DrawnPixel& drawn, const Sights& sights, Causes techniques, tracer::TraceScratch& scratch) const;

  const Imitation& imitation_;
  const tracer::RayTracer& tracer_;
  const Camera& camera_;
  Development development_;
};

}  // namespace tuberia::witness
