// What happens to fragments: layers that blend, samples, stencil, fog, tests, and depth formats.

#include "pipeline/programs/programs.hpp"
#include "tests/extremes/determinism/scene.hpp"
#include "tests/support/random.hpp"
#include "tests/support/shapes.hpp"

namespace tuberia::determinism {

namespace {

/// Triangles anywhere on the screen, small and large, with z and w of their own.
Layer shards(int count, float reach, std::uint64_t seed) {
  test::Random random(seed);
  Layer layer{.program = gouraud()};
  for (int i = 0; i < count; ++i) {
    const float x = random.between(-1, 1), y = random.between(-1, 1), size = random.between(0.05f, reach);
    for (int k = 0; k < 3; ++k) {
      const float w = random.between(0.5f, 3);
      layer.clip_positions.push_back({(x + size * random.between(-1, 1)) * w, (y + size * random.between(-1, 1)) * w, random.between(-1, 1) * w, w});
      layer.mesh.colours.push_back({random.between(0, 1), random.between(0, 1), random.between(0, 1), random.between(0, 0.5f)});
    }
  }
  return layer;
}

/// [rules, case 47]
Scene thousand_transparent() {
  Layer layer = shards(1000, 1.5f, 91);
  layer.state.depth = kDepthOff;
  layer.state.blend.mode = BlendMode::source_over;
  return {.name = "transparent-47", .target = {.width = 150, .height = 100}, .layers = {layer}};
}

Scene blended_layers() {
  Layer over = shards(200, 1, 92), added = shards(200, 1, 93), general = shards(200, 1, 94);
  over.state.blend.mode = BlendMode::source_over;
  added.state.blend.mode = BlendMode::additive;
  general.state.blend.mode = BlendMode::function;
  general.state.blend.colour = {BlendFactor::destination_colour, BlendFactor::one_minus_source_alpha, BlendEquation::reverse_subtract};
  general.state.blend.alpha = {BlendFactor::constant_alpha, BlendFactor::one, BlendEquation::max};
  general.state.blend.constant = {0.5f, 0.25f, 0.75f, 0.5f};
  general.state.blend.mask.green = false;
  for (Layer* layer : {&over, &added, &general}) layer->state.depth.write = false;
  return {.name = "blended", .target = {.width = 170, .height = 130, .colour = ColourFormat::srgb8}, .layers = {shards(50, 2, 95), over, added, general}};
}

Scene multisampled_stencil_fog() {
  Layer first = shards(150, 1.5f, 96), second = shards(150, 1.5f, 97);
  first.state.fog = {.mode = FogMode::exp2, .colour = {0.5f, 0.6f, 0.7f, 1}, .density = 0.4f};
  first.state.multisampling.alpha_to_coverage = true;
  for (Layer* layer : {&first, &second}) {
    layer->state.stencil.enabled = true;
    layer->state.stencil.front = {.test = Compare::always, .reference = 5, .read_mask = 0x0f, .write_mask = 0x3f,
                                  .fail = StencilOperation::invert, .depth_fail = StencilOperation::increment_wrap, .pass = StencilOperation::replace};
    layer->state.stencil.back = {.test = Compare::not_equal, .reference = 5, .read_mask = 0x0f, .write_mask = 0xff,
                                 .fail = StencilOperation::decrement_wrap, .depth_fail = StencilOperation::keep, .pass = StencilOperation::invert};
  }
  second.state.alpha_test = {Compare::greater, 0.125f};
  second.state.fog = {.mode = FogMode::linear, .colour = {0.1f, 0.2f, 0.1f, 1}, .start = 0.5f, .end = 3};
  return {.name = "multisampled-stencil-fog", .target = {.width = 140, .height = 110, .stencil = true, .samples = 4}, .layers = {first, second}};
}

/// The same surfaces in each format, many of them at the same depths; a second pass at equal depths.
Scene depth_format(DepthFormat format, const char* name) {
  Layer first = shards(400, 1.5f, 98);
  for (std::size_t i = 0; i < first.clip_positions.size(); ++i)
    if (i / 3 % 3 == 0) first.clip_positions[i].z = 0.25f * first.clip_positions[i].w;
  Layer again = first;
  again.state.depth = {.test = Compare::equal, .write = false};
  again.state.blend.mode = BlendMode::additive;
  return {.name = name, .target = {.width = 160, .height = 120, .depth = format}, .layers = {first, again}};
}

}  // namespace

std::vector<Scene> output_scenes() {
  return {thousand_transparent(), blended_layers(), multisampled_stencil_fog(), depth_format(DepthFormat::d16, "depth-d16"),
          depth_format(DepthFormat::d24, "depth-d24"), depth_format(DepthFormat::d32f, "depth-d32f")};
}

}  // namespace tuberia::determinism
