#include "scene/environment/render_cube.hpp"

#include <algorithm>
#include <string>

#include "scene/environment/directions.hpp"
#include "scene/environment/read_environment.hpp"

namespace tuberia {
namespace {

Image<Rgba32F> mirrored_left_to_right(Image<Rgba32F> image) {
  for (int y = 0; y < image.height(); ++y) std::reverse(image.row(y).begin(), image.row(y).end());
  return image;
}

Result<Image<Rgba32F>> render_face(Pipeline& pipeline, const CubeView& view, int face, const DrawScene& draw_scene) {
  auto target = RenderTarget::create({.width = view.size_pixels, .height = view.size_pixels, .colour = ColourFormat::rgba32f, .samples = view.samples});
  if (!target) return target.error();
  const Camera camera = cube_face_camera(view, face);
  if (auto matrices = camera_matrices(camera); !matrices) return matrices.error();
  pipeline.clear(*target, view.background, view.reversed_depth ? 0.0f : 1.0f);
  if (auto drawn = draw_scene(pipeline, *target, camera); !drawn) return drawn.error();
  return mirrored_left_to_right(target->linear_image());
}

}  // namespace

Camera cube_face_camera(const CubeView& view, int face) noexcept {
  const glm::dvec3 middle = cube_face_direction({face, {0.5, 0.5}});
  const glm::dvec3 up = cube_face_direction({face, {0.5, 0.0}}) - middle;  // t runs down
  const double half = view.near_distance;                                   // tan(45 degrees) = 1
  return {.eye = view.eye, .point_of_interest = view.eye + middle, .up = up,
          .view = {.left = -half, .right = half, .bottom = -half, .top = half, .near_distance = view.near_distance, .far_distance = view.far_distance},
          .clip_volume = view.clip_volume, .reversed_depth = view.reversed_depth};
}

Result<CubeImages> render_cube(Pipeline& pipeline, const CubeView& view, const DrawScene& draw_scene) {
  CubeImages faces;
  for (int face = 0; face < 6; ++face) {
    auto image = render_face(pipeline, view, face, draw_scene);
    if (!image) return Error{"face " + std::string(cube_face_name(face)) + ": " + image.error().message};
    faces[static_cast<std::size_t>(face)] = std::move(*image);
  }
  return faces;
}

}  // namespace tuberia
