#pragma once
// A scene as a frame of several passes through the pipeline.

#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"
#include "pipeline/pipeline.hpp"
#include "scene/content/scene_camera.hpp"
#include "scene/frame/frame_materials.hpp"
#include "scene/frame/frame_meshes.hpp"

namespace tuberia {

struct FrameOptions {
  std::optional<glm::ivec2> size_pixels;                  // instead of the scene's
  double time = 0;                                        // 0..1: how far its camera has moved
  std::function<void(std::string_view pass)> progress{};  // told before each pass
};

/// What lies nearest to the observer, pixel by pixel, at the pixels' centres.                    [A 2.1]
struct NearestObjects {
  Image<int> objects;   // their index in the scene, -1 where there is none
  Image<float> depths;  // 0 near .. 1 far, of a d32f buffer
};

/// A scene with its meshes and textures made ready: those that it shows, and no others.
class SceneFrame {
 public:
  /// Errors: files that cannot be read, shapes and cameras that are none. They name the object, texture or light.
  static Result<SceneFrame> create(SceneDescription scene, FrameOptions options = {});

  /// Linear intensities, before exposure; see developed(). The same bits for every thread count and, in exact
  /// precision, every instruction set. Errors: what set_material and lights_with_shadows refuse, files of the
  /// environment, targets of impossible size.
  Result<Image<Rgba32F>> draw(Pipeline& pipeline);

  /// The same geometry with the objects' numbers in place of their light, one sample a pixel. What lets light through counts
  /// as if it were opaque. Errors: targets of impossible size.
  Result<NearestObjects> nearest_objects(Pipeline& pipeline) const;

  const SceneDescription& scene() const noexcept { return scene_; }
  const std::vector<std::string>& warnings() const noexcept { return warnings_; }
  /// The passes of the last drawing, in their order.
  const std::vector<std::string>& passes() const noexcept { return passes_; }
  const DrawStatistics& statistics() const noexcept { return statistics_; }
  std::int64_t triangle_count() const noexcept;

 private:
  struct Part {
    FramePart part;
    std::size_t object;
    glm::mat4 world_from_object{1.0f};
  };
  struct Draws {
    std::vector<DrawCall> opaque, translucent;
  };

  SceneFrame(SceneDescription scene, FrameOptions options) : scene_(std::move(scene)), options_(std::move(options)) {}
  Result<Nothing> prepare_parts();
  Result<Nothing> prepare_textures();
  Bounds bounds() const;
  bool needs_environment() const;

  DrawCall draw_of(const Part& part, const Camera& camera) const;
  std::vector<DrawCall> casters() const;
  Result<Draws> draws_for(const Camera& camera, const FrameLight& light, bool is_environment) const;
  Result<Nothing> draw_all(Pipeline& pipeline, RenderTarget& target, const std::vector<DrawCall>& draws);
  Result<std::vector<SurfaceLight>> draw_shadows(Pipeline& pipeline);
  Result<EnvironmentMap> draw_environment(Pipeline& pipeline, const FrameLight& light);
  void begin_pass(const std::string& name);

  SceneDescription scene_;
  FrameOptions options_;
  Camera camera_;
  glm::ivec2 size_{0, 0};  // pixels of the picture
  std::vector<Part> parts_;
  FrameTextures textures_;
  std::vector<std::string> warnings_, passes_;
  DrawStatistics statistics_;
};

}  // namespace tuberia
