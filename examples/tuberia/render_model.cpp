#include "examples/tuberia/render_model.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <glm/geometric.hpp>
#include <cmath>
#include <numbers>

namespace tuberia::cli {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

glm::dvec3 vector_of(const std::vector<double>& v) { return {v[0], v[1], v[2]}; }

/// Turns the model's upward axis to the world's, y.
glm::mat4 world_from_object_of(const std::string& up_axis) {
  constexpr double kQuarter = std::numbers::pi / 2;
  if (up_axis == "x") return rotation({0, 0, 1}, kQuarter);
  if (up_axis == "-x") return rotation({0, 0, 1}, -kQuarter);
  if (up_axis == "z") return rotation({1, 0, 0}, -kQuarter);
  if (up_axis == "-z") return rotation({1, 0, 0}, kQuarter);
  if (up_axis == "-y") return rotation({0, 0, 1}, 2 * kQuarter);
  return glm::mat4(1.0f);
}

/// The sphere around the middle of the bounds that holds all vertices, in world space.
Framing framing_of(const Model& model, const glm::mat4& world_from_object) {
  const glm::vec3 centre = model.bounds().centre();
  double radius = 0;
  for (const Mesh& mesh : model.meshes)
    for (const glm::vec3& position : mesh.positions)
      radius = std::max(radius, static_cast<double>(glm::distance(position, centre)));
  Framing frame;
  frame.centre = glm::dvec3(world_from_object * glm::vec4(centre, 1));
  frame.radius = radius > 0 ? radius : 1;
  return frame;
}

/// The whole model in view, or the eye where it was put.
Result<Camera> camera_for(const Model& model, const glm::mat4& world_from_object, const RenderOptions& options) {
  const CameraOptions& wish = options.camera;
  Framing frame = framing_of(model, world_from_object);
  frame.azimuth_degrees = wish.azimuth_degrees;
  frame.elevation_degrees = wish.elevation_degrees;
  frame.fovy_radians = wish.fovy_degrees * kRadiansPerDegree;
  frame.aspect = static_cast<double>(options.width_pixels) / options.height_pixels;
  if (options.reversed_depth) frame.clip_volume = ClipVolume::zero_to_w;
  auto camera = framing(frame);
  if (!camera) return camera;
  camera->reversed_depth = options.reversed_depth;
  if (!wish.look_at.empty()) camera->point_of_interest = vector_of(wish.look_at);
  if (!wish.eye.empty()) {
    camera->eye = vector_of(wish.eye);
    camera->up = vector_of(wish.up);
  }

  // The window follows the distance; near and far keep the model between them.
  const double distance = glm::length(camera->eye - camera->point_of_interest);
  const double reach = glm::length(camera->point_of_interest - frame.centre) + frame.radius;
  const double far = distance + reach * 1.01;
  const double near = wish.near_distance > 0 ? wish.near_distance : std::max(distance - reach * 1.01, far * 1e-3);
  const double half_height = std::tan(frame.fovy_radians / 2) / wish.zoom * (wish.orthographic ? distance : near);
  camera->projection = wish.orthographic ? Projection::orthographic : Projection::perspective;
  camera->view = {.left = -half_height * frame.aspect, .right = half_height * frame.aspect, .bottom = -half_height,
                  .top = half_height, .near_distance = near, .far_distance = far};
  return camera;
}

double seconds_of(const std::vector<double>& times) {
  std::vector<double> sorted = times;
  std::sort(sorted.begin(), sorted.end());
  return sorted[sorted.size() / 2];
}

}  // namespace

Result<ModelScene> place(const Model& model, const RenderOptions& options) {
  const glm::mat4 world_from_object = world_from_object_of(options.camera.up_axis);
  const auto camera = camera_for(model, world_from_object, options);
  if (!camera) return Error{"camera: " + camera.error().message};
  const auto matrices = camera_matrices(*camera);
  if (!matrices) return Error{"camera: " + matrices.error().message};
  const auto drawable = DrawableModel::create(model);
  if (!drawable) return drawable.error();
  const ModelView view{.world_from_object = world_from_object, .camera = *matrices, .eye = glm::vec3(camera->eye), .shading = options.shading,
                       .sampler = options.sampler, .lit_at_vertices = options.lit_at_vertices, .cull_back = options.cull_back,
                       .clip_volume = camera->clip_volume, .reversed_depth = options.reversed_depth,
                       .rasterization = options.rasterization, .fog = options.fog, .normals = options.normals};
  return ModelScene{.drawable = *drawable, .camera = *camera, .view = view};
}

Result<Frame> prepare(const Model& model, const RenderOptions& options) {
  auto target = RenderTarget::create(options.width_pixels, options.height_pixels, options.colour_format, options.depth_format);
  if (!target) return target.error();
  const auto scene = place(model, options);
  if (!scene) return scene.error();
  return Frame{.target = *std::move(target), .drawable = scene->drawable, .draws = scene->drawable.draws(scene->view), .camera = scene->camera,
               .matrices = scene->view.camera, .world_from_object = scene->view.world_from_object, .background = options.background,
               .far_depth = options.reversed_depth ? 0.0f : 1.0f};
}

void clear(Frame& frame, Pipeline& pipeline) { pipeline.clear(frame.target, frame.background, frame.far_depth); }

Result<DrawStatistics> draw(Frame& frame, Pipeline& pipeline, Observer* observer) {
  DrawStatistics statistics;
  for (const DrawCall& call : frame.draws) {
    const auto drawn = observer != nullptr ? pipeline.draw(frame.target, call, *observer) : pipeline.draw(frame.target, call);
    if (!drawn) return drawn.error();
    statistics += *drawn;
  }
  return statistics;
}

Result<Rendering> render(const Model& model, const RenderOptions& options, Pipeline& pipeline) {
  auto frame = prepare(model, options);
  if (!frame) return frame.error();
  DrawStatistics statistics;
  std::vector<double> times;
  for (int i = 0; i < std::max(options.frames, 1); ++i) {
    const auto begin = std::chrono::steady_clock::now();
    clear(*frame, pipeline);
    const auto drawn = draw(*frame, pipeline);
    if (!drawn) return drawn.error();
    times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    statistics = *drawn;
  }
  return Rendering{.target = std::move(frame->target), .statistics = statistics, .frame_seconds = seconds_of(times)};
}

std::string with_commas(std::int64_t number) {
  const std::string digits = std::to_string(number);
  std::string grouped;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) grouped += ',';
    grouped += digits[i];
  }
  return grouped;
}

std::string performance_line(const Model& model, const Rendering& rendering) {
  const double pixels = static_cast<double>(rendering.target.width()) * rendering.target.height();
  const double rate = static_cast<double>(model.triangle_count()) / rendering.frame_seconds;
  char text[160];
  std::snprintf(text, sizeof text, "%s triangles, %.2f ms, %.1f Mtri/s, %.0f Mpix/s",
                with_commas(model.triangle_count()).c_str(), rendering.frame_seconds * 1e3, rate * 1e-6,
                pixels / rendering.frame_seconds * 1e-6);
  return text;
}

}  // namespace tuberia::cli
