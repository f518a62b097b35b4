// Pictures of patterns, relief and texture access, through the surface program.

#include <catch2/catch.hpp>

#include "pipeline/programs/surface.hpp"
#include "raster/level_colours.hpp"
#include "scene/procedural_images.hpp"
#include "scene/shapes/shapes.hpp"
#include "tests/golden/golden_scene.hpp"

namespace tuberia {

namespace {

using test::Studio;

constexpr glm::dvec3 kReliefEye{0, 1.6, 3.2};

std::shared_ptr<const Texture> linear_texture(const Image<Rgba8>& image) { return test::texture_of(image, TextureEncoding::linear); }
std::shared_ptr<const Texture> painted_texture(const Image<Rgba8>& image) { return test::texture_of(image, TextureEncoding::srgb); }

/// Plastic under one white lamp from the upper left.
SurfaceUniforms lit_plastic() {
  SurfaceUniforms uniforms{.reflection = {.ambient = glm::vec3(1), .diffuse = glm::vec3(0.9f), .specular = glm::vec3(0.35f), .exponent = 40},
                           .ambient_light = glm::vec3(0.12f), .eye = glm::vec3(kReliefEye)};
  uniforms.lights.push_back({.light = {.towards = glm::normalize(glm::vec3(-0.5f, 0.75f, 0.55f)), .intensity = glm::vec3(0.95f)}});
  return uniforms;
}

/// Draws a shape into a cell of a grid of pictures, turned about y and tilted towards the eye.
void draw_in_cell(Studio& studio, const tuberia::Mesh& mesh, const SurfaceUniforms& uniforms, const Viewport& cell, double turn = 0.6) {
  PipelineState state;
  state.transform.world_from_object = rotation({0, 1, 0}, turn);
  state.transform.clip_from_world = test::clip_from_world(kReliefEye, static_cast<double>(cell.width_pixels) / cell.height_pixels);
  state.viewport.viewport = cell;
  state.culling.cull = CullFace::back;
  const MeshView view{.positions = mesh.positions, .normals = mesh.normals, .texcoords = mesh.texcoords, .indices = mesh.indices,
                      .tangents = mesh.tangents, .bitangents = mesh.bitangents};
  studio.draw(view, surface(uniforms), state);
}

Viewport cell_of_six(int i) { return test::grid_cell(i % 3, i / 3, 3, 2); }

/// Squares on a sphere and a torus, a checker; wood and marble, carved.
void pattern_gallery(Studio& studio) {
  const auto ball = *sphere_mesh({.radius = 1.25}), ring = *torus_mesh({.radius = 1.1, .tube_radius = 0.45}), ground = *plane_mesh({.width = 3, .depth = 3});
  SurfaceUniforms uniforms = lit_plastic();
  uniforms.colour.pattern = {.kind = Pattern::Kind::random_squares, .first = glm::vec3(0), .second = glm::vec3(1), .scale = 24};
  uniforms.colour.access.coordinates = TextureAccess::Coordinates::sphere;
  uniforms.colour.access.globe_from_world = rotation({1, 0, 0}, -0.7);  // a pole towards the eye
  draw_in_cell(studio, ball, uniforms, cell_of_six(0));
  uniforms.colour.access = {};
  draw_in_cell(studio, ring, uniforms, cell_of_six(1));
  uniforms.colour.pattern = {.kind = Pattern::Kind::checker, .first = {0.9f, 0.85f, 0.7f}, .second = {0.1f, 0.15f, 0.3f}, .scale = 10};
  draw_in_cell(studio, ground, uniforms, cell_of_six(2));
  uniforms.colour.pattern = {.kind = Pattern::Kind::wood, .first = {0.6f, 0.35f, 0.15f}, .second = {0.25f, 0.11f, 0.04f}, .scale = 6, .turbulence = 0.8f,
                             .pattern_from_world = translation({0.5, 0, 0.3})};
  draw_in_cell(studio, *box_mesh({.width = 1.6, .height = 1.6, .depth = 1.6}), uniforms, cell_of_six(3));
  uniforms.colour.pattern = {.kind = Pattern::Kind::marble, .first = {0.9f, 0.88f, 0.85f}, .second = {0.12f, 0.12f, 0.15f}, .scale = 2, .turbulence = 1};
  draw_in_cell(studio, ball, uniforms, cell_of_six(4));
  draw_in_cell(studio, ring, uniforms, cell_of_six(5));
}

/// Above with their colours only, below with relief: a bumped torus, a wall, a planet.
void texture_and_relief(Studio& studio) {
  const auto ring = *torus_mesh({.radius = 1.1, .tube_radius = 0.5}), wall = *plane_mesh({.width = 3, .depth = 3}), ball = *sphere_mesh({.radius = 1.25});
  const auto repeated = [](tuberia::Mesh mesh, glm::vec2 times) {
    for (glm::vec2& uv : mesh.texcoords) uv *= times;
    for (glm::vec3& t : mesh.tangents) t /= times.x;
    for (glm::vec3& t : mesh.bitangents) t /= times.y;
    return mesh;
  };
  const tuberia::Mesh ring_of_studs = repeated(ring, {4, 2});
  const auto checks = painted_texture(test::checkerboard(64, 8, {235, 190, 90, 255}, {200, 80, 60, 255}));
  const auto studs = linear_texture(stud_height_image(64, 64, 4)), mortar = linear_texture(normal_image(brick_height_image(128, 128), 0.02));
  const auto bricks = painted_texture(brick_image(128, 128)), planet = painted_texture(planet_image(256, 128)), mountains = linear_texture(planet_height_image(256, 128));
  for (const bool has_relief : {false, true}) {
    const int row = has_relief ? 3 : 0;
    const auto relief = [&](BumpMap::Kind kind, std::shared_ptr<const Texture> texture, float gain) {
      return has_relief ? BumpMap{.kind = kind, .texture = std::move(texture), .sampler = {}, .gain = gain} : BumpMap{};
    };
    SurfaceUniforms uniforms = lit_plastic();
    uniforms.colour.texture = checks;
    uniforms.bump = relief(BumpMap::Kind::height_texture, studs, 0.12f);
    draw_in_cell(studio, ring_of_studs, uniforms, cell_of_six(row));
    uniforms.colour.texture = bricks;
    uniforms.bump = relief(BumpMap::Kind::normal_map, mortar, 1);
    draw_in_cell(studio, wall, uniforms, cell_of_six(row + 1));
    uniforms.colour.texture = planet;
    uniforms.bump = relief(BumpMap::Kind::height_texture, mountains, 0.25f);
    draw_in_cell(studio, ball, uniforms, cell_of_six(row + 2), 2.4);
  }
}

/// Waves, an orange and something rough; below the same inverted, flat, and twice as high.
void relief_functions(Studio& studio) {
  const auto ball = *sphere_mesh({.radius = 1.25}), ring = *torus_mesh({.radius = 1.1, .tube_radius = 0.5}), water = *plane_mesh({.width = 3, .depth = 3});
  const auto draw = [&](const tuberia::Mesh& mesh, glm::vec3 colour, BumpMap::Kind kind, float gain, float scale, int cell) {
    SurfaceUniforms uniforms = lit_plastic();
    uniforms.reflection.diffuse = uniforms.reflection.ambient = colour;
    uniforms.bump = {.kind = kind, .texture = {}, .sampler = {}, .gain = gain, .scale = scale};
    draw_in_cell(studio, mesh, uniforms, cell_of_six(cell));
  };
  using enum BumpMap::Kind;
  const glm::vec3 sea(0.08f, 0.3f, 0.45f), peel(0.95f, 0.45f, 0.05f), stone(0.55f, 0.53f, 0.5f);
  draw(water, sea, waves, 0.06f, 5, 0);
  draw(ball, peel, orange, 0.03f, 24, 1);
  draw(ring, stone, rough, 0.06f, 12, 2);
  draw(ball, peel, orange, -0.03f, 24, 3);
  draw(ball, peel, orange, 0, 24, 4);
  draw(ring, stone, rough, 0.12f, 12, 5);
}

/// The planet with the map's seam in the middle, and from above its north pole.
void planet_views(Studio& studio) {
  const auto ball = *sphere_mesh({.radius = 1.4, .slices = 64, .stacks = 32});
  SurfaceUniforms uniforms = lit_plastic();
  uniforms.reflection.specular = glm::vec3(0.05f);
  uniforms.colour.texture = painted_texture(planet_image(256, 128));
  uniforms.colour.access.coordinates = TextureAccess::Coordinates::sphere;
  uniforms.colour.access.globe_from_world = rotation({0, 1, 0}, 1.5707963);  // u = 0 towards +z
  draw_in_cell(studio, ball, uniforms, test::grid_cell(0, 0, 2, 1));
  uniforms.colour.access.globe_from_world = rotation({1, 0, 0}, -1.1);
  draw_in_cell(studio, ball, uniforms, test::grid_cell(1, 0, 2, 1));
}

/// A tunnel and a floor: without mipmaps on the left, with them on the right.
void with_and_without_mipmaps(Studio& studio) {
  const auto checks = painted_texture(test::checkerboard(64, 8, {240, 235, 220, 255}, {60, 40, 90, 255}));
  tuberia::Mesh tunnel = *cylinder_mesh({.radius = 1, .height = 40, .slices = 32, .stacks = 1, .caps = false}), ground = *plane_mesh({.width = 60, .depth = 80});
  for (glm::vec2& uv : tunnel.texcoords) uv *= glm::vec2(4, 24);
  for (glm::vec2& uv : ground.texcoords) uv *= glm::vec2(30, 40);
  for (int i = 0; i < 4; ++i) {
    SurfaceUniforms uniforms{.reflection = {.model = Reflection::lambert, .ambient = glm::vec3(1)}, .ambient_light = glm::vec3(1)};
    uniforms.colour.texture = checks;
    uniforms.colour.sampler.mipmaps = i % 2 == 0 ? MipmapFilter::none : MipmapFilter::linear;
    const bool is_tunnel = i < 2;
    const tuberia::Mesh& mesh = is_tunnel ? tunnel : ground;
    PipelineState state;
    if (is_tunnel) state.transform.world_from_object = compose(translation({0, 0, -18}), rotation({1, 0, 0}, 1.5707963));
    state.viewport.viewport = test::grid_cell(i % 2, i / 2, 2, 2);
    state.transform.clip_from_world = test::clip_from_world(is_tunnel ? glm::dvec3(0, 0, 1.5) : glm::dvec3(0, 0.8, 6), 78.0 / 58);
    const MeshView view{.positions = mesh.positions, .normals = mesh.normals, .texcoords = mesh.texcoords, .indices = mesh.indices};
    studio.draw(view, surface(uniforms), state);
  }
}

/// Which level is read on a floor: by derivatives on the left, by the distance on the right; the nearest
/// level above, two mixed below.
void levels_of_detail(Studio& studio) {
  const auto texture = std::make_shared<const Texture>(*level_coloured_texture(64, 64));
  tuberia::Mesh ground = *plane_mesh({.width = 60, .depth = 80});
  for (glm::vec2& uv : ground.texcoords) uv *= glm::vec2(60, 80);
  const glm::dvec3 eye{0, 0.8, 6};
  for (int i = 0; i < 4; ++i) {
    SurfaceUniforms uniforms{.reflection = {.model = Reflection::lambert, .ambient = glm::vec3(1)}, .ambient_light = glm::vec3(1), .eye = glm::vec3(eye)};
    uniforms.colour = {.texture = texture, .sampler = {.mipmaps = i < 2 ? MipmapFilter::nearest : MipmapFilter::linear}};
    uniforms.colour.access.level_rule = i % 2 == 0 ? TextureAccess::LevelRule::derivatives : TextureAccess::LevelRule::distance;
    uniforms.colour.access.texel_distance = static_cast<float>(texel_distance(1.0 / 64, 1.0471975511965976, 58));
    PipelineState state;
    state.viewport.viewport = test::grid_cell(i % 2, i / 2, 2, 2);
    state.transform.clip_from_world = test::clip_from_world(eye, 78.0 / 58);
    const MeshView view{.positions = ground.positions, .normals = ground.normals, .texcoords = ground.texcoords, .indices = ground.indices};
    studio.draw(view, surface(uniforms), state);
  }
}

}  // namespace

TEST_CASE("golden: patterns of texture coordinates and solid ones", "[golden][B32][B34][B36]") { test::check_golden("patterns", test::golden_canvas(), pattern_gallery); }
TEST_CASE("golden: texture only, and texture with relief", "[golden][A12][B41]") { test::check_golden("texture_and_relief", test::golden_canvas(), texture_and_relief); }
TEST_CASE("golden: waves, an orange and something rough", "[golden][B39][B40]") { test::check_golden("relief_functions", test::golden_canvas(), relief_functions); }
TEST_CASE("golden: a planet's map, seam and pole", "[golden][B33][B35]") { test::check_golden("planet", test::golden_canvas(), planet_views); }
TEST_CASE("golden: a tunnel and a floor without and with mipmaps", "[golden][A01][A05]") { test::check_golden("without_and_with_mipmaps", test::golden_canvas(), with_and_without_mipmaps); }
TEST_CASE("golden: the levels of detail that two rules read", "[golden][A03][A04]") { test::check_golden("levels_of_detail", test::golden_canvas(), levels_of_detail); }

}  // namespace tuberia
