#pragma once
// The six faces of a cube map, drawn by the pipeline itself from a point of a scene.   [A 1.4] [B 4.1.3]

#include <functional>

#include "base/result.hpp"
#include "math/camera.hpp"
#include "pipeline/pipeline.hpp"
#include "scene/environment/surroundings.hpp"

namespace tuberia {

/// How the faces are drawn.
struct CubeView {
  glm::dvec3 eye{0, 0, 0};                             // world space
  int size_pixels = 256;                               // of each face, both ways
  double near_distance = 0.05, far_distance = 1000;    // as of ViewVolume
  ClipVolume clip_volume = ClipVolume::minus_w_to_w;
  bool reversed_depth = false;
  int samples = 1;                                     // a pixel, as of RenderTargetDescription
  Rgba32F background{0, 0, 0, 1};
};

/// The camera that looks through a face 0..5 (+x, -x, +y, -y, +z, -z): 90 degrees each way. Its picture is
/// the face's mirrored left to right, since faces are arranged as seen from outside the cube and a camera
/// looks from within (raster/cube_map.hpp).
Camera cube_face_camera(const CubeView& view, int face) noexcept;

/// Draws a scene into a cleared target, as seen by a camera.
using DrawScene = std::function<Result<Nothing>(Pipeline& pipeline, RenderTarget& target, const Camera& camera)>;

/// The faces of a cube map around the eye, linear intensities as drawn, neither clamped nor rounded.
/// Errors: a size or number of samples that targets cannot have, a volume that cameras cannot have, and the
/// scene's own, naming the face.
Result<CubeImages> render_cube(Pipeline& pipeline, const CubeView& view, const DrawScene& draw_scene);

}  // namespace tuberia
