#pragma once
// Light that goes through bodies without being bent: the shadows of what transmits.                   [B 4.4, 5.9]

#include <vector>

#include "reference/ray_tracer/traced_scene.hpp"

namespace tuberia::tracer {

/// The bodies that a shadow ray is inside of, as it goes from surface to surface. Whether what it comes into, or starts behind, is
/// a body or a sheet shows only when it comes out again: a sheet has no inside.
class BodiesOnTheWay {
 public:
  void clear() noexcept { bodies_.clear(); }

  /// The ray starts at the back of a surface that transmits, t = 0: in a body, or on the other side of a sheet.
  void start_behind(const PointMaterial& material, int object);

  /// What a surface that transmits leaves of the light: kt where the ray comes into the body, exp(-shadow_density path) where it
  /// goes out, and both where it goes out of the one that it started in. A sheet met from behind takes kt.
  /// t: along the ray.   object: the body's number.
  glm::dvec3 share(const PointMaterial& material, int object, double t, bool comes_in);

  /// Whether what lies beyond the light matters: the ray has come there without leaving something that absorbs.
  bool may_absorb() const noexcept;
  /// The ray, followed beyond the light, meets a surface. exp(-shadow_density path) up to the light if it leaves a body that the light
  /// is in, kt having been taken at the body's surface if light came through it; else 1.
  double share_around_light(int object, double t_light, bool leaves);

 private:
  struct Body {
    int object;
    double from;      // the t where the ray came in
    double density;
    bool owes_kt;     // the ray started in it
  };
  std::vector<Body>::iterator last_of(int object);

  std::vector<Body> bodies_;
};

}  // namespace tuberia::tracer
