#include "raster/texture.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "math/colour.hpp"
#include "tests/support/random.hpp"

namespace tuberia {

namespace {

/// The red code of the last level, which is one texel.
int mean_code(const Image<Rgba8>& image, TextureEncoding encoding) {
  const Texture texture = *Texture::create(image, encoding);
  const Image<Rgba8> last = texture.level_image(texture.level_count() - 1);
  CHECK((last.width() == 1 && last.height() == 1));
  return last.at(0, 0).r;
}

double mean_red(const Image<Rgba8>& image) {
  double sum = 0;
  for (const Rgba8& p : image.pixels()) sum += p.r;
  return sum / static_cast<double>(image.pixels().size());
}

Image<Rgba8> random_image(std::uint64_t seed, int width, int height) {
  test::Random random(seed);
  Image<Rgba8> image(width, height);
  for (Rgba8& p : image.pixels())
    p = {static_cast<std::uint8_t>(random.below(256)), static_cast<std::uint8_t>(random.below(256)), static_cast<std::uint8_t>(random.below(256)), 255};
  return image;
}

}  // namespace

// notes 15.10
TEST_CASE("texture: each level is the mean of the finer one", "[raster][A02]") {
  Image<Rgba32F> whole_numbers(2, 2);
  for (int i = 0; i < 4; ++i) whole_numbers.at(i % 2, i / 2).r = static_cast<float>(i);
  CHECK(Texture::create(whole_numbers)->float_level_image(1).at(0, 0).r == 1.5f);
  Image<Rgba8> square(2, 2);
  square.at(0, 0).r = 0, square.at(1, 0).r = 40, square.at(0, 1).r = 80, square.at(1, 1).r = 120;
  CHECK(mean_code(square, TextureEncoding::linear) == 60);

  Image<Rgba8> checks(8, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) checks.at(x, y).r = (x + y) % 2 == 0 ? 255 : 0;
  const Texture texture = *Texture::create(checks, TextureEncoding::linear);
  for (int level = 1; level < texture.level_count(); ++level) {
    const Image<Rgba8> image = texture.level_image(level);
    for (const Rgba8& texel : image.pixels()) CHECK(texel.r == 128);  // 127.5, rounded
  }

  const Image<Rgba8> noise = random_image(121, 256, 256);
  const Texture chain = *Texture::create(noise, TextureEncoding::linear);
  CHECK(chain.level_count() == 9);
  for (int level = 0; level < 9; ++level) {
    CHECK(chain.level(level).width == 256 >> level);
    CHECK(mean_red(chain.level_image(level)) == Approx(mean_red(noise)).margin(0.5));
  }
}

TEST_CASE("texture: alpha is averaged as it is in both encodings", "[raster]") {
  Image<Rgba8> alpha(2, 1);
  alpha.at(0, 0).a = 0;
  for (const TextureEncoding encoding : {TextureEncoding::linear, TextureEncoding::srgb})
    CHECK(Texture::create(alpha, encoding)->level_image(1).at(0, 0).a == 128);
  CHECK(Texture::create(Image<Rgba8>(64, 64), TextureEncoding::linear, false)->level_count() == 1);
}

TEST_CASE("texture: halving an odd size loses no texel", "[raster][case-43]") {
  for (const auto& [width, height] : {std::pair{5, 3}, {7, 7}, {13, 1}, {1, 9}, {31, 17}, {6, 5}}) {
    const Image<Rgba8> image = random_image(122, width, height);
    INFO("seed 122, " << width << "x" << height);
    CHECK(std::abs(mean_code(image, TextureEncoding::linear) - mean_red(image)) <= 0.5 + 1e-4);
  }
}

TEST_CASE("texture: a constant stays constant on every level", "[raster][case-42]") {
  for (const TextureEncoding encoding : {TextureEncoding::linear, TextureEncoding::srgb})
    for (int code = 0; code < 256; ++code) {
      const auto c = static_cast<std::uint8_t>(code);
      const Texture texture = *Texture::create(Image<Rgba8>(7, 5, {c, c, c, c}), encoding);
      for (int level = 0; level < texture.level_count(); ++level) {
        const Image<Rgba8> image = texture.level_image(level);
        for (const Rgba8& texel : image.pixels())
          if (texel != Rgba8{c, c, c, c}) FAIL("code " << code << ", level " << level);
      }
    }
}

TEST_CASE("texture: a constant of floats stays constant to the last bit on every level", "[raster][case-42]") {
  test::Random random(42);
  for (int i = 0; i < 500; ++i) {
    const Rgba32F constant{random.between(-8, 8), std::exp2(random.between(-20, 20)), 7.77f, 0.9f};
    const int width = 1 + static_cast<int>(random.below(17)), height = 1 + static_cast<int>(random.below(17));
    INFO("seed 42, texture " << i << " of " << width << " x " << height);
    const Texture texture = *Texture::create(Image<Rgba32F>(width, height, constant));
    for (int level = 0; level < texture.level_count(); ++level) {
      const Image<Rgba32F> image = texture.float_level_image(level);
      CHECK(std::all_of(image.pixels().begin(), image.pixels().end(), [&](const Rgba32F& texel) { return texel == constant; }));
    }
  }
}

TEST_CASE("texture: sizes out of range are refused", "[raster]") {
  CHECK(!Texture::create(Image<Rgba8>(), TextureEncoding::linear).ok());
  const auto refused = Texture::create(Image<Rgba8>(16385, 1), TextureEncoding::linear);
  REQUIRE(!refused.ok());
  CHECK_THAT(refused.error().message, Catch::Matchers::Contains("16385"));
}

}  // namespace tuberia
