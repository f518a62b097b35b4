// What programs read from environment maps, against the definitions in double.

#include <catch2/catch.hpp>

#include <limits>
#include <numbers>

#include "pipeline/programs/surface.hpp"
#include "tests/support/environments.hpp"
#include "tests/support/every_instruction_set.hpp"

namespace tuberia {
namespace {

using test::largest_component;
using test::looked_up;
using test::pixel_direction;
using test::radiance_of;

EnvironmentMap unfiltered(Result<EnvironmentMap> map) {
  REQUIRE(map);
  map->sampler.mipmaps = MipmapFilter::none;
  return *map;
}

/// The mean difference over all pixels and channels of the pictures of all six faces.
double mean_difference(const EnvironmentMap& a, const EnvironmentMap& b, int size) {
  double sum = 0;
  for (int face = 0; face < 6; ++face) {
    const Image<Rgba32F> of_a = looked_up(a, face, size), of_b = looked_up(b, face, size);
    for (std::size_t i = 0; i < of_a.pixels().size(); ++i) {
      const glm::dvec3 apart = glm::abs(radiance_of(of_a.pixels()[i]) - radiance_of(of_b.pixels()[i]));
      sum += (apart.x + apart.y + apart.z) / 3;
    }
  }
  return sum / (6.0 * size * size);
}

/// A map each of whose levels shows its own number.
EnvironmentMap level_meter(EnvironmentMap::Kind kind, int width, int height) {
  Texture meter = *Texture::create_empty({.format = TextureFormat::rgba32f, .width = width, .height = height});
  for (int i = 0; i < meter.level_count(); ++i) {
    const Image<Rgba32F> level(meter.level(i).width, meter.level(i).height, {static_cast<float>(i), 0, 0, 1});
    REQUIRE(meter.replace(i, 0, level));
  }
  return {.kind = kind, .texture = std::make_shared<const Texture>(std::move(meter)), .sampler = {}};
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

}  // namespace

TEST_CASE("environment: programs read each map where its definition says", "[environment][A29][A32][A33][B37]") {
  const Image<Rgba32F> panorama = test::noise_image(64, 32, 611), ball = test::noise_image(48, 48, 612);
  CubeImages cube;
  for (std::size_t face = 0; face < 6; ++face) cube[face] = test::noise_image(16, 16, 613 + face);
  struct Case {
    const char* name;
    EnvironmentMap map;
    Surroundings expected;
  };
  const Case cases[] = {{"panorama", unfiltered(panorama_map(panorama)), panorama_surroundings(panorama)},
                        {"sphere map", unfiltered(sphere_map(ball)), sphere_map_surroundings(ball)},
                        {"cube", unfiltered(cube_map(cube)), cube_surroundings(cube)}};
  constexpr int kSize = 40;
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    for (const Case& each : cases)
      for (int face = 0; face < 6; ++face) {
        const Image<Rgba32F> seen = looked_up(each.map, face, kSize, {.threads = 1, .instruction_set = set, .precision = precision});
        double most = 0;
        for (int y = 0; y < kSize; ++y)
          for (int x = 0; x < kSize; ++x) {
            // Where three faces of the cube meet, the fourth texel is defined otherwise in float and in double.
            const bool is_corner = (x == 0 || x == kSize - 1) && (y == 0 || y == kSize - 1);
            if (is_corner && each.map.kind == EnvironmentMap::Kind::cube) continue;
            const glm::dvec3 expected = each.expected.radiance(pixel_direction(face, kSize, x, y));
            most = std::max(most, largest_component(radiance_of(seen.at(x, y)) - expected));
          }
        INFO(each.name << ", face " << face);
        CHECK(most < 2e-4);
      }
  });
}

// The fourth acceptance check of environment maps: every face and edge is among the directions.
TEST_CASE("environment: cube, sphere map and panorama of one sky look alike", "[environment][A29][A33][A34][B37]") {
  const Surroundings sky = test::sunless_sky();
  const auto panorama = panorama_map(panorama_of(sky, 512, 256)), ball = sphere_map(sphere_map_of(sky, 512)), cube = cube_map(cube_of(sky, 128));
  REQUIRE((panorama && ball && cube));
  const double codes_by_ball = 255 * mean_difference(*panorama, *ball, 64), codes_by_cube = 255 * mean_difference(*panorama, *cube, 64);
  const double codes_between = 255 * mean_difference(*ball, *cube, 64);
  INFO("mean differences in codes: " << codes_by_ball << ", " << codes_by_cube << ", " << codes_between);
  CHECK(codes_by_ball < 2);
  CHECK(codes_by_cube < 2);
  CHECK(codes_between < 2);
  // The same sky turned away by the matrix does not.
  EnvironmentMap turned = *panorama;
  turned.map_from_world = {{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};
  CHECK(255 * mean_difference(turned, *cube, 64) > 4);
}

TEST_CASE("environment: the matrix turns the map", "[environment]") {
  const EnvironmentMap map = unfiltered(panorama_map(test::noise_image(64, 32, 621)));
  // The map's +x shows what lies in the world's +z: face +z of the turned map is face +x of the other.
  EnvironmentMap turned = map;
  turned.map_from_world = {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
  const Image<Rgba32F> straight = looked_up(map, 0, 16), round = looked_up(turned, 4, 16);
  for (std::size_t i = 0; i < straight.pixels().size(); ++i)
    CHECK(largest_component(radiance_of(straight.pixels()[i]) - radiance_of(round.pixels()[i])) < 1e-4);
}

TEST_CASE("environment: exact look-ups have the same bits on every machine", "[environment][exact]") {
  const Surroundings sky = test::sunless_sky();
  const EnvironmentMap maps[] = {*panorama_map(panorama_of(sky, 128, 64)), *sphere_map(sphere_map_of(sky, 64)), *cube_map(cube_of(sky, 32))};
  for (const EnvironmentMap& map : maps)
    for (int face = 0; face < 6; ++face) {
      const Image<Rgba32F> first = looked_up(map, face, 24, {.threads = 1, .instruction_set = supported_instruction_sets()[0]});
      test::for_every_instruction_set([&](InstructionSet set) { CHECK(looked_up(map, face, 24, {.threads = 2, .instruction_set = set}) == first); });
    }
}

TEST_CASE("environment: the level of detail follows the angle, across seam, poles and rim", "[environment][A33][A32]") {
  struct Case {
    EnvironmentMap map;
    double texels_per_radian;
  };
  const Case cases[] = {{level_meter(EnvironmentMap::Kind::panorama, 1024, 512), 512 / std::numbers::pi},
                        {level_meter(EnvironmentMap::Kind::sphere, 512, 512), 512 / 4.0}};
  constexpr int kSize = 32;
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    for (const Case& each : cases)
      for (int face = 0; face < 6; ++face) {  // +y, -y: the poles; +z: the seam; -z: the rim
        const Image<Rgba32F> seen = looked_up(each.map, face, kSize, {.threads = 1, .instruction_set = set, .precision = precision});
        double most = 0;
        for (int y = 0; y < kSize; ++y)
          for (int x = 0; x < kSize; ++x) {
            const int left = x & ~1, top = y & ~1;
            const glm::dvec3 here = pixel_direction(face, kSize, left, top);
            const double angle = std::max(angle_between(here, pixel_direction(face, kSize, left + 1, top)),
                                          angle_between(here, pixel_direction(face, kSize, left, top + 1)));
            most = std::max(most, std::abs(static_cast<double>(seen.at(x, y).r) - std::log2(angle * each.texels_per_radian)));
          }
        INFO("face " << face);
        CHECK(most < 2e-3);  // the chord for the angle: 1 / 24 of its square
      }
  });
}

TEST_CASE("environment: a direction that is none reads what lies at +z", "[environment]") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const EnvironmentMap maps[] = {unfiltered(panorama_map(test::noise_image(32, 16, 631))), unfiltered(sphere_map(test::noise_image(16, 16, 632))),
                                 unfiltered(cube_map({test::noise_image(8, 8, 1), test::noise_image(8, 8, 2), test::noise_image(8, 8, 3),
                                                      test::noise_image(8, 8, 4), test::noise_image(8, 8, 5), test::noise_image(8, 8, 6)}))};
  const auto colour_towards = [](const EnvironmentMap& map, glm::vec3 direction, InstructionSet set) {
    test::Studio studio(test::float_canvas(4, {.threads = 1, .instruction_set = set}));
    const std::array<glm::vec4, 3> directions{glm::vec4(direction, 0), glm::vec4(direction, 0), glm::vec4(direction, 0)};
    PipelineState state;
    state.depth = kDepthOff;
    studio.draw({.clip_positions = test::FaceOfDirections::kClipPositions, .custom = directions}, environment_background(map), state);
    return studio.target().linear_image().at(1, 1);
  };
  test::for_every_instruction_set([&](InstructionSet set) {
    for (const EnvironmentMap& map : maps) {
      const Rgba32F ahead = colour_towards(map, {0, 0, 1}, set);
      CHECK(colour_towards(map, {0, 0, 0}, set) == ahead);
      CHECK(colour_towards(map, {nan, 0.5f, 0}, set) == ahead);
      CHECK(colour_towards(map, {0, 0, 3e-30f}, set) == ahead);
      const Rgba32F behind = colour_towards(map, {0, 0, -1}, set);
      CHECK(std::isfinite(behind.r + behind.g + behind.b));
    }
  });
}

TEST_CASE("environment: maps that no program can read are refused", "[environment]") {
  const auto rectangle = panorama_map(test::noise_image(4, 2, 641)), cube = cube_map(cube_of(test::sunless_sky(), 2));
  REQUIRE((rectangle && cube));
  const auto refused_as = [](EnvironmentMap map, const char* reason) {
    const Refusal refusal = refusal_of(map);
    REQUIRE(refusal);
    CHECK(refusal->message.find(reason) != std::string::npos);
    test::Studio studio(test::float_canvas(4));
    const DrawCall behind{.mesh = test::FaceOfDirections(0).view(), .program = environment_background(map), .state = {}};
    CHECK_FALSE(studio.pipeline().draw(studio.target(), behind));
    SurfaceUniforms uniforms;
    uniforms.environment = map;
    const Refusal of_surface = surface(uniforms).interface().refusal(&uniforms);
    REQUIRE(of_surface);
    CHECK(of_surface->message.find(reason) != std::string::npos);
  };
  using Kind = EnvironmentMap::Kind;
  refused_as({.kind = Kind::cube, .texture = nullptr, .sampler = {}}, "no texture");
  refused_as({.kind = Kind::cube, .texture = rectangle->texture, .sampler = {}}, "no cube");
  refused_as({.kind = Kind::panorama, .texture = cube->texture, .sampler = {}}, "no rectangle");
  refused_as({.kind = Kind::sphere, .texture = std::make_shared<const Texture>(*Texture::create_depth(Image<float>(2, 2))), .sampler = {}}, "depths");
  refused_as({.kind = static_cast<Kind>(9), .texture = cube->texture, .sampler = {}}, "kind is 9");
  EnvironmentMap skewed = *cube;
  skewed.map_from_world[1][2] = std::numeric_limits<float>::infinity();
  refused_as(skewed, "map_from_world[1]");
  EnvironmentMap odd = *cube;
  odd.sampler.max_anisotropy = 0;
  refused_as(odd, "anisotropy");
  CHECK_FALSE(refusal_of(EnvironmentMap{}));
  CHECK(looked_up({}, 0, 4).at(2, 2) == Rgba32F{0, 0, 0, 1});

  Image<Rgba32F> spoilt(4, 2);
  spoilt.at(3, 1).b = std::numeric_limits<float>::infinity();
  CHECK(panorama_map(spoilt).error().message.find("texel (3, 1) has b = inf") != std::string::npos);
  CHECK_FALSE(sphere_map(spoilt));
  CHECK_FALSE(panorama_map({}));
  CHECK_FALSE(cube_map({}));
}

}  // namespace tuberia
