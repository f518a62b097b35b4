#pragma once
// Scenes as a test writes them, and what they look like.

#include <catch2/catch.hpp>

#include <cmath>
#include <glm/vec4.hpp>
#include <string>

#include "math/camera.hpp"
#include "scene/description/read_scene.hpp"
#include "scene/frame/scene_frame.hpp"

namespace tuberia::test {

inline SceneDescription scene_from(const std::string& text) {
  const auto scene = scene_from_json(text, "scene.json");
  if (!scene) FAIL(scene.error().message);
  return *scene;
}

struct DrawnScene {
  Image<Rgba32F> light;
  std::vector<std::string> passes, warnings;
  CameraMatrices camera;

  /// The pixel on which a point of the world lies.
  Rgba32F at(const glm::vec3& point) const {
    const glm::vec4 clip = camera.clip_from_world * glm::vec4(point, 1);
    const int x = static_cast<int>(std::floor((clip.x / clip.w + 1) / 2 * static_cast<float>(light.width())));
    const int y = static_cast<int>(std::floor((1 - clip.y / clip.w) / 2 * static_cast<float>(light.height())));
    CAPTURE(point.x, point.y, point.z, x, y);
    REQUIRE((x >= 0 && y >= 0 && x < light.width() && y < light.height()));
    return light.at(x, y);
  }
};

inline DrawnScene drawn(const SceneDescription& scene, const PipelineOptions& options = {.threads = 1}) {
  auto frame = SceneFrame::create(scene);
  if (!frame) FAIL(frame.error().message);
  Pipeline pipeline(options);
  const auto light = frame->draw(pipeline);
  if (!light) FAIL(light.error().message);
  const auto camera = camera_of(scene.camera, static_cast<double>(scene.picture.width) / scene.picture.height);
  return {.light = *light, .passes = frame->passes(), .warnings = frame->warnings(), .camera = *camera_matrices(*camera)};
}

inline DrawnScene drawn(const std::string& text, const PipelineOptions& options = {.threads = 1}) { return drawn(scene_from(text), options); }

/// What such a scene cannot be drawn for; it may be refused when it is made ready or when it is drawn.
inline std::string refusal_of_scene(const SceneDescription& scene) {
  auto frame = SceneFrame::create(scene);
  if (!frame) return frame.error().message;
  Pipeline pipeline({.threads = 1});
  const auto light = frame->draw(pipeline);
  return light ? "" : light.error().message;
}

}  // namespace tuberia::test
