#pragma once
// A ray in floats that says what the ray it stands for cannot meet.

#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>

namespace tuberia::tracer {

/// A little more than a number that was rounded a few times.
inline float beyond(float rounded) noexcept { return rounded + std::abs(rounded) * 0x1p-21f; }

/// Most often the very ray that is asked. A direction that is very long or short is scaled by a power of two; where the
/// origin is far from all triangles, it has been moved along the ray, so that floats are fine enough to tell triangles apart.
struct FilterRay {
  glm::vec3 origin, direction;
  float furthest;   // no triangle's corner is further from the origin along any axis
  float misplaced;  // nor is the origin from the ray

  // A box is met where (enter - its near plane) * minus_inverse is less than the same of leave and its far plane. Both are the
  // origin, moved apart by more than all roundings of a box's test. [Woop]
  float enter[3], leave[3], minus_inverse[3];
  std::size_t near_plane[3], far_plane[3];  // where they begin among WideNode's planes

  float t_min, t_max;                // with room for rounding
  double t_offset = 0, t_scale = 1;  // t here is (t of the ray - t_offset) * t_scale
  float t_error = 0;                 // by which it may be off because the origin was rounded

  /// What is further than this cannot be nearer than t of the ray, and the other way round.
  float latest(double t) const noexcept {
    return beyond(t_of(t)) + t_error;
  }
  float earliest(double t) const noexcept {
    return -beyond(-t_of(t)) - t_error;
  }

 private:
  float t_of(double t) const noexcept { return static_cast<float>((t - t_offset) * t_scale); }
};

/// The same ray for triangles: corners are moved and sheared so that it is the z axis, z being where the direction is longest. [Woop]
struct ShearedRay {
  int axis[3];      // x, y, z
  float origin[3];  // in this order
  float shear_x, shear_y, inverse_z;
  // Twice the area of the ray and a triangle's edge, as seen along the ray, is off by less than
  // area_error + area_error_of_size * the size of the triangle.
  float area_error, area_error_of_size;
};

}  // namespace tuberia::tracer
