#pragma once
// Draws for tests of the fragment stages: such as the fused tile loops can do, and others.

#include <string>
#include <vector>

#include "tests/support/meshes.hpp"
#include "tests/support/render.hpp"

namespace tuberia::test {

/// Of every sample's colour, depth and stencil code.
inline std::string digest_of_samples(const RenderTarget& target) {
  Sha256 sha;
  for (int s = 0; s < target.samples(); ++s) {
    const auto add = [&sha](const auto& image) { sha.add(std::as_bytes(image.pixels())); };
    add(target.sample_linear_image(s));
    add(target.sample_depth_codes(s));
    add(target.sample_stencil_codes(s));
  }
  return sha.hex();
}

struct NamedDraw {
  const char* name;
  Mesh mesh;
  FragmentProgram program;
  PipelineState state;
};

inline PipelineState seen_from(glm::dvec3 eye) {
  PipelineState state;
  state.transform.clip_from_world = clip_from_world(eye, 1.3);
  return state;
}

/// What the fused tile loops can draw, a bit of everything.
inline std::vector<NamedDraw> everyday_draws() {
  const PipelineState plain = seen_from({1.5, 1.25, 2.5});
  PipelineState lit = plain, over = plain, added = plain, untested = plain, depth_only = plain;
  lit.transform.vertex_lighting = Lighting{.specular = glm::vec3(0.4f), .eye = {1.5f, 1.25f, 2.5f}};
  over.blend.mode = BlendMode::source_over;
  over.rasterization.scissor = PixelRect{5, 3, 88, 61};
  added.blend.mode = BlendMode::additive;
  added.depth.test = Compare::less_equal;
  untested.depth = kDepthOff;
  depth_only.blend.write = false;
  const Image<Rgba8> holes = checkerboard(32, 4, {200, 30, 60, 255}, {0, 0, 0, 0});
  const TexturedUniforms texture{.texture = texture_of(holes, TextureEncoding::srgb), .sampler = {}, .alpha_cutoff = 0.5f};
  const Mesh floor = rectangle({-9, -1, -9}, {0, 0, 18}, {18, 0, 0}, {0, 1, 0}, 7);
  return {{"depth only", rectangle({-1, -1, 0.5f}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}), flat(), depth_only},
          {"cut out", floor, textured(texture, true), plain},
          {"gouraud", sphere(12), gouraud(), lit},
          {"phong, added", sphere(9), phong({}), added},
          {"flat, over", sphere(7), flat(), over},
          {"textured, untested", floor, textured(texture), untested}};
}

/// State that only the staged loops know, all of it in use somewhere.
inline std::vector<NamedDraw> staged_draws(bool logic) {
  std::vector<NamedDraw> draws = everyday_draws();
  for (std::size_t i = 0; i < draws.size(); ++i) {
    PipelineState& state = draws[i].state;
    const auto pick = [&](std::size_t n, std::size_t step) { return (i * step + 3) % n; };
    state.stencil.enabled = true;
    state.stencil.front = {.test = i % 2 == 0 ? Compare::always : Compare::not_equal, .reference = static_cast<std::uint8_t>(i), .read_mask = 0x0f,
                           .write_mask = 0x3f, .fail = StencilOperation::invert, .depth_fail = StencilOperation::increment_wrap,
                           .pass = static_cast<StencilOperation>(pick(8, 3))};
    state.stencil.back = state.stencil.front;
    state.blend.mode = BlendMode::function;
    state.blend.colour = {static_cast<BlendFactor>(pick(15, 4)), static_cast<BlendFactor>(pick(15, 7)), static_cast<BlendEquation>(pick(5, 1))};
    state.blend.alpha = {BlendFactor::one, BlendFactor::one_minus_source_alpha, BlendEquation::add};
    state.blend.constant = {0.5f, 0.25f, 0.75f, 0.5f};
    state.blend.mask = {true, i != 3, true, i != 4};
    state.alpha_test = {Compare::greater, 0.125f};
    state.multisampling.alpha_to_coverage = i == 1;
    state.fog = {.mode = static_cast<FogMode>(pick(4, 1)), .colour = {0.5f, 0.6f, 0.7f, 1}, .density = 0.2f, .start = 1, .end = 9};
    if (logic && i >= 3) state.blend.logic = static_cast<LogicOperation>(1 + pick(16, 5));
  }
  return draws;
}

}  // namespace tuberia::test
