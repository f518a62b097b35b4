// Pictures of textures of every kind, of what makes their coordinates, and of the units that mix them.

#include <catch2/catch.hpp>

#include "pipeline/programs/fixed_function.hpp"
#include "raster/cube_map.hpp"
#include "raster/texture_target.hpp"
#include "tests/golden/golden_scene.hpp"

namespace tuberia {

namespace {

using test::Mesh;
using test::Studio;

constexpr double kTextureAspect = 160.0 / 120.0;

Mesh whole_cell(float repeats = 1) { return test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, repeats); }

std::shared_ptr<const Texture> shared(Texture texture) { return std::make_shared<const Texture>(std::move(texture)); }

/// Rows of a gradient, so that what comes from a texture can be told from what it is mixed with.
std::shared_ptr<const Texture> gradient() {
  Image<Rgba8> image(16, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) image.at(x, y) = {static_cast<std::uint8_t>(17 * x), static_cast<std::uint8_t>(17 * y), 96, static_cast<std::uint8_t>(17 * (15 - x))};
  return test::texture_of(image);
}

/// Each face a colour of its own, brighter towards its upper left corner, with a white frame.
Texture room() {
  const Rgba8 walls[6] = {{230, 60, 40, 255}, {60, 170, 60, 255}, {120, 190, 250, 255}, {150, 100, 60, 255}, {230, 200, 60, 255}, {90, 60, 190, 255}};
  std::array<Image<Rgba8>, 6> faces;
  for (std::size_t f = 0; f < 6; ++f) {
    faces[f] = Image<Rgba8>(32, 32, walls[f]);
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) {
        Rgba8& texel = faces[f].at(x, y);
        const auto shade = [&](std::uint8_t code) { return static_cast<std::uint8_t>(code * (96 - x - y) / 96); };
        texel = {shade(texel.r), shade(texel.g), shade(texel.b), 255};
        if (x < 2 || y < 2 || x > 29 || y > 29) texel = {255, 255, 255, 255};
      }
  }
  return *Texture::create_cube(faces, TextureEncoding::srgb);
}

/// Above: the eight functions of a first unit; below: the classic environments, and two units at once.
void texture_units(Studio& studio) {
  const auto ramp = gradient();
  const auto checks = test::texture_of(test::checkerboard(16, 4, {255, 255, 255, 255}, {40, 40, 40, 128}));
  Mesh mesh = whole_cell();
  mesh.colours = {{0.9f, 0.3f, 0.2f, 0.9f}, {0.2f, 0.4f, 0.9f, 0.9f}, {0.8f, 0.8f, 0.3f, 0.5f}, {0.3f, 0.9f, 0.5f, 0.5f}};
  const CombinePair classics[5] = {replace_environment(), modulate_environment(), decal_environment(), blend_environment(), add_environment()};
  for (int i = 0; i < 16; ++i) {
    FixedFunctionUniforms uniforms;
    TextureUnit& first = uniforms.units[0];
    first.texture = ramp;
    first.constant = {0.9f, 0.1f, 0.6f, 0.4f};
    if (i < 8) first.colour.function = static_cast<CombineFunction>(i);
    else if (i < 13) first.colour = classics[i - 8].colour, first.alpha = classics[i - 8].alpha;
    if (i == 14) first.colour.scale = 4;
    if (i == 15) first.colour.argument[0].operand = CombineOperand::one_minus_colour;
    if (i >= 13) uniforms.units[1] = {.texture = checks, .sampler = {}, .colour = modulate_environment().colour, .alpha = modulate_environment().alpha};
    PipelineState state;
    state.depth = kDepthOff;
    state.viewport.viewport = test::grid_cell(i % 4, i / 4, 4, 4);
    studio.draw(mesh.view(), fixed_function(uniforms), state);
  }
}

/// Object stripes, stripes that stay with the eye, a sphere map; a cube map by reflection, and by normals.
void texture_generation(Studio& studio) {
  PipelineState state;
  const CameraBasis basis = *camera_basis({0, 0.8, 5}, {0, 0, 0}, {0, 1, 0});
  state.transform.view_from_world = view_from_world(basis, {0, 0.8, 5});
  state.transform.clip_from_world = test::clip_from_world({0, 0.8, 5}, kTextureAspect);
  state.culling.cull = CullFace::back;
  const auto checks = test::texture_of(test::checkerboard(32, 8, {250, 240, 210, 255}, {160, 50, 40, 255}), TextureEncoding::srgb);
  const auto cube = shared(room());
  using enum TexCoordSource;
  const TexCoordSource sources[5] = {object_linear, eye_linear, sphere_map, reflection_map, normal_map};
  Mesh ball = test::sphere(24);
  ball.colours.clear();
  for (int i = 0; i < 5; ++i) {
    TexCoordUnit& unit = state.transform.texture_units[0];
    unit = {};
    unit.plane = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {}, {}}};
    unit.source = {sources[i], sources[i], i > 2 ? sources[i] : vertex, vertex};
    state.transform.world_from_object = compose(translation({-2.3 + 2.3 * (i % 3) + (i > 2 ? 1.15 : 0), i > 2 ? -1.05 : 1.05, 0}), rotation({0.6, 0.8, 0}, 0.25 * i));
    TextureUnit texture{.texture = i > 2 ? cube : checks, .sampler = {}, .colour = replace_environment().colour, .alpha = replace_environment().alpha};
    studio.draw(ball.view(), fixed_function({.units = {texture}}), state);
  }
}

/// A row of texels, a block of wood that a sphere is carved from, and the faces of a cube seen from within.
void texture_kinds(Studio& studio) {
  PipelineState state;
  const std::vector<Rgba8> spectrum{{220, 40, 40, 255}, {230, 160, 30, 255}, {220, 220, 50, 255}, {50, 180, 70, 255}, {50, 90, 210, 255}, {130, 50, 170, 255}};
  const TextureUnit row{.texture = shared(*Texture::create_1d(spectrum, TextureEncoding::srgb)),
                        .sampler = {.mipmaps = MipmapFilter::none, .wrap_u = Wrap::clamp}, .colour = replace_environment().colour, .alpha = replace_environment().alpha};
  state.viewport.viewport = Viewport{2, 90, 156, 28};
  studio.draw(whole_cell().view(), fixed_function({.units = {row}}), state);

  std::vector<Image<Rgba8>> slices(16, Image<Rgba8>(16, 16));
  for (int z = 0; z < 16; ++z)
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const int rings = ((x - 8) * (x - 8) + (y - 5) * (y - 5)) / 9 % 2;
        slices[static_cast<std::size_t>(z)].at(x, y) = rings == 0 ? Rgba8{190, 130, 70, 255} : Rgba8{120, static_cast<std::uint8_t>(60 + 3 * z), 40, 255};
      }
  state.viewport.viewport = Viewport{0, 0, 80, 90};
  state.transform.clip_from_world = test::clip_from_world({1.2, 1.3, 1.6}, 80.0 / 90.0);
  TexCoordUnit& unit = state.transform.texture_units[0];
  using enum TexCoordSource;
  unit.source = {object_linear, object_linear, object_linear, vertex};
  unit.plane = {{{0.5f, 0, 0, 0.5f}, {0, 0.5f, 0, 0.5f}, {0, 0, 0.5f, 0.5f}, {}}};
  const TextureUnit wood{.texture = shared(*Texture::create_3d(slices, TextureEncoding::srgb)), .sampler = {}};
  Mesh ball = test::sphere(20);
  ball.colours.clear();
  state.transform.vertex_lighting = Lighting{};
  state.transform.vertex_lighting->lights[0].towards = {0.48f, 0.6f, 0.64f};
  state.culling.cull = CullFace::back;
  studio.draw(ball.view(), fixed_function({.units = {wood}}), state);

  state.transform.vertex_lighting.reset();
  state.viewport.viewport = Viewport{80, 0, 80, 90};
  state.transform.clip_from_world = test::clip_from_world({0.1, 0.25, 0.3}, 80.0 / 90.0, 0.01);
  unit.plane = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {}}};
  state.culling.cull = CullFace::none;
  const TextureUnit faces{.texture = shared(room()), .sampler = {}, .colour = replace_environment().colour, .alpha = replace_environment().alpha};
  studio.draw(ball.view(), fixed_function({.units = {faces}}), state);
}

/// The same floor by footprints up to 1, 2, 4 and 16 times as long as wide.
void anisotropy(Studio& studio) {
  const auto checks = test::texture_of(test::checkerboard(64, 16, {245, 240, 225, 255}, {40, 50, 90, 255}), TextureEncoding::srgb);
  const float limits[4] = {1, 2, 4, 16};
  for (int i = 0; i < 4; ++i) {
    PipelineState state;
    state.viewport.viewport = test::grid_cell(i % 2, i / 2, 2, 2);
    state.transform.clip_from_world = test::clip_from_world({0.7, 0.5, 2}, 78.0 / 58.0);
    studio.draw(test::rectangle({-60, -0.3f, -60}, {0, 0, 120}, {120, 0, 0}, {0, 1, 0}, 90).view(),
                textured({.texture = checks, .sampler = {.max_anisotropy = limits[i]}}), state);
  }
}

/// Depths as a light sees them, compared with what the eye sees; and a picture within the picture.
void drawn_textures(Studio& studio) {
  const glm::dvec3 light_place{2.0, 3.2, 1.6}, eye{0.2, 1.6, 3.4};
  const glm::mat4 clip_from_light = test::clip_from_world(light_place, 1, 1, 8);
  const Mesh ball = test::sphere(20);
  const Mesh floor = test::rectangle({-2.5f, -1, -2.5f}, {0, 0, 5}, {5, 0, 0}, {0, 1, 0});

  RenderTarget map = *RenderTarget::create(128, 128);
  PipelineState state;
  state.transform.clip_from_world = clip_from_light;
  state.rasterization.polygon_offset = {.factor = 2, .units = 8};
  for (const Mesh* mesh : {&ball, &floor}) REQUIRE(studio.pipeline().draw(map, {.mesh = mesh->view(), .program = flat(), .state = state}));
  Texture depths = *Texture::create_empty({.format = TextureFormat::depth32f, .width = 128, .height = 128, .with_mipmaps = false});
  REQUIRE(copy_depth_to_texture(map, depths));
  Texture pictures = *Texture::create_empty({.encoding = TextureEncoding::linear, .width = 128, .height = 128});
  REQUIRE(copy_to_texture(map, pictures));
  pictures.generate_mipmaps();

  // Clip space of the light to texture coordinates, y down, and depth.
  const glm::mat4 texture_from_clip{{0.5f, 0, 0, 0}, {0, -0.5f, 0, 0}, {0, 0, 0.5f, 0}, {0.5f, 0.5f, 0.5f, 1}};
  state = {};
  state.transform.clip_from_world = test::clip_from_world(eye, kTextureAspect);
  TexCoordUnit& unit = state.transform.texture_units[0];
  unit.source.fill(TexCoordSource::object_linear);
  unit.plane = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  unit.matrix = compose(texture_from_clip, clip_from_light);
  Lighting light;
  light.ambient = glm::vec3(0.1f);
  light.lights[0] = {.kind = Light::Kind::point, .towards = {2.0f, 3.2f, 1.6f}};
  state.transform.vertex_lighting = light;
  const TextureUnit shadow{.texture = shared(std::move(depths)), .sampler = {.mipmaps = MipmapFilter::none, .wrap_u = Wrap::clamp, .wrap_v = Wrap::clamp, .compare = Compare::less_equal}};
  for (const Mesh* mesh : {&floor, &ball}) studio.draw(mesh->view(), fixed_function({.units = {shadow}}), state);

  PipelineState inset;
  inset.depth = kDepthOff;
  inset.viewport.viewport = Viewport{4, 4, 36, 36};
  studio.draw(whole_cell().view(), textured({.texture = shared(std::move(pictures)), .sampler = {}}), inset);
}

}  // namespace

TEST_CASE("golden: texture units and generated coordinates", "[golden][exact]") {
  test::Canvas linear = test::golden_canvas();
  linear.colour = ColourFormat::rgba8;
  test::check_golden("texture_units", linear, texture_units);
  test::check_golden("texture_generation", test::golden_canvas(), texture_generation);
}

TEST_CASE("golden: kinds of textures, anisotropy, and textures that were drawn", "[golden][exact]") {
  test::check_golden("texture_kinds", test::golden_canvas(), texture_kinds);
  test::check_golden("anisotropy", test::golden_canvas(), anisotropy);
  test::check_golden("drawn_textures", test::golden_canvas(), drawn_textures);
}

}  // namespace tuberia
