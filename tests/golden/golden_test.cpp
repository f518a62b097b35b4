#include <catch2/catch.hpp>

#include "tests/golden/golden.hpp"
#include "tests/image/temporary_folder.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia {

namespace {

using test::Canvas;
using test::Mesh;
using test::Studio;

constexpr double kAspect = 160.0 / 120.0;
constexpr Rgba32F kSky{0.05f, 0.08f, 0.15f, 1};

void gouraud_triangle(Studio& studio) {
  Mesh mesh;
  mesh.positions = {{-0.8f, -0.75f, 0}, {0.8f, -0.75f, 0}, {0, 0.85f, 0}};
  mesh.colours = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
  studio.draw(mesh.view(), gouraud());
}

/// Three squares through one another: each pixel shows the nearest.
void intersecting_planes(Studio& studio) {
  PipelineState state;
  state.transform.clip_from_world = test::clip_from_world({2.2, 1.7, 2.6}, kAspect);
  const Mesh squares[3] = {test::rectangle({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, {0, 1, 0}, 1, {0.9f, 0.6f, 0.1f, 1}),
                           test::rectangle({0, -1, -1}, {0, 2, 0}, {0, 0, 2}, {1, 0, 0}, 1, {0.1f, 0.6f, 0.3f, 1}),
                           test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, 1, {0.2f, 0.3f, 0.9f, 1})};
  for (const Mesh& square : squares) studio.draw(square.view(), gouraud(), state);
}

/// A floor from behind the eye to the horizon, filtered trilinearly.
void checkerboard_floor(Studio& studio) {
  PipelineState state;
  state.transform.clip_from_world = test::clip_from_world({0.4, 0.9, 2}, kAspect);
  const auto texture = test::texture_of(test::checkerboard(64, 32, {240, 235, 220, 255}, {120, 30, 40, 255}), TextureEncoding::srgb);
  const Mesh floor = test::rectangle({-60, -0.5f, -60}, {0, 0, 120}, {120, 0, 0}, {0, 1, 0}, 120);
  studio.draw(floor.view(), textured({.texture = texture, .sampler = {}}), state);
}

/// The same light on the same sphere: Blinn's highlight on the left, Phong's on the right.
void lit_spheres(Studio& studio) {
  Lighting light;
  light.ambient = glm::vec3(0.03f, 0.02f, 0.05f);
  light.diffuse = glm::vec3(0.6f, 0.25f, 0.1f);
  light.specular = glm::vec3(0.6f);
  light.shininess = 40;
  light.eye = {0, 0, 4};
  light.lights[0].towards = {0.6f, 0.64f, 0.48f};
  PipelineState state;
  state.transform.clip_from_world = test::clip_from_world({0, 0, 4}, kAspect);
  state.culling.cull = CullFace::back;
  const Mesh ball = test::sphere(32);
  for (const bool halfway : {true, false}) {
    light.halfway = halfway;
    state.transform.world_from_object = translation({halfway ? -1.15 : 1.15, 0, 0});
    studio.draw(ball.view(), phong(light), state);
  }
}

/// Red, green and blue at half opacity over a checkerboard, and added light in the middle.
void blended_layers(Studio& studio) {
  PipelineState state;
  state.depth = kDepthOff;
  const auto texture = test::texture_of(test::checkerboard(16, 2, {255, 255, 255, 255}, {150, 150, 150, 255}), TextureEncoding::srgb);
  studio.draw(test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}).view(),
              textured({.texture = texture, .sampler = {.texels = TexelFilter::nearest, .mipmaps = MipmapFilter::none}}), state);
  state.blend.mode = BlendMode::source_over;
  const glm::vec4 colours[3] = {{1, 0, 0, 0.5f}, {0, 0.8f, 0, 0.5f}, {0, 0.1f, 1, 0.5f}};
  for (int i = 0; i < 3; ++i) {
    const float shift = 0.35f * static_cast<float>(i);
    studio.draw(test::rectangle({-0.8f + shift, -0.8f + shift, 0}, {0.9f, 0, 0}, {0, 0.9f, 0}, {0, 0, 1}, 1, colours[i]).view(), gouraud(), state);
  }
  state.blend.mode = BlendMode::additive;
  Mesh glow = test::rectangle({-0.2f, -0.9f, 0}, {0.4f, 0, 0}, {0, 1.8f, 0}, {0, 0, 1});
  glow.colours = {{0, 0, 0, 0}, {0.5f, 0.4f, 0, 0}, {0.5f, 0.4f, 0, 0}, {0, 0, 0, 0}};
  studio.draw(glow.view(), gouraud(), state);
}

/// A strip and a fan, flat by their first vertices, each cut by its scissor.
void strips_and_fans(Studio& studio) {
  PipelineState state;
  state.rasterization.flat_shading = true;
  const auto colour = [](int i) {
    return glm::vec4(static_cast<float>(i * 3 % 7) / 6.0f, static_cast<float>(i * 5 % 7) / 6.0f, static_cast<float>(i * 2 % 7) / 6.0f, 1.0f);
  };
  Mesh strip;
  for (int i = 0; i < 16; ++i) {
    strip.positions.push_back({-0.95f + 0.06f * static_cast<float>(i), i % 2 == 0 ? -0.9f : 0.9f, 0});
    strip.colours.push_back(colour(i));
  }
  state.assembly.topology = Topology::triangle_strip;
  state.rasterization.scissor = PixelRect{9, 13, 70, 101};
  studio.draw(strip.view(), gouraud(), state);

  Mesh fan;
  fan.positions.push_back({0.5f, 0, 0});
  const float rim[12][2] = {{1, 0}, {0.875f, 0.5f}, {0.5f, 0.875f}, {0, 1}, {-0.5f, 0.875f}, {-0.875f, 0.5f},
                            {-1, 0}, {-0.875f, -0.5f}, {-0.5f, -0.875f}, {0, -1}, {0.5f, -0.875f}, {0.875f, -0.5f}};
  for (int i = 0; i <= 12; ++i) fan.positions.push_back({0.5f + 0.48f * rim[i % 12][0], 0.64f * rim[i % 12][1], 0});
  for (int i = 0; i < 14; ++i) fan.colours.push_back(colour(i));
  state.assembly.topology = Topology::triangle_fan;
  state.rasterization.scissor = PixelRect{85, 30, 160, 91};
  studio.draw(fan.view(), gouraud(), state);
}

struct Scene {
  const char* name;
  void (*draw)(Studio&);
};

constexpr Scene kScenes[] = {{"gouraud_triangle", gouraud_triangle}, {"intersecting_planes", intersecting_planes},
                             {"checkerboard_floor", checkerboard_floor}, {"lit_spheres", lit_spheres},
                             {"blended_layers", blended_layers}, {"strips_and_fans", strips_and_fans}};

Image<Rgba8> picture_of(const Scene& scene, InstructionSet set, int threads) {
  Studio studio({.width = 160, .height = 120, .colour = ColourFormat::srgb8, .background = kSky,
                 .options = {.threads = threads, .instruction_set = set}});
  scene.draw(studio);
  return studio.target().colour_image();
}

}  // namespace

TEST_CASE("golden: every scene has the bits of its golden picture, on every machine", "[golden][exact]") {
  for (const Scene& scene : kScenes)
    test::for_every_instruction_set([&](InstructionSet set) {
      for (const int threads : {1, 3}) CHECK(test::golden_difference(scene.name, picture_of(scene, set, threads)) == "");
    });
}

TEST_CASE("golden: a difference leaves three pictures to look at", "[golden]") {
  const TemporaryFolder scratch;
  const std::filesystem::path folder = (scratch / "scene.png").parent_path();
  const Image<Rgba8> golden(4, 3, {10, 20, 30, 255});
  Image<Rgba8> actual = golden;
  test::GoldenFolders folders{.golden = folder, .evidence = folder / "evidence", .update = true};
  CHECK(test::golden_difference("scene", golden, folders) == "");
  folders.update = false;
  CHECK(test::golden_difference("scene", actual, folders) == "");
  CHECK(!std::filesystem::exists(folders.evidence));

  actual.at(2, 1).g += 1;
  CHECK_THAT(test::golden_difference("scene", actual, folders),
             Catch::Matchers::Contains("1 pixels by up to 1 codes") && Catch::Matchers::Contains("{actual,expected,difference}.png"));
  CHECK(*read_image(folders.evidence / "scene.actual.png") == actual);
  CHECK(*read_image(folders.evidence / "scene.expected.png") == golden);
  CHECK(read_image(folders.evidence / "scene.difference.png")->at(2, 1) != Rgba8{0, 0, 0, 255});
  CHECK_THAT(test::golden_difference("no_such_scene", actual, folders), Catch::Matchers::Contains("no_such_scene"));
}

}  // namespace tuberia
