#pragma once
// A draw and what it left in its target, for tests that only want to see the pixels.

#include <catch2/catch.hpp>

#include <string>
#include <vector>

#include "pipeline/pipeline.hpp"
#include "pipeline/programs/programs.hpp"
#include "tests/support/mesh.hpp"
#include "tests/support/sha256.hpp"

namespace tuberia::test {

/// Where and how a test draws.
struct Canvas {
  int width = 64, height = 64;
  ColourFormat colour = ColourFormat::rgba8;
  DepthFormat depth = DepthFormat::d24;
  Rgba32F background{0, 0, 0, 0};
  float far_depth = 1;
  bool stencil = false;
  int samples = 1;
  PipelineOptions options{.threads = 1};
};

struct Picture {
  Image<Rgba8> colour;
  Image<Rgba32F> linear;
  Image<std::int32_t> depth;  // codes
  DrawStatistics statistics;
};

/// A cleared target to draw into, and the pipeline that does it. Refusals fail the test.
class Studio {
 public:
  explicit Studio(const Canvas& canvas)
      : pipeline_(canvas.options), target_(*RenderTarget::create({.width = canvas.width, .height = canvas.height, .colour = canvas.colour,
                                                                      .depth = canvas.depth, .stencil = canvas.stencil, .samples = canvas.samples})) {
    pipeline_.clear(target_, canvas.background, canvas.far_depth);
  }

  DrawStatistics draw(const MeshView& mesh, const FragmentProgram& program, const PipelineState& state = {}) {
    const DrawCall call{.mesh = mesh, .program = program, .state = state};
    const Result<DrawStatistics> drawn = observer_ ? pipeline_.draw(target_, call, *observer_) : pipeline_.draw(target_, call);
    if (!drawn) FAIL("the draw was refused: " << drawn.error().message);
    statistics_ += *drawn;
    return *drawn;
  }

  /// From now on the draws are watched.
  void watch(Observer& observer) { observer_ = &observer; }

  Picture picture() const {
    return {target_.colour_image(), target_.linear_image(), target_.depth_codes(), statistics_};
  }
  RenderTarget& target() { return target_; }
  Pipeline& pipeline() { return pipeline_; }

  /// Of every colour and depth as stored.
  std::string digest() const {
    Sha256 sha;
    const auto add = [&sha](const auto& image) { sha.add(std::as_bytes(image.pixels())); };
    if (target_.colour_format() == ColourFormat::rgba32f) add(target_.linear_image());
    else add(target_.colour_image());
    add(target_.depth_codes());
    return sha.hex();
  }

 private:
  Pipeline pipeline_;
  RenderTarget target_;
  DrawStatistics statistics_;
  Observer* observer_ = nullptr;
};

inline Picture render(const Mesh& mesh, const FragmentProgram& program, const PipelineState& state = {},
                      const Canvas& canvas = {}) {
  Studio studio(canvas);
  studio.draw(mesh.view(), program, state);
  return studio.picture();
}

/// Any clip positions can be drawn, w included: each object position (i, 0, 0) has a matrix column
/// to itself. Three vertices use three columns of the clip matrix exactly.
struct ClipTriangle {
  glm::vec4 a, b, c;
};

/// The matrix that sends the object positions (1,0,0), (0,1,0), (0,0,1) to the three corners.
/// Products with 0 and 1 keep every bit of finite numbers.
inline glm::mat4 clip_from_unit_vectors(const ClipTriangle& t) { return {t.a, t.b, t.c, glm::vec4(0)}; }

inline Mesh unit_vectors() {
  Mesh mesh;
  mesh.positions = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return mesh;
}

/// How many pixels have another colour than the background of transparent black.
inline std::int64_t pixels_drawn(const Image<Rgba8>& image) {
  std::int64_t count = 0;
  for (const Rgba8& pixel : image.pixels())
    if (pixel != Rgba8{0, 0, 0, 0}) ++count;
  return count;
}

}  // namespace tuberia::test
