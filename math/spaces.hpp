#pragma once
// The spaces a vertex passes through, each a type of its own, so that mixing two up cannot compile.
// Space by space: docs/conventions.md.

#include <glm/vec3.hpp>

namespace tuberia {

/// A position in the mesh's own space, world units.
struct ObjectPosition {
  glm::vec3 value{0.0f};
  bool operator==(const ObjectPosition&) const = default;
};

/// A position in the right-handed world, world units.
struct WorldPosition {
  glm::vec3 value{0.0f};
  bool operator==(const WorldPosition&) const = default;
};

/// A position seen from the eye: x right, y up, the camera looks along -z; world units.
struct ViewPosition {
  glm::vec3 value{0.0f};
  bool operator==(const ViewPosition&) const = default;
};

/// Homogeneous position before the division; inside the volume when -w <= x, y <= w and z agrees
/// with the ClipVolume.
struct ClipPosition {
  float x = 0, y = 0, z = 0, w = 1;
  bool operator==(const ClipPosition&) const = default;
};

/// Normalized device coordinates: the visible x and y are -1..1, y up; z by the ClipVolume.
struct NdcPosition {
  float x = 0, y = 0, z = 0;
  bool operator==(const NdcPosition&) const = default;
};

/// Pixels from the upper left corner of the target, y down, pixel centres at +0.5; depth by the
/// DepthRange.
struct ScreenPosition {
  float x = 0, y = 0, depth = 0;
  bool operator==(const ScreenPosition&) const = default;
};

/// The part of the target that ndc -1..1 maps to. x, y: its upper left corner, pixels, any sign.
struct Viewport {
  int x = 0, y = 0, width_pixels = 0, height_pixels = 0;
  bool operator==(const Viewport&) const = default;
};

/// The depths that the two ends of the clip volume map to; near_depth may be the larger one.
struct DepthRange {
  float near_depth = 0, far_depth = 1;
  bool operator==(const DepthRange&) const = default;
};

/// Which z are inside: the course notes' (and OpenGL's) -w <= z <= w, or Direct3D's 0 <= z <= w.
enum class ClipVolume { minus_w_to_w, zero_to_w };

/// The perspective division [C 3.8]. w must not be 0; the clipper leaves only w > 0.
inline NdcPosition divide(const ClipPosition& position) noexcept {
  return {position.x / position.w, position.y / position.w, position.z / position.w};
}

/// Maps ndc to the target: ndc (-1, 1) to the viewport's upper left corner, (1, -1) to its lower
/// right one. Depth is not clamped. In float, for reference: the pipeline's
/// PerspectiveDivide computes the same in double and rounds once.
inline ScreenPosition screen_from_ndc(const NdcPosition& ndc, const Viewport& viewport,
                                      const DepthRange& range, ClipVolume volume) noexcept {
  const float half_width = 0.5f * static_cast<float>(viewport.width_pixels);
  const float half_height = 0.5f * static_cast<float>(viewport.height_pixels);
  const float unit_depth = volume == ClipVolume::minus_w_to_w ? (ndc.z + 1.0f) * 0.5f : ndc.z;
  return {.x = (ndc.x + 1.0f) * half_width + static_cast<float>(viewport.x),
          .y = (1.0f - ndc.y) * half_height + static_cast<float>(viewport.y),
          .depth = unit_depth * (range.far_depth - range.near_depth) + range.near_depth};
}

/// A position in the course notes' own frame: pixel centres at integers, y up.
struct NotesFramePosition {
  float x = 0, y = 0;
  bool operator==(const NotesFramePosition&) const = default;
};

/// The viewport transform as the notes print it [C 3.5]: width_pixels x height_pixels pixels span
/// [-0.5, width - 0.5] x [-0.5, height - 0.5]. The same lattice as screen space, shifted by half a
/// pixel and flipped; for comparisons with the notes, the pipeline does not use it.
inline NotesFramePosition notes_frame_from_ndc(const NdcPosition& ndc, int width_pixels,
                                               int height_pixels) noexcept {
  const float width = static_cast<float>(width_pixels), height = static_cast<float>(height_pixels);
  return {.x = ndc.x * (0.5f * width) + 0.5f * (width - 1.0f),
          .y = ndc.y * (0.5f * height) + 0.5f * (height - 1.0f)};
}

}  // namespace tuberia
