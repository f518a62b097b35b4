// The pass from the light: what is drawn, and what is refused.

#include <catch2/catch.hpp>

#include "tests/support/shadow_scenes.hpp"

namespace tuberia {

namespace {

/// A square at y = 1 over the middle of a floor, lit from straight above.
test::ShadowScene square_over_floor() {
  test::ShadowScene scene;
  scene.add(test::ground(2));
  scene.add(test::rectangle({-1, 1, 1}, {2, 0, 0}, {0, 0, -2}, {0, 1, 0}));
  scene.light = {.kind = Light::Kind::directional, .towards = {0, 1, 0}};
  return scene;
}

LightView overhead_view(const test::ShadowScene& scene) { return test::value_of(light_view(scene.light, scene.bounds())); }

float middle_of(const ShadowMap& map) {
  const TextureLevel& level = map.depths->level(0);
  return level.floats[level.height / 2 * level.width + level.width / 2];
}

}  // namespace

TEST_CASE("shadow passes: the nearest depth of each texel, in every format", "[shadows][A18][C38]") {
  const test::ShadowScene scene = square_over_floor();
  const LightView view = overhead_view(scene);
  // Slack of 0.001 radii before and behind a box 1 deep.
  const double radius = std::sqrt(4 + 4 + 0.25), depth_range = 1 + 2e-3 * radius;
  for (const auto& [format, margin] : {std::pair{DepthFormat::d32f, 1e-6}, {DepthFormat::d24, 1e-6}, {DepthFormat::d16, 1e-5}}) {
    const ShadowMap map = test::shadow_map_of(scene, view, {.size = 64, .format = format});
    const auto depth_at = [&](int x, int y) { return static_cast<double>(map.depths->level(0).floats[y * 64 + x]); };
    CHECK(depth_at(32, 32) == Approx(1e-3 * radius / depth_range).margin(margin));
    CHECK(depth_at(4, 32) == Approx((1 + 1e-3 * radius) / depth_range).margin(margin));
    CHECK_FALSE(refusal_of(map));
  }
  CHECK(test::shadow_map_of(scene, view, {.size = 64}).texel_right.x == Approx((4 + 2 * radius / 128) / 64));
}

TEST_CASE("shadow passes: faces may be culled, offset, and left out where they write no depth", "[shadows][A18]") {
  const test::ShadowScene scene = square_over_floor();
  const LightView view = overhead_view(scene);
  const float square = middle_of(test::shadow_map_of(scene, view, {.size = 64}));
  // The square's front looks up, as the floor's does.
  CHECK(middle_of(test::shadow_map_of(scene, view, {.size = 64, .cull = CullFace::front})) == 1.0f);
  CHECK(middle_of(test::shadow_map_of(scene, view, {.size = 64, .cull = CullFace::back})) == square);
  CHECK(middle_of(test::shadow_map_of(scene, view, {.size = 64, .offset = {.units = 0x1p20f}})) > square);

  Pipeline pipeline({.threads = 1});
  std::vector<DrawCall> draws = scene.draws();
  draws[1].state.depth.write = false;
  CHECK(middle_of(test::value_of(draw_shadow_map(pipeline, draws, view, {.size = 64}))) > 0.9f);
  draws = scene.draws();
  draws[1].state.culling.front_face = Winding::clockwise;
  CHECK(middle_of(test::value_of(draw_shadow_map(pipeline, draws, view, {.size = 64, .cull = CullFace::front}))) == square);
}

TEST_CASE("shadow passes: what is cut out of a caster lets light pass", "[shadows][A18]") {
  const test::ShadowScene scene = square_over_floor();
  const LightView view = overhead_view(scene);
  std::vector<DrawCall> draws = scene.draws();
  // Opaque but for the middle quarter.
  Image<Rgba8> holed(4, 4);
  for (Rgba8& p : holed.pixels()) p = {255, 255, 255, 255};
  for (const int x : {1, 2})
    for (const int y : {1, 2}) holed.at(x, y).a = 0;
  TexturedUniforms uniforms{.texture = test::texture_of(holed), .sampler = {.texels = TexelFilter::nearest, .mipmaps = MipmapFilter::none}, .alpha_cutoff = 0.5f};
  draws[1].program = textured(uniforms, true);
  Pipeline pipeline({.threads = 1});
  const ShadowMap map = test::value_of(draw_shadow_map(pipeline, draws, view, {.size = 64}));
  CHECK(middle_of(map) > 0.9f);
  CHECK(map.depths->level(0).floats[32 * 64 + 20] < 0.1f);
  // The same by the alpha test.
  draws[1].program = textured(uniforms);
  draws[1].state.alpha_test = {.test = Compare::greater, .reference = 0.5f};
  CHECK(middle_of(test::value_of(draw_shadow_map(pipeline, draws, view, {.size = 64}))) > 0.9f);
}

TEST_CASE("shadow passes: what no light can see is refused by name", "[shadows]") {
  const test::ShadowScene scene = square_over_floor();
  const LightView view = overhead_view(scene);
  Pipeline pipeline({.threads = 1});
  const auto refused = [&](std::span<const DrawCall> draws, const ShadowPass& pass) {
    const auto map = draw_shadow_map(pipeline, draws, view, pass);
    return map ? std::string() : map.error().message;
  };
  std::vector<DrawCall> draws = scene.draws();
  CHECK(refused(draws, {.size = 0}).starts_with("shadow map: "));
  CHECK(refused(draws, {.size = RenderTarget::kMaxSize + 1}).starts_with("shadow map: "));
  const std::vector<glm::vec4> clip{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}};
  draws[1].mesh = {.clip_positions = clip};
  CHECK(refused(draws, {.size = 16}) == "shadow map, draw 1: its mesh is given in clip or screen space, where no light can see it");
  draws = scene.draws();
  const std::uint32_t wrong[3] = {0, 1, 900};
  draws[1].mesh.indices = wrong;
  CHECK(refused(draws, {.size = 16}).starts_with("shadow map, draw 1: "));
}

}  // namespace tuberia
