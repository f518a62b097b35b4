#include "raster/cube_map.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "raster/sample_texture.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"

namespace tuberia {
namespace {

/// A cube of floats whose texels show a function of the unit direction through their centres.
template <class Function>
Texture baked_cube(int size, const Function& function) {
  Texture cube = *Texture::create_empty({.kind = TextureKind::cube, .format = TextureFormat::rgba32f, .width = size, .height = size});
  for (int face = 0; face < 6; ++face) {
    Image<Rgba32F> image(size, size);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const auto n = static_cast<float>(size);
        image.at(x, y) = function(glm::normalize(cube_direction({face, (static_cast<float>(x) + 0.5f) / n, (static_cast<float>(y) + 0.5f) / n})));
      }
    REQUIRE(cube.replace(0, face, image).ok());
  }
  cube.generate_mipmaps();
  return cube;
}

Rgba32F half_of(const glm::vec3& d) { return {0.5f + 0.5f * d.x, 0.5f + 0.5f * d.y, 0.5f + 0.5f * d.z, 1}; }

Rgba32F looked(const Texture& cube, const Sampler& sampler, const glm::vec3& direction, InstructionSet set, Precision precision) {
  const TextureLookup lookup{.at = direction};
  Rgba32F colour;
  sample_texture(cube, sampler, std::span(&lookup, 1), std::span(&colour, 1), set, precision);
  return colour;
}

const Sampler kBaseOnly{.mipmaps = MipmapFilter::none};

}  // namespace

// notes 15.20
TEST_CASE("cube map: which face a direction meets, and where", "[raster][case-39]") {
  struct Known {
    glm::vec3 direction;
    CubePoint point;
  };
  for (const Known& k : {Known{{1, 1, 1}, {4, 1, 0}}, {{1, 1, 0}, {2, 1, 0.5f}}, {{1, 0, 1}, {4, 1, 0.5f}}, {{-1, -1, -1}, {5, 1, 1}},
                         {{1, 2, 3}, {4, 2 / 3.0f, 1 / 6.0f}}, {{-3, 1, 2}, {1, 5 / 6.0f, 1 / 3.0f}}, {{1e-30f, 2e-30f, -3e-30f}, {5, 1 / 3.0f, 1 / 6.0f}},
                         {{0.2f, -0.3f, 0.9f}, {4, 0.611111f, 0.666667f}}, {{-1, 0, 0}, {1, 0.5f, 0.5f}}, {{0, 0, 0}, {4, 0, 0}}}) {
    INFO("direction " << k.direction.x << " " << k.direction.y << " " << k.direction.z);
    const CubePoint found = cube_point(k.direction);
    CHECK(found.face == k.point.face);
    CHECK(found.s == Approx(k.point.s).margin(1e-6));
    CHECK(found.t == Approx(k.point.t).margin(1e-6));
  }
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  for (const glm::vec3& odd : {glm::vec3(nan, 0, 0), glm::vec3(nan, nan, nan), glm::vec3(inf, inf, inf), glm::vec3(0, -inf, 1)}) {
    const CubePoint found = cube_point(odd);
    CHECK((found.face >= 0 && found.face < 6 && found.s >= 0 && found.s <= 1 && found.t >= 0 && found.t <= 1));
  }
}

TEST_CASE("cube map: a point's direction leads back to it", "[raster]") {
  test::Random random(181);
  for (int i = 0; i < 300; ++i) {
    const CubePoint point{static_cast<int>(random.below(6)), random.between(0.01f, 0.99f), random.between(0.01f, 0.99f)};
    const CubePoint back = cube_point(cube_direction(point) * random.between(0.1f, 9));
    INFO("seed 181, point " << i);
    CHECK(back.face == point.face);
    CHECK(back.s == Approx(point.s).margin(1e-5));
    CHECK(back.t == Approx(point.t).margin(1e-5));
  }
}

TEST_CASE("cube map: the kernels meet the same faces and texels", "[raster][exact]") {
  test::Random random(182);
  Texture cube = *Texture::create_empty({.kind = TextureKind::cube, .width = 8, .height = 8, .with_mipmaps = false});
  for (int face = 0; face < 6; ++face) {
    Image<Rgba8> image(8, 8);
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) image.at(x, y) = {static_cast<std::uint8_t>(face), static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 255};
    REQUIRE(cube.replace(0, face, image).ok());
  }
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    for (int i = 0; i < 500; ++i) {
      // Small whole numbers have many ties.
      const glm::vec3 direction = i % 2 == 0 ? glm::vec3(random.below(5) - 2, random.below(5) - 2, random.below(5) - 2)
                                             : glm::vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
      const CubePoint point = cube_point(direction);
      const auto texel = [](float s) { return std::min(7.0f, std::floor(s * 8)); };
      const Rgba32F found = looked(cube, {.texels = TexelFilter::nearest}, direction, set, precision);
      INFO("seed 182, direction " << direction.x << " " << direction.y << " " << direction.z);
      CHECK(255 * found.r == Approx(point.face).margin(1e-4));
      CHECK(255 * found.g == Approx(texel(point.s)).margin(1e-4));
      CHECK(255 * found.b == Approx(texel(point.t)).margin(1e-4));
    }
  });
}

TEST_CASE("cube map: a smooth function stays smooth across edges and corners", "[raster][case-40]") {
  test::Random random(183);
  const Texture cube = baked_cube(32, half_of);
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    // Filtering is off by less than the function bends within a texel, everywhere alike.
    for (int i = 0; i < 1000; ++i) {
      glm::vec3 d{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
      if (i % 2 == 0) d[static_cast<int>(random.below(3))] = d[0] > 0 ? 1.0f : -1.0f, d.y = d.y > 0 ? 1.001f : -1.001f;
      const Rgba32F found = looked(cube, kBaseOnly, d, set, precision), right = half_of(glm::normalize(d));
      const float error = std::max({std::abs(found.r - right.r), std::abs(found.g - right.g), std::abs(found.b - right.b)});
      // At a corner the three texels' mean stands for the function 1/48 of the cube's edge away.
      if (error > 0.009f) FAIL("seed 183: off by " << error << " at " << d.x << " " << d.y << " " << d.z);
    }
    // A last place to either side of an edge.
    for (int i = 0; i < 300; ++i) {
      const auto axis = static_cast<int>(random.below(3)), other = (axis + 1) % 3;
      glm::vec3 edge{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
      edge[axis] = edge[axis] > 0 ? 1.0f : -1.0f;
      edge[other] = edge[other] > 0 ? 1.0f : -1.0f;
      glm::vec3 inside = edge, beyond = edge;
      inside[other] = std::nextafter(edge[other], 0.0f), beyond[other] = std::nextafter(edge[other], edge[other] * 9);
      const Rgba32F a = looked(cube, kBaseOnly, inside, set, precision), b = looked(cube, kBaseOnly, beyond, set, precision);
      if (std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}) > 1 / 255.0f) FAIL("seed 183: a seam at " << edge.x << " " << edge.y << " " << edge.z);
    }
  });
}

TEST_CASE("cube map: three texels share a corner evenly", "[raster][case-40]") {
  for (const int size : {1, 2, 5}) {
    test::Random random(184);
    const Texture cube = baked_cube(size, [&](const glm::vec3&) { return Rgba32F{random.between(0, 1), 0, 0, 1}; });
    test::for_every_machine([&](InstructionSet set, Precision precision) {
      for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 d{corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1};
        float mean = 0;
        for (int axis = 0; axis < 3; ++axis) {
          glm::vec3 inside = d * 0.999f;
          inside[axis] = d[axis];
          mean += looked(cube, {.texels = TexelFilter::nearest, .mipmaps = MipmapFilter::none}, inside, set, precision).r / 3;
        }
        INFO("seed 184, size " << size << ", corner " << corner);
        CHECK(looked(cube, kBaseOnly, d, set, precision).r == Approx(mean).margin(1e-5));
      }
    });
  }
}

TEST_CASE("cube map: the level of detail follows from steps on the face", "[raster][case-37]") {
  Texture meter = *Texture::create_empty({.kind = TextureKind::cube, .format = TextureFormat::rgba32f, .width = 64, .height = 64});
  for (int i = 0; i < meter.level_count(); ++i)
    for (int face = 0; face < 6; ++face)
      REQUIRE(meter.replace(i, face, Image<Rgba32F>(64 >> i, 64 >> i, {static_cast<float>(i), 0, 0, 1})).ok());
  for (int face = 0; face < 6; ++face)
    for (const float length : {1.0f, 0.125f, 40.0f}) {
      const CubePoint point{face, 0.5f, 0.25f};
      const glm::vec3 at = cube_direction(point) * length;
      const auto moved = [&](float s, float t) { return cube_direction({face, point.s + s / 64, point.t + t / 64}) * length - at; };
      CHECK(sample_texture(meter, {}, {.at = at, .dx = moved(4, 0), .dy = moved(0, 1)}).r == Approx(2).margin(1e-4));
      CHECK(sample_texture(meter, {.max_anisotropy = 4}, {.at = at, .dx = moved(8, 0), .dy = moved(0, 2)}).r == Approx(1).margin(1e-4));
      // Growing along itself a direction stays where it is.
      CHECK(sample_texture(meter, {}, {.at = at, .dx = at, .dy = moved(0, 2)}).r == Approx(1).margin(1e-4));
    }
}

}  // namespace tuberia
