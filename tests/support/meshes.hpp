#pragma once
// Procedural meshes, and a scene of them.

#include "tests/support/random.hpp"
#include "tests/support/render.hpp"
#include "tests/support/shapes.hpp"

namespace tuberia::test {

/// A scene with something of everything: a lit sphere, a textured floor that the near plane cuts,
/// random triangles with and without w > 0, and two blended layers over it all.
inline void draw_everything(Studio& studio, float aspect) {
  const glm::mat4 camera = clip_from_world({1.5, 1.25, 2.5}, static_cast<double>(aspect));
  Lighting light;
  light.specular = glm::vec3(0.5f);
  light.eye = {1.5f, 1.25f, 2.5f};
  light.light_count = 2;
  light.lights[0].towards = {0, 0.8f, 0.6f};
  light.lights[1] = {.kind = Light::Kind::point, .towards = {-2, 1, 1}, .intensity = {0.2f, 0.3f, 0.9f}};
  const auto texture = texture_of(checkerboard(64, 8, {250, 240, 40, 255}, {30, 60, 200, 255}), TextureEncoding::srgb);

  PipelineState state;
  state.transform.clip_from_world = camera;
  const Mesh floor = rectangle({-30, -1, -30}, {0, 0, 60}, {60, 0, 0}, {0, 1, 0}, 40);
  studio.draw(floor.view(), textured({.texture = texture, .sampler = {}}), state);
  const Mesh ball = sphere(24);
  studio.draw(ball.view(), phong(light), state);

  state.transform.world_from_object = translation({-1.5, 0, -0.5});
  studio.draw(ball.view(), textured_lit({.texture = texture, .sampler = {}, .lighting = light}), state);
  state.transform.world_from_object = translation({1.5, 0, -1.5});
  state.transform.vertex_lighting = light;
  studio.draw(ball.view(), gouraud(), state);
  state.transform.vertex_lighting.reset();
  state.transform.world_from_object = glm::mat4(1);

  Random random(51);
  Mesh shards;
  for (int i = 0; i < 80; ++i) {
    // Most are small; every tenth reaches behind the eye.
    const glm::vec3 centre{random.between(-3, 3), random.between(-1, 2), random.between(-3, 2)};
    const float reach = i % 10 == 0 ? 4.0f : 0.4f;
    for (int k = 0; k < 3; ++k) {
      shards.positions.push_back(centre + reach * glm::vec3{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
      shards.colours.push_back({random.between(0, 1), random.between(0, 1), random.between(0, 1), random.between(0, 0.7f)});
    }
  }
  state.depth.write = false;
  state.blend.mode = BlendMode::source_over;
  studio.draw(shards.view(), gouraud(), state);
  state.blend.mode = BlendMode::additive;
  state.rasterization.scissor = PixelRect{10, 5, 90, 60};
  shards.colours.assign(shards.positions.size(), glm::vec4(0.06f, 0.03f, 0.01f, 0));
  studio.draw(shards.view(), flat(), state);
}

}  // namespace tuberia::test
