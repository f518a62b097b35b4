#include "tests/extremes/determinism/digests.hpp"

#include "pipeline/programs/programs.hpp"
#include "tests/support/sha256.hpp"

namespace tuberia::determinism {

namespace {

std::vector<Scene>& append_scenes(std::vector<Scene>& all, std::vector<Scene> more) {
  for (Scene& scene : more) all.push_back(std::move(scene));
  return all;
}

bool stores_codes(ColourFormat format) { return format == ColourFormat::rgba8 || format == ColourFormat::srgb8; }

template <class Pixel>
void add(test::Sha256& sha, const Image<Pixel>& image) { sha.add(std::as_bytes(image.pixels())); }

std::string colour_digest(const RenderTarget& target) {
  test::Sha256 sha;
  for (int sample = 0; sample < target.samples(); ++sample) {
    if (stores_codes(target.colour_format())) add(sha, target.sample_colour_image(sample));
    else add(sha, target.sample_linear_image(sample));
  }
  return sha.hex();
}

std::string depth_digest(const RenderTarget& target) {
  test::Sha256 sha;
  for (int sample = 0; sample < target.samples(); ++sample) {
    add(sha, target.sample_depth_codes(sample));
    if (target.has_stencil()) add(sha, target.sample_stencil_codes(sample));
  }
  return sha.hex();
}

/// The same geometry, each primitive in a colour that is its number. What is added still is.
Scene numbered(Scene scene) {
  scene.target.colour = ColourFormat::rgba32f;
  float next = 1;
  for (Layer& layer : scene.layers) {
    const std::size_t count = layer.view().vertex_count();
    layer.mesh.colours.clear();
    for (std::size_t i = 0; i < count; ++i) layer.mesh.colours.push_back({next++, 0, 0, 1});
    layer.program = flat();
    layer.state.transform.vertex_lighting.reset();
    const bool adds = layer.state.blend.mode == BlendMode::additive;
    layer.state.blend = {};
    if (adds) layer.state.blend.mode = BlendMode::additive;
    layer.state.fog = {};
    layer.state.alpha_test = {};
    layer.state.multisampling = {};
  }
  return scene;
}

Result<RenderTarget> drawn(const Scene& scene, const PipelineOptions& options) {
  Pipeline pipeline(options);
  Result<RenderTarget> target = RenderTarget::create(scene.target);
  if (!target) return target;
  pipeline.clear(*target, {0.1f, 0.2f, 0.3f, 1}, scene.far_depth);
  for (const Layer& layer : scene.layers) {
    const Result<DrawStatistics> done = pipeline.draw(*target, {.mesh = layer.view(), .program = layer.program, .state = layer.state});
    if (!done) return done.error();
  }
  return target;
}

}  // namespace

std::vector<Scene> scenes() {
  std::vector<Scene> all = coverage_scenes();
  append_scenes(all, clipping_scenes());
  append_scenes(all, texture_scenes());
  return append_scenes(all, output_scenes());
}

Result<Digests> digests_of(const Scene& scene, const PipelineOptions& options) {
  const Result<RenderTarget> picture = drawn(scene, options);
  if (!picture) return picture.error();
  const Result<RenderTarget> numbers = drawn(numbered(scene), options);
  if (!numbers) return numbers.error();
  return Digests{colour_digest(*picture), depth_digest(*picture), colour_digest(*numbers)};
}

}  // namespace tuberia::determinism
