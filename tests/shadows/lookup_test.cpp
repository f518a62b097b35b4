// The look-up by itself: every point of a made-up map against the same in double.

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"
#include "tests/support/shadow_scenes.hpp"

namespace tuberia {

namespace {

constexpr int kLookupSide = 48;  // pixels of the pictures

Image<float> random_depths(int width, int height) {
  test::Random random(411);
  Image<float> depths(width, height);
  for (float& d : depths.pixels()) d = random.below(4) == 0 ? 1.0f : random.between(0.2f, 0.8f);
  return depths;
}

/// The square |x|, |y| <= 1 at z = 0.5, whose points have s = 0.9 x + 0.5 (so that some are outside),
/// t = 0.5 - 0.6 y and the depth 0.5; no bias.
ShadowMap made_up_map(const Image<float>& depths, int taps) {
  glm::mat4 map_from_world(1);
  map_from_world[0].x = 0.9f;
  map_from_world[1].y = -0.6f;
  map_from_world[3] = {0.5f, 0.5f, 0, 1};
  return {.depths = std::make_shared<const Texture>(*Texture::create_depth(depths)), .map_from_world = map_from_world, .depth_error = 0, .slope_bias = 0, .taps = taps};
}

test::Mesh middle_square(const glm::vec3& normal = {0, 0, 1}) { return test::rectangle({-1, -1, 0.5f}, {2, 0, 0}, {0, 2, 0}, normal); }

const Light kOverhead{.kind = Light::Kind::directional, .towards = {0, 0, 1}};

/// V of each pixel in its red.
Image<Rgba32F> visibility(const Light& light, const ShadowMap& map, const test::Mesh& mesh = middle_square(), InstructionSet set = best_instruction_set(), Precision precision = Precision::exact) {
  const auto picture = [&](const SurfaceLight& source) {
    return test::render(mesh, test::matt(source), {}, {.width = kLookupSide, .height = kLookupSide, .colour = ColourFormat::rgba32f,
                        .options = {.threads = 1, .instruction_set = set, .precision = precision}}).linear;
  };
  return test::divided(picture({light, map, {}}), picture({light, {}, {}}));
}

std::vector<float> visibilities(const Light& light, const ShadowMap& map, const test::Mesh& mesh = middle_square(), InstructionSet set = best_instruction_set()) {
  std::vector<float> reds;
  const Image<Rgba32F> drawn = visibility(light, map, mesh, set);
  for (const Rgba32F& pixel : drawn.pixels()) reds.push_back(pixel.r);
  return reds;
}

/// The share of [x - n/2, x + n/2] that texel i covers, in texels; for n = 0 whether x is in it.
double overlap(double x, int n, int i) {
  if (n == 0) return std::floor(x) == i ? 1 : 0;
  return std::max(0.0, std::min(x + 0.5 * n, i + 1.0) - std::max(x - 0.5 * n, static_cast<double>(i))) / n;
}

/// The mean of "not farther than the texel" over a box around (x, y), with the border's texels repeated.
double expected_visibility(const Image<float>& depths, double x, double y, int taps, double reference) {
  double sum = 0;
  for (int j = -taps; j < depths.height() + taps; ++j)
    for (int i = -taps; i < depths.width() + taps; ++i) {
      const float texel = depths.at(std::clamp(i, 0, depths.width() - 1), std::clamp(j, 0, depths.height() - 1));
      if (texel == 1.0f || reference <= static_cast<double>(texel)) sum += overlap(x, taps - 1, i) * overlap(y, taps - 1, j);
    }
  return sum;
}

}  // namespace

TEST_CASE("shadow look-ups: the share of a box of texels that lets light pass", "[shadows][A18]") {
  const Image<float> depths = random_depths(7, 5);
  for (const int taps : {1, 2, 3, 4, 8}) {
    const ShadowMap map = made_up_map(depths, taps);
    test::for_every_machine([&](InstructionSet set, Precision precision) {
      const Image<Rgba32F> drawn = visibility(kOverhead, map, middle_square(), set, precision);
      for (int j = 0; j < kLookupSide; ++j)
        for (int i = 0; i < kLookupSide; ++i) {
          const double s = 0.9 * ((i + 0.5) / kLookupSide * 2 - 1) + 0.5, t = 0.5 - 0.6 * (1 - (j + 0.5) / kLookupSide * 2);
          INFO("taps " << taps << ", pixel " << i << ", " << j);
          const bool inside = s >= 0 && s <= 1 && t >= 0 && t <= 1;
          REQUIRE(static_cast<double>(drawn.at(i, j).r) == Approx(inside ? expected_visibility(depths, s * 7, t * 5, taps, 0.5) : 1.0).margin(3e-5));
        }
    });
  }
}

TEST_CASE("shadow look-ups: where all is lit V is 1, where nothing is 0, to the last bit", "[shadows][A13]") {
  for (int taps = 1; taps <= ShadowMap::kMaxTaps; ++taps)
    for (const float depth : {0.75f, 0.25f, 1.0f}) {
      Image<float> depths(6, 6);
      for (float& d : depths.pixels()) d = depth;
      ShadowMap map = made_up_map(depths, taps);
      map.map_from_world[0].x = map.map_from_world[1].y = 0.47f;
      for (const float v : visibilities(kOverhead, map)) REQUIRE(v == (depth > 0.5f ? 1.0f : 0.0f));
    }
}

TEST_CASE("shadow look-ups: behind the light and beyond its far plane", "[shadows][A18]") {
  const Image<float> depths = random_depths(7, 5);
  ShadowMap map = made_up_map(depths, 1);
  map.map_from_world[3].w = -1;  // w = -1 everywhere: behind
  map.map_from_world[3].x = map.map_from_world[3].y = -0.5f;
  for (const float v : visibilities(kOverhead, map)) REQUIRE(v == 1.0f);

  // Beyond the far plane what was drawn still casts shadow, and where nothing was drawn nothing does.
  map = made_up_map(depths, 1);
  map.map_from_world[3].z = 1;
  map.map_from_world[0].x = map.map_from_world[1].y = 0.4f;
  const std::vector<float> beyond = visibilities(kOverhead, map);
  const auto lit = std::count(beyond.begin(), beyond.end(), 1.0f);
  CHECK(lit > kLookupSide * kLookupSide / 10);
  CHECK(lit < kLookupSide * kLookupSide / 2);
}

TEST_CASE("shadow look-ups: the same bits on every instruction set", "[shadows][A18]") {
  const Image<float> depths = random_depths(31, 17);
  ShadowMap map = made_up_map(depths, 3);
  map.slope_bias = 1.25f;
  map.normal_offset = 0.5f;
  map.constant_bias = 0.01f;
  map.texel_right = {0.03f, 0, 0.01f};
  map.texel_down = {0, 0.05f, 0.02f};
  map.map_from_world[1].w = 0.3f;
  const Light lamp{.kind = Light::Kind::point, .towards = {0.3f, 0.2f, 1.5f}};
  const test::Mesh mesh = middle_square({0.2f, -0.3f, 0.9f});
  const Image<Rgba32F> first = visibility(lamp, map, mesh, InstructionSet::baseline);
  test::for_every_instruction_set([&](InstructionSet set) { CHECK(visibility(lamp, map, mesh, set) == first); });
}

TEST_CASE("shadow look-ups: numbers that are not finite, and lights at the surface, stay within 0 and 1", "[shadows][A18]") {
  const Image<float> depths = random_depths(7, 5);
  const auto check = [&](const ShadowMap& map, const Light& light, const glm::vec3& normal) {
    test::for_every_instruction_set([&](InstructionSet set) {
      for (const float v : visibilities(light, map, middle_square(normal), set)) REQUIRE((v >= 0.0f && v <= 1.0f));
    });
  };
  const auto nan = std::numeric_limits<float>::quiet_NaN();
  ShadowMap map = made_up_map(depths, 3);
  map.slope_bias = map.normal_offset = 1;
  map.texel_right = {0.1f, 0, 0};
  check(map, kOverhead, {nan, 0, 1});
  check(map, kOverhead, {0, 0, 0});
  check(map, {.kind = Light::Kind::directional, .towards = {0, 0, 0}}, {0, 0, 1});
  check(map, {.kind = Light::Kind::point, .towards = {1.0f / kLookupSide, 1.0f / kLookupSide, 0.5f}}, {0, 0, 1});
  ShadowMap huge = map;
  huge.map_from_world[0] = {3e38f, 3e38f, 3e38f, 3e38f};
  huge.map_from_world[3] = {3e38f, -3e38f, 3e38f, 0};
  check(huge, kOverhead, {1, 0, 1});
  huge.constant_bias = 3e38f;
  huge.texel_right = glm::vec3(3e38f);
  check(huge, kOverhead, {1, 1, 1});
  // A surface whose normal is no number faces no light, nor does one that is turned away.
  for (const glm::vec3& normal : {glm::vec3(nan), glm::vec3(0, 0, -1), glm::vec3(0)})
    for (const float v : visibilities(kOverhead, map, middle_square(normal))) REQUIRE(v == 0.0f);
}

TEST_CASE("shadow look-ups: maps that cannot be compared with are refused by name", "[shadows]") {
  const ShadowMap good = made_up_map(random_depths(7, 5), 1);
  CHECK_FALSE(refusal_of(good));
  const auto refused = [&](auto&& spoil) {
    ShadowMap map = good;
    spoil(map);
    const Refusal refusal = refusal_of(map);
    return refusal ? refusal->message : std::string();
  };
  const auto nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  CHECK(refused([](ShadowMap& m) { m.depths = nullptr; }) == "depths is missing");
  CHECK(refused([](ShadowMap& m) { m.depths = test::texture_of(Image<Rgba8>(4, 4)); }) == "depths is not a rectangle or cube of depths (depth32f)");
  CHECK(refused([](ShadowMap& m) { m.taps = 0; }) == "taps is 0, outside 1 to 8");
  CHECK(refused([](ShadowMap& m) { m.taps = 9; }) == "taps is 9, outside 1 to 8");
  CHECK(refused([&](ShadowMap& m) { m.map_from_world[2].y = nan; }) == "map_from_world is nan; it must be finite");
  CHECK(refused([&](ShadowMap& m) { m.texel_down.z = infinity; }) == "texel_down.z is inf; it must be finite");
  CHECK(refused([&](ShadowMap& m) { m.cube_depth.y = nan; }) == "cube_depth.y is nan; it must be finite");
  CHECK(refused([](ShadowMap& m) { m.slope_bias = -1; }) == "slope_bias is -1; it must be finite and not negative");
  CHECK(refused([&](ShadowMap& m) { m.constant_bias = nan; }) == "constant_bias is nan; it must be finite and not negative");
  CHECK(refused([&](ShadowMap& m) { m.normal_offset = infinity; }) == "normal_offset is inf; it must be finite and not negative");
  CHECK(refused([](ShadowMap& m) { m.depth_error = -1; }) == "depth_error is -1; it must be finite and not negative");

  CHECK(refusal_of(ProjectedTexture{})->message == "texture is missing");
  ProjectedTexture projected{.texture = test::texture_of(Image<Rgba8>(4, 4))};
  CHECK_FALSE(refusal_of(projected));
  projected.sampler.max_anisotropy = 0;
  CHECK(refusal_of(projected)->message == "the sampler's max_anisotropy is 0, outside 1 to 16");
}

}  // namespace tuberia
