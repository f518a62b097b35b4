// Shadows in the surface program: each light by itself, and all together.

#include <catch2/catch.hpp>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/shadow_scenes.hpp"

namespace tuberia {

namespace {

constexpr int kSurfaceSide = 96;

SurfaceUniforms shiny(std::vector<SurfaceLight> lights, const glm::vec3& eye, const glm::vec3& ambient) {
  return {.reflection = {.model = Reflection::blinn_phong, .ambient = ambient, .diffuse = {0.7f, 0.5f, 0.3f}, .specular = glm::vec3(0.4f), .exponent = 20},
          .ambient_light = glm::vec3(1), .lights = std::move(lights), .eye = eye};
}

Image<Rgba32F> shiny_picture(const test::ShadowScene& scene, std::vector<SurfaceLight> lights, const PipelineOptions& options = {.threads = 1}, const glm::vec3& ambient = glm::vec3(0)) {
  return test::picture_of(scene, surface(shiny(std::move(lights), glm::vec3(scene.eye.eye), ambient)), kSurfaceSide, options);
}

/// The light with a map of its own.
SurfaceLight with_shadow(const test::ShadowScene& scene, const Light& light, int taps) {
  Pipeline pipeline({.threads = 1});
  ShadowMap map = test::value_of(draw_shadow_map(pipeline, scene.draws(), light, scene.bounds(), {.size = 256}));
  map.taps = taps;
  return {light, std::move(map), {}};
}

/// A square of n x n points, each with its part of the intensity.
std::vector<SurfaceLight> area_light(const test::ShadowScene& scene, const glm::vec3& corner, float side, int n) {
  std::vector<SurfaceLight> points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const glm::vec3 at = corner + side / static_cast<float>(n) * glm::vec3(static_cast<float>(i) + 0.5f, 0, static_cast<float>(j) + 0.5f);
      points.push_back(with_shadow(scene, {.kind = Light::Kind::point, .towards = at, .intensity = glm::vec3(1.0f / static_cast<float>(n * n))}, 2));
    }
  return points;
}

}  // namespace

TEST_CASE("surface shadows: V multiplies its own light's term and no other", "[shadows][A13]") {
  const test::ShadowScene scene = test::spheres_on_a_plane();
  const SurfaceLight sun = with_shadow(scene, test::kSun, 3), lamp = with_shadow(scene, test::kLamp, 2);
  const Image<Rgba32F> by_sun = shiny_picture(scene, {sun}), by_lamp = shiny_picture(scene, {lamp}), by_both = shiny_picture(scene, {sun, lamp});
  const Image<Rgba32F> bare_sun = shiny_picture(scene, {{test::kSun, {}, {}}});
  int lit = 0, dark = 0;
  for (int y = 0; y < kSurfaceSide; ++y)
    for (int x = 0; x < kSurfaceSide; ++x) {
      // Two lights are the sum of both, to the bit: 0 + a + b.
      REQUIRE(by_both.at(x, y).r == by_sun.at(x, y).r + by_lamp.at(x, y).r);
      REQUIRE(by_sun.at(x, y).r <= bare_sun.at(x, y).r);
      if (bare_sun.at(x, y).r > 0) ++(by_sun.at(x, y).r == bare_sun.at(x, y).r ? lit : dark);
    }
  CHECK(lit > 4000);
  CHECK(dark > 200);
}

TEST_CASE("surface shadows: ambient light has none", "[shadows][A13]") {
  const test::ShadowScene scene = test::spheres_on_a_plane();
  const glm::vec3 ambient(0.25f);
  const Image<Rgba32F> drawn = shiny_picture(scene, {with_shadow(scene, test::kSun, 1)}, {.threads = 1}, ambient);
  float least = 1;
  for (const Rgba32F& pixel : drawn.pixels())
    if (pixel.a > 0) least = std::min(least, pixel.r);
  CHECK(least == 0.25f);
}

TEST_CASE("surface shadows: the same bits on every instruction set and number of threads", "[shadows][A18]") {
  const test::ShadowScene scene = test::room();
  const SurfaceLight all_around = with_shadow(scene, {.kind = Light::Kind::point, .towards = {0.1f, 1.7f, 0.2f}}, 3);
  const SurfaceLight spot = with_shadow(scene, {.kind = Light::Kind::spot, .towards = {1.9f, 2.5f, 1.6f}, .axis = glm::normalize(glm::vec3(-2, -1.6f, -2.2f)), .cos_inner = 0.85f, .cos_outer = 0.8f}, 2);
  const Image<Rgba32F> first = shiny_picture(scene, {all_around, spot}, {.threads = 1, .instruction_set = InstructionSet::baseline});
  test::for_every_instruction_set([&](InstructionSet set) {
    for (const int threads : {1, 3}) CHECK(shiny_picture(scene, {all_around, spot}, {.threads = threads, .instruction_set = set}) == first);
  });
}

TEST_CASE("surface shadows: points of an area light soften the edge in as many steps", "[shadows][A13]") {
  // Seen along z the shadow of a half plane 1 above the floor, by a light 1 wide and 3 above it, has a penumbra
  // half as wide as the light; a point of light at x = a casts the edge at x = -a / 2.
  test::ShadowScene scene;
  scene.add(test::ground(2));
  scene.add_unseen(test::rectangle({-2, 1, 2}, {2, 0, 0}, {0, 0, -4}, {0, 1, 0}));
  scene.eye = test::eye_above(1);
  const int n = 4;
  const std::vector<SurfaceLight> lights = area_light(scene, {-0.5f, 3, -0.5f}, 1, n);
  std::vector<SurfaceLight> bare = lights;
  for (SurfaceLight& light : bare) light.shadow.reset();
  const auto matt_white = [](const std::vector<SurfaceLight>& points) {
    return surface({.reflection = {.model = Reflection::lambert, .ambient = glm::vec3(0), .diffuse = glm::vec3(1)}, .lights = points});
  };
  const Image<Rgba32F> drawn = test::divided(test::picture_of(scene, matt_white(lights), 128), test::picture_of(scene, matt_white(bare), 128));
  for (int x = 0; x < 128; ++x) {
    const double at = (x + 0.5) / 64 - 1;
    // How many of the n columns of points see it past the edge; nothing is said within a texel of a step.
    int columns = 0;
    bool at_step = false;
    for (int i = 0; i < n; ++i) {
      const double edge = -((i + 0.5) / n - 0.5) / 2;
      columns += at > edge;
      at_step = at_step || std::abs(at - edge) < 0.05;
    }
    if (!at_step) CHECK(drawn.at(x, 64).r == Approx(static_cast<double>(columns) / n).margin(0.03));
  }
}

TEST_CASE("surface shadows: what is wrong with a map is refused with the number of its light", "[shadows]") {
  const test::ShadowScene scene = test::spheres_on_a_plane();
  SurfaceUniforms uniforms = shiny({{test::kSun, {}, {}}, with_shadow(scene, test::kSun, 9)}, {0, 0, 1}, glm::vec3(0));
  Pipeline pipeline({.threads = 1});
  RenderTarget target = *RenderTarget::create(8, 8);
  const auto refused = [&] {
    DrawCall draw = scene.draws()[0];
    draw.program = surface(uniforms);
    const auto drawn = pipeline.draw(target, draw);
    return drawn ? std::string() : drawn.error().message;
  };
  CHECK(refused().find("lights[1].shadow.taps is 9, outside 1 to 8") != std::string::npos);
  uniforms.lights[1].shadow->taps = 1;
  CHECK(refused().empty());
  uniforms.lights[0].projected = ProjectedTexture{};
  CHECK(refused().find("lights[0].projected.texture is missing") != std::string::npos);
}

}  // namespace tuberia
