#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "image/box_filter.hpp"
#include "raster/level_colours.hpp"
#include "raster/sample_texture.hpp"
#include "tests/pipeline/technique_program_kernels.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/render.hpp"

namespace tuberia {
namespace {

using test::Shown;
using test::TechniqueUniforms;
using LevelRule = TextureAccess::LevelRule;

constexpr int kHigh = 96;
constexpr double kOpening = 1.0471975511965976;  // test::clip_from_world's

std::shared_ptr<const Texture> level_texture(int size) { return std::make_shared<const Texture>(*level_coloured_texture(size, size)); }

Sampler sampler_with(MipmapFilter mipmaps, TexelFilter texels = TexelFilter::bilinear) { return {.texels = texels, .mipmaps = mipmaps}; }

/// A square before a camera at the origin's distance, facing it, 64 texels of `texture` a world unit.
Image<Rgba32F> facing_square(double distance, const TechniqueUniforms& uniforms) {
  TechniqueUniforms seen = uniforms;
  seen.eye = {0, 0, static_cast<float>(distance)};
  const float half = static_cast<float>(distance);
  const float texels = 64.0f * 2 * half / static_cast<float>(uniforms.texture->level(0).width);
  const test::Mesh mesh = test::rectangle({-half, half, 0}, {2 * half, 0, 0}, {0, -2 * half, 0}, {0, 0, 1}, texels);
  PipelineState state;
  state.transform.clip_from_world = test::clip_from_world({0, 0, distance}, 1, 0.1, 5000);
  return test::render(mesh, test::technique(seen), state, {.width = kHigh, .height = kHigh, .colour = ColourFormat::rgba32f}).linear;
}

/// A floor one unit below an eye that looks along it; texture repeats every unit.
constexpr glm::dvec3 kFloorEye{0, 1, 8};
Image<Rgba32F> floor_seen(TechniqueUniforms uniforms, int width, int height) {
  uniforms.eye = glm::vec3(kFloorEye);
  test::Mesh mesh = test::rectangle({-400, 0, -800}, {0, 0, 808}, {808, 0, 0}, {0, 1, 0}, 808);
  PipelineState state;
  state.transform.clip_from_world = test::clip_from_world(kFloorEye, static_cast<double>(width) / height, 0.05, 2000);
  return test::render(mesh, test::technique(uniforms), state, {.width = width, .height = height, .colour = ColourFormat::rgba32f}).linear;
}

/// Two by two squares.
std::shared_ptr<const Texture> checks(int size = 64) { return test::texture_of(test::checkerboard(size, size / 2, {255, 255, 255, 255}, {0, 0, 0, 255})); }

double squared(double x) { return x * x; }

/// The mean squared difference of two pictures' reds in rows [first, last).
double energy(const Image<Rgba32F>& a, const Image<Rgba32F>& b, int first, int last) {
  double sum = 0;
  for (int y = first; y < last; ++y)
    for (int x = 0; x < a.width(); ++x) sum += squared(static_cast<double>(a.at(x, y).r) - static_cast<double>(b.at(x, y).r));
  return sum / ((last - first) * a.width());
}

double variance(const Image<Rgba32F>& a, int first, int last) {
  double sum = 0, squares = 0;
  const double count = (last - first) * a.width();
  for (int y = first; y < last; ++y)
    for (int x = 0; x < a.width(); ++x) sum += static_cast<double>(a.at(x, y).r), squares += squared(static_cast<double>(a.at(x, y).r));
  return squares / count - squared(sum / count);
}

double largest_step_down(const Image<Rgba32F>& image, int first, int last) {
  double most = 0;
  for (int y = first + 1; y < last; ++y) {
    const Rgba32F &a = image.at(image.width() / 2, y - 1), &b = image.at(image.width() / 2, y);
    for (const float d : {a.r - b.r, a.g - b.g, a.b - b.b}) most = std::max(most, std::abs(static_cast<double>(d)));
  }
  return most;
}

}  // namespace

TEST_CASE("texture access: mipmaps take most of the aliasing out of a chequered floor", "[pipeline][texture][A01]") {
  constexpr int kWidth = 96, kRows = 72, kFiner = 8;
  const auto texture = checks();
  const auto seen = [&](MipmapFilter mipmaps, int times) {
    return floor_seen({.shown = Shown::texture, .texture = texture, .sampler = sampler_with(mipmaps)}, kWidth * times, kRows * times);
  };
  const Image<Rgba32F> fine = seen(MipmapFilter::none, kFiner);
  Image<Rgba32F> right(kWidth, kRows, {0, 0, 0, 0});
  for (int y = 0; y < kRows * kFiner; ++y)
    for (int x = 0; x < kWidth * kFiner; ++x) right.at(x / kFiner, y / kFiner).r += fine.at(x, y).r / static_cast<float>(kFiner * kFiner);

  // Far rows: squares of half a unit are narrower than a pixel beyond a distance of some 40.
  const int horizon = 33, far_end = 38;
  const double without = energy(seen(MipmapFilter::none, 1), right, horizon, far_end), with = energy(seen(MipmapFilter::linear, 1), right, horizon, far_end);
  INFO("aliasing energy without mipmaps " << without << ", with " << with);
  CHECK(without > 0.05);
  CHECK(with < without / 5);
}

TEST_CASE("texture access: magnified, a texel covers many pixels, and filtering smooths its steps", "[pipeline][texture][A01]") {
  const auto texture = checks();
  const auto steps = [&](TexelFilter texels) {
    test::Mesh mesh = test::rectangle({-1, 1, 0}, {2, 0, 0}, {0, -2, 0}, {0, 0, 1});
    for (glm::vec2& uv : mesh.texcoords) uv = uv * (4.0f / 64) + glm::vec2(30.0f / 64);  // four texels over 64 pixels
    const auto picture = test::render(mesh, test::technique({.shown = Shown::texture, .texture = texture, .sampler = sampler_with(MipmapFilter::linear, texels)}), {},
                                      {.colour = ColourFormat::rgba32f}).linear;
    double most = 0;
    for (int x = 1; x < 64; ++x) most = std::max(most, std::abs(static_cast<double>(picture.at(x, 10).r - picture.at(x - 1, 10).r)));
    return most;
  };
  CHECK(steps(TexelFilter::nearest) == 1);
  CHECK(steps(TexelFilter::bilinear) == Approx(1.0 / 16).epsilon(0.01));
}

TEST_CASE("texture access: by the distance rule each doubling of the distance is one level", "[pipeline][texture][A03]") {
  const double reference = texel_distance(1.0 / 64, kOpening, kHigh);
  TechniqueUniforms uniforms{.shown = Shown::texture, .texture = level_texture(64), .sampler = sampler_with(MipmapFilter::nearest)};
  for (const LevelRule rule : {LevelRule::distance, LevelRule::derivatives})
    for (int level = 0; level < 7; ++level) {
      uniforms.access = {.level_rule = rule, .texel_distance = static_cast<float>(reference)};
      INFO("rule " << static_cast<int>(rule) << ", level " << level);
      const Rgba32F seen = facing_square(reference * std::exp2(level), uniforms).at(kHigh / 2, kHigh / 2);
      const Rgba8 colour = level_colour(level);
      CHECK(seen.r == Approx(colour.r / 255.0));
      CHECK(seen.g == Approx(colour.g / 255.0));
      CHECK(seen.b == Approx(colour.b / 255.0));
    }
  // Before the reference distance and beyond the last level the level stays.
  uniforms.access.level_rule = LevelRule::distance;
  CHECK(facing_square(reference / 8, uniforms).at(48, 48) == Rgba32F{1, 0, 0, 1});
  CHECK(facing_square(reference * 1024, uniforms).at(48, 48) == facing_square(reference * 64, uniforms).at(48, 48));
}

TEST_CASE("texture access: a level of the program's own is what a lookup at that level reads", "[pipeline][texture][A03]") {
  test::Random random(411);
  Image<Rgba8> noise(32, 16);
  for (Rgba8& p : noise.pixels()) p = {static_cast<std::uint8_t>(random.below(256)), static_cast<std::uint8_t>(random.below(256)), 7, static_cast<std::uint8_t>(random.below(256))};
  // A square seen from a distance of 1 to all its points: the level is that of the texel_distance alone.
  const test::Mesh mesh = test::rectangle({-1, 1, 0}, {2, 0, 0}, {0, -2, 0}, {0, 0, 1});
  for (const TextureEncoding encoding : {TextureEncoding::linear, TextureEncoding::srgb})
    for (const MipmapFilter mipmaps : {MipmapFilter::none, MipmapFilter::nearest, MipmapFilter::linear})
      for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror, Wrap::border})
        for (const float anisotropy : {1.0f, 4.0f}) {
          TechniqueUniforms uniforms{.shown = Shown::texture, .texture = test::texture_of(noise, encoding)};
          uniforms.sampler = {.mipmaps = mipmaps, .wrap_u = wrap, .wrap_v = wrap, .max_anisotropy = anisotropy};
          uniforms.eye = {0, 0, 1e6f};
          const float level = random.between(-1, 6);
          uniforms.access = {.level_rule = LevelRule::distance, .texel_distance = 1e6f * std::exp2(-level)};
          const Image<Rgba32F> picture = test::render(mesh, test::technique(uniforms), {}, {.width = 16, .height = 16, .colour = ColourFormat::rgba32f}).linear;
          const int x = static_cast<int>(random.below(16)), y = static_cast<int>(random.below(16));
          const Rgba32F right = sample_texture(*uniforms.texture, uniforms.sampler, {.at = {(static_cast<float>(x) + 0.5f) / 16, (static_cast<float>(y) + 0.5f) / 16, 0}, .lod = level});
          INFO("seed 411, level " << level);
          CHECK(picture.at(x, y).r == Approx(right.r).margin(1e-5));
          CHECK(picture.at(x, y).a == Approx(right.a).margin(1e-5));
        }
}

TEST_CASE("texture access: levels mixed by the logarithm of the distance change without jumps", "[pipeline][texture][A04]") {
  const auto texture = level_texture(64);
  TechniqueUniforms uniforms{.shown = Shown::texture, .texture = texture, .sampler = sampler_with(MipmapFilter::linear)};
  // Level 1 is as far as the near edge of the picture, level 6 near the horizon.
  uniforms.access = {.level_rule = LevelRule::distance, .texel_distance = 0.9f};
  constexpr int kRows = 120;
  // Rows from the middle of the picture (where the origin is) down see distances that grow at most so fast.
  const int first = kRows / 2, last = kRows;
  const auto distance_at = [&](int row) {
    const double elevation = std::atan(1.0 / 8), below = std::atan((2 * (row + 0.5) / kRows - 1) * std::tan(kOpening / 2));
    return 1 / std::sin(elevation + below);
  };
  double fastest = 0;
  for (int row = first + 1; row < last; ++row) fastest = std::max(fastest, std::log2(distance_at(row - 1) / distance_at(row)));
  REQUIRE(fastest < 0.2);
  CHECK(largest_step_down(floor_seen(uniforms, kRows, kRows), first, last) <= fastest * 1.02);
  uniforms.sampler = sampler_with(MipmapFilter::nearest);
  CHECK(largest_step_down(floor_seen(uniforms, kRows, kRows), first, last) == 1);
}

TEST_CASE("texture access: with mipmaps the near floor stays as it is and the far one calms down", "[pipeline][texture][A05]") {
  constexpr int kWidth = 128, kRows = 96;
  const auto texture = checks(16);
  for (const LevelRule rule : {LevelRule::derivatives, LevelRule::distance}) {
    const auto seen = [&](MipmapFilter mipmaps) {
      TechniqueUniforms uniforms{.shown = Shown::texture, .texture = texture, .sampler = sampler_with(mipmaps)};
      uniforms.access = {.level_rule = rule, .texel_distance = static_cast<float>(texel_distance(1.0 / 16, kOpening, kRows))};
      return floor_seen(uniforms, kWidth, kRows);
    };
    const Image<Rgba32F> without = seen(MipmapFilter::none), with = seen(MipmapFilter::linear);
    const int near = kRows - 6, horizon = 38;  // in the lowest rows a texel covers more than a pixel
    CHECK(energy(without, with, near, kRows) == 0);
    CHECK(variance(with, horizon, horizon + 4) < 0.1 * variance(without, horizon, horizon + 4));
    CHECK(variance(without, horizon, horizon + 4) > 0.1);
  }
}

TEST_CASE("texture access: the notes' directions on the globe", "[pipeline][texture][B33][B32]") {
  const double third = 1 / std::sqrt(3.0);
  const struct {
    glm::dvec3 direction;
    double u, v;
  } cases[] = {{{1, 0, 0}, 0, 0.5}, {{0, 0, -1}, 0.25, 0.5}, {{-1, 0, 0}, 0.5, 0.5}, {{0, 0, 1}, 0.75, 0.5}, {{third, third, third}, 0.875, 0.69591},
               {{0, 1, 0}, 0, 1}, {{0, -1, 0}, 0, 0}, {{0, 7, 0}, 0, 1}, {{0, 0, -1e-20}, 0.25, 0.5}, {{1e-3, 1, 0}, 0, 0.99968169}, {{0, 1, -1e-4}, 0.25, 0.99996817}};
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    for (const auto& c : cases) {
      TechniqueUniforms uniforms{.shown = Shown::sphere_coordinates};
      uniforms.access.globe_from_world = glm::mat4(0);  // every point lies in this direction
      uniforms.access.globe_from_world[3] = glm::vec4(glm::vec3(c.direction), 1);
      const test::Mesh mesh = test::rectangle({-1, 1, 0}, {2, 0, 0}, {0, -2, 0}, {0, 0, 1});
      const Rgba32F found = test::render(mesh, test::technique(uniforms), {}, {.width = 8, .height = 8, .colour = ColourFormat::rgba32f,
                                         .options = {.threads = 1, .instruction_set = set, .precision = precision}}).linear.at(3, 3);
      CHECK(found.r == Approx(c.u).margin(1e-5));
      CHECK(found.g == Approx(c.v).margin(1e-5));
    }
  });
}

TEST_CASE("texture access: everywhere on the globe u and v are the notes' formulas", "[pipeline][texture][B33]") {
  TechniqueUniforms uniforms{.shown = Shown::sphere_coordinates};
  const test::Mesh mesh = test::rectangle({-1, 1, 0.3f}, {2, 0, 0}, {0, -2, 0}, {0, 0, 1});
  for (const glm::dvec3& axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0.6, 0, 0.8)}) {
    uniforms.access.globe_from_world = rotation(axis, 1.1);
    const Image<Rgba32F> found = test::render(mesh, test::technique(uniforms), {}, {.colour = ColourFormat::rgba32f}).linear;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        const glm::dvec4 point{(x + 0.5) / 32 - 1, 1 - (y + 0.5) / 32, 0.3f, 1};
        const glm::dvec3 n = glm::normalize(glm::dvec3(glm::dmat4(uniforms.access.globe_from_world) * point));
        const glm::dvec3 pole(0, 1, 0), equator(1, 0, 0);
        const double phi = std::acos(-glm::dot(pole, n));
        double u = std::acos(std::clamp(glm::dot(equator, n) / std::sin(phi), -1.0, 1.0)) / 6.283185307179586;
        if (glm::dot(glm::cross(pole, equator), n) < 0) u = 1 - u;
        const double off = std::abs(static_cast<double>(found.at(x, y).r) - u);
        CHECK(std::min(off, 1 - off) < 2e-6);
        CHECK(static_cast<double>(found.at(x, y).g) == Approx(phi / 3.141592653589793).margin(1e-6));
      }
  }
}

TEST_CASE("texture access: the globe's seam and poles read the same level as their surroundings", "[pipeline][texture][B33][B35]") {
  TechniqueUniforms uniforms{.shown = Shown::texture, .texture = level_texture(256), .sampler = sampler_with(MipmapFilter::nearest)};
  uniforms.access.coordinates = TextureAccess::Coordinates::sphere;
  PipelineState state;
  state.culling.cull = CullFace::back;
  for (const glm::dvec3& eye : {glm::dvec3(2.5, 0.01, 0.02), glm::dvec3(0.01, 2.5, 0.02)}) {  // before the seam, above the pole
    state.transform.clip_from_world = test::clip_from_world(eye, 1);
    const Image<Rgba32F> picture = test::render(test::sphere(24), test::technique(uniforms), state, {.width = 128, .height = 128, .colour = ColourFormat::rgba32f}).linear;
    // In the middle a pixel covers 256 / (2 pi) / 74 of a radian's texels at the equator: less than two.
    for (int y = 54; y < 74; ++y)
      for (int x = 54; x < 74; ++x) {
        const Rgba32F& level = picture.at(x, y);
        CHECK((level == Rgba32F{1, 0, 0, 1} || level == Rgba32F{1, 1, 0, 1}));
      }
  }
}

TEST_CASE("texture access: squares on a sphere are narrow at its poles", "[pipeline][texture][B34]") {
  TechniqueUniforms uniforms{.shown = Shown::pattern, .pattern = {.kind = Pattern::Kind::random_squares, .scale = 32}};
  uniforms.access.coordinates = TextureAccess::Coordinates::sphere;
  constexpr int kSize = 512;
  PipelineState state;
  state.culling.cull = CullFace::back;
  state.transform.clip_from_world = glm::mat4(1);
  state.transform.clip_from_world[2][2] = -1;  // parallel, from +z
  const Image<Rgba32F> picture = test::render(test::sphere(64), test::technique(uniforms), state, {.width = kSize, .height = kSize, .colour = ColourFormat::rgba32f}).linear;
  // Half of the 32 squares of a circle of latitude are seen; the middle one is as wide as sin(phi) pi / 16 radii.
  const auto width_of_middle = [&](int row) {
    int left = kSize / 2 + 2, right = left;
    const Rgba32F middle = picture.at(left, row);
    while (picture.at(left - 1, row) == middle) --left;
    while (picture.at(right + 1, row) == middle) ++right;
    return right - left + 1;
  };
  const auto row_of = [&](double latitude) { return static_cast<int>(kSize / 2 * (1 - std::sin(latitude))); };
  for (const double latitude : {0.05, 0.7, 1.2}) {
    const double expected = std::cos(latitude) * 3.14159 / 16 * kSize / 2;
    INFO("latitude " << latitude);
    CHECK(std::abs(width_of_middle(row_of(latitude)) - expected) <= 4);
  }
}

TEST_CASE("texture access: every place and distance gives a colour of the texture", "[pipeline][texture]") {
  const float endless = std::numeric_limits<float>::infinity();
  for (const float odd : {0.0f, endless, std::numeric_limits<float>::quiet_NaN(), 1e38f}) {
    TechniqueUniforms uniforms{.shown = Shown::texture, .texture = checks(), .sampler = sampler_with(MipmapFilter::linear)};
    uniforms.eye = glm::vec3(odd);
    uniforms.access = {.coordinates = TextureAccess::Coordinates::sphere, .globe_from_world = glm::mat4(odd), .level_rule = LevelRule::distance};
    const test::Mesh mesh = test::rectangle({-1, 1, 0}, {2, 0, 0}, {0, -2, 0}, {0, 0, 1});
    const Image<Rgba32F> picture = test::render(mesh, test::technique(uniforms), {}, {.width = 16, .height = 16, .colour = ColourFormat::rgba32f}).linear;
    for (const Rgba32F& pixel : picture.pixels()) CHECK((pixel.r >= 0 && pixel.r <= 1.0001f && pixel.a == 1));
  }
}

}  // namespace tuberia
