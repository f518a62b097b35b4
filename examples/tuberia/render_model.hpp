#pragma once
// One model to one picture, with the time it took.

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "math/camera.hpp"
#include "pipeline/pipeline.hpp"
#include "scene/draw_model.hpp"
#include "scene/model.hpp"

namespace tuberia::cli {

/// A camera on the command line: where the eye stands relative to the model, unless placed.
struct CameraOptions {
  double azimuth_degrees = 30, elevation_degrees = 20, fovy_degrees = 40, zoom = 1;
  std::vector<double> eye, look_at;  // world space; empty: chosen to show the whole model
  std::vector<double> up{0, 1, 0};
  bool orthographic = false;
  double near_distance = 0;              // of the near plane from the eye; 0: just before the model
  std::string up_axis = "y";             // of the model: x, y, z, -x, -y or -z
};

struct RenderOptions {
  int width_pixels = 1280, height_pixels = 720;
  Shading shading = Shading::automatic;
  CameraOptions camera;
  Sampler sampler;
  bool lit_at_vertices = false;  // what would be lit at its fragments
  bool cull_back = false;
  ColourFormat colour_format = ColourFormat::srgb8;
  DepthFormat depth_format = DepthFormat::d24;
  bool reversed_depth = false;
  RasterizationState rasterization;
  FogState fog;
  NormalInterpolation normals = NormalInterpolation::renormalized;
  Rgba32F background{0.035f, 0.04f, 0.055f, 1};
  int frames = 3;  // timed; the picture is the last one's
};

/// A model before its camera; refers to the model.
struct ModelScene {
  DrawableModel drawable;
  Camera camera;
  ModelView view;
};

/// Errors: a camera or texture out of range.
Result<ModelScene> place(const Model& model, const RenderOptions& options);

/// Everything that is needed to draw a model; refers to the model.
struct Frame {
  RenderTarget target;
  DrawableModel drawable;
  std::vector<DrawCall> draws;
  Camera camera;
  CameraMatrices matrices;
  glm::mat4 world_from_object{1.0f};
  Rgba32F background;
  float far_depth = 1;
};

/// Errors: a target size, camera or texture out of range.
Result<Frame> prepare(const Model& model, const RenderOptions& options);

void clear(Frame& frame, Pipeline& pipeline);

/// All draws, over what the target holds; shown to the observer, if there is one.
Result<DrawStatistics> draw(Frame& frame, Pipeline& pipeline, Observer* observer = nullptr);

struct Rendering {
  RenderTarget target;
  DrawStatistics statistics;
  double frame_seconds = 0;  // median, clearing included
};

/// Errors as prepare().
Result<Rendering> render(const Model& model, const RenderOptions& options, Pipeline& pipeline);

/// "69,666 triangles, 7.31 ms, 9.5 Mtri/s, 284 Mpix/s"
std::string performance_line(const Model& model, const Rendering& rendering);

/// 1234567 -> "1,234,567".
std::string with_commas(std::int64_t number);

}  // namespace tuberia::cli
