#pragma once
// The observer of a scene, and the picture that it takes.                            [C 1.2, 2.1, 2.6]

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace tuberia::description {

/// What a camera does while the time runs from 0 to 1, see docs/conventions.md and [C 2.8]. Only the
/// amounts of its kind count.
struct CameraMotion {
  enum class Kind : std::uint8_t { pan, dolly, zoom, orbit, turn };
  Kind kind = Kind::orbit;
  double right = 0, up = 0;                    // pan: world units along the camera's own axes
  double distance = 0;                         // dolly: world units towards the point of interest
  double factor = 1;                           // zoom by the field, > 0: how many times larger things appear
  double right_degrees = 0, up_degrees = 0;    // orbit: of the eye around the point of interest
  bool inspection = false;                     // orbit: the other senses, as if the object were turned
  double pitch_degrees = 0, yaw_degrees = 0, roll_degrees = 0;  // turn: up, left, counter-clockwise
  bool operator==(const CameraMotion&) const = default;
};

/// World space and world units.
struct Camera {
  enum class Kind : std::uint8_t { perspective, orthographic };
  Kind kind = Kind::perspective;
  glm::dvec3 eye{0, 0, 5}, look_at{0, 0, 0}, up{0, 1, 0};
  double fovy_degrees = 40;  // of a perspective: the vertical opening, inside (0, 180)
  double height = 4;         // of a parallel view: what the picture's height shows, > 0
  double near_distance = 0.1, far_distance = 100;  // 0 < near < far
  std::vector<CameraMotion> motions;               // one after the other, each from the axes that the last one left
  bool operator==(const Camera&) const = default;
};

/// What becomes of intensities above 1: cut off; the whole picture divided by its largest; or each
/// pixel divided by its largest channel.                                             [B 2.8, 2.9]
enum class Overflow : std::uint8_t { clamp, global_scale, hue_preserving };

struct Picture {
  int width = 640, height = 480;   // pixels
  int supersampling = 1;           // samples each way for every pixel, whose mean it is
  glm::vec3 background{0};         // linear RGB, where there is neither an object nor an environment
  double exposure_stops = 0;       // all intensities times 2 to this power, before they overflow
  Overflow overflow = Overflow::clamp;
  bool operator==(const Picture&) const = default;
};

}  // namespace tuberia::description
