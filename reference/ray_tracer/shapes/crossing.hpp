#pragma once
// Rays through convex bodies.                                                            [B 5.6] [C]

#include <optional>

#include "reference/ray_tracer/ray.hpp"

namespace tuberia::tracer {

/// The part of a line inside a convex body, from t = enter to leave, and the faces that it passes there. Cut with one
/// half-space after another it has no gaps at the edges between faces, whatever is rounded.
struct Crossing {
  double enter = -kInfinity, leave = kInfinity;
  int enter_face = 0, leave_face = 0;

  void begin_at(double t, int face) noexcept {
    if (t > enter) enter = t, enter_face = face;
  }
  void end_at(double t, int face) noexcept {
    if (t < leave) leave = t, leave_face = face;
  }
  /// The half-space height(t) = height + t * rate <= 0.
  void cut(double height, double rate, int face) noexcept {
    if (rate < 0)
      begin_at(-height / rate, face);
    else if (rate > 0)
      end_at(-height / rate, face);
    else if (height > 0)
      leave = -kInfinity;
  }
};

/// Whether t is met by the ray's own bounds; nothing that is NaN or infinite is.
inline bool is_within(const Ray& ray, double t) noexcept { return t > ray.t_min && t < ray.t_max && t < kInfinity && t > -kInfinity; }

/// The first of both ends that the ray accepts.
inline std::optional<ShapeHit> first_end(const Crossing& crossing, const Ray& ray) noexcept {
  if (!(crossing.enter <= crossing.leave)) return std::nullopt;
  if (is_within(ray, crossing.enter)) return ShapeHit{.t = crossing.enter, .face = crossing.enter_face};
  if (is_within(ray, crossing.leave)) return ShapeHit{.t = crossing.leave, .face = crossing.leave_face};
  return std::nullopt;
}

}  // namespace tuberia::tracer
