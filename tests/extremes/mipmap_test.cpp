// Means of light, and what filters may be off by: rules T4 and T6, cases 41 and 43.

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "math/colour.hpp"
#include "raster/sample_texture.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/lookups.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia {

using test::for_every_instruction_set;

namespace {

/// The sRGB code, with its fraction, of the mean light of some codes.
double code_of_mean_light(std::initializer_list<int> codes) {
  double sum = 0;
  for (const int code : codes) sum += linear_from_srgb(code / 255.0);
  return 255 * srgb_from_linear(sum / static_cast<double>(codes.size()));
}

Image<Rgba8> row_image(const std::vector<int>& codes) {
  Image<Rgba8> image(static_cast<int>(codes.size()), 1);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const auto code = static_cast<std::uint8_t>(codes[i]);
    image.at(static_cast<int>(i), 0) = {code, code, code, 255};
  }
  return image;
}

/// The code that a target of the same encoding gets from the smallest level of a row.
int drawn_mean(const std::vector<int>& codes, TextureEncoding encoding, InstructionSet set) {
  const test::Mesh whole = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, 4096);
  const auto texture = test::texture_of(row_image(codes), encoding);
  test::Studio studio({.width = 16, .height = 16, .colour = encoding == TextureEncoding::srgb ? ColourFormat::srgb8 : ColourFormat::rgba8,
                       .options = {.threads = 1, .instruction_set = set}});
  studio.draw(whole.view(), textured({.texture = texture, .sampler = {}}));
  return studio.target().colour_image().at(9, 9).r;
}

/// What lies in the reach of a lookup's weights, by definition: its value, and the differences that weights choose among.
struct Filtered {
  double value = 0, contrast = 0;
};

Filtered filtered_level(const Texture& texture, int level, double u, double v) {
  const Image<Rgba32F> image = texture.float_level_image(level);
  const double x = u * image.width() - 0.5, y = v * image.height() - 0.5;
  const auto texel = [&](double column, double row) {
    const auto wrapped = [](double i, int n) { return static_cast<int>(i - std::floor(i / n) * n); };
    return static_cast<double>(image.at(wrapped(column, image.width()), wrapped(row, image.height())).r);
  };
  const double left = std::floor(x), top = std::floor(y), s = x - left, t = y - top;
  const double taps[4] = {texel(left, top), texel(left + 1, top), texel(left, top + 1), texel(left + 1, top + 1)};
  const auto [least, most] = std::minmax_element(taps, taps + 4);
  return {(1 - t) * ((1 - s) * taps[0] + s * taps[1]) + t * ((1 - s) * taps[2] + s * taps[3]), *most - *least};
}

}  // namespace

TEST_CASE("mipmaps: light is averaged, not codes", "[extremes][T6][case-41]") {
  CHECK(code_of_mean_light({0, 255}) == Approx(187.516).margin(5e-4));
  CHECK(code_of_mean_light({64, 192}) == Approx(146.41).margin(5e-3));
  CHECK(code_of_mean_light({10, 20, 200, 250}) == Approx(166.896).margin(5e-4));
  CHECK(srgb_code_from_linear(0.5) == 188);
  for_every_instruction_set([](InstructionSet set) {
    CHECK(drawn_mean({0, 255}, TextureEncoding::srgb, set) == 188);
    CHECK(drawn_mean({0, 255}, TextureEncoding::linear, set) == 128);
    CHECK(drawn_mean({64, 192}, TextureEncoding::srgb, set) == 146);
    CHECK(drawn_mean({10, 20, 200, 250}, TextureEncoding::srgb, set) == 167);
    CHECK(drawn_mean({10, 20, 200, 250}, TextureEncoding::linear, set) == 120);
  });
}

TEST_CASE("mipmaps: all 256 sRGB codes survive texture, light and target", "[extremes][T6][case-41]") {
  Image<Rgba8> all(16, 16);
  for (int i = 0; i < 256; ++i) {
    const auto code = static_cast<std::uint8_t>(i);
    all.at(i % 16, i / 16) = {code, code, code, 255};
  }
  test::Mesh whole = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1});
  whole.texcoords = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};  // v runs down
  for_every_instruction_set([&](InstructionSet set) {
    for (const TexelFilter filter : {TexelFilter::nearest, TexelFilter::bilinear}) {
      test::Studio studio({.width = 16, .height = 16, .colour = ColourFormat::srgb8, .options = {.threads = 1, .instruction_set = set}});
      studio.draw(whole.view(), textured({.texture = test::texture_of(all, TextureEncoding::srgb), .sampler = {.texels = filter}}));
      CHECK(studio.target().colour_image() == all);
    }
  });
}

TEST_CASE("mipmaps: levels are rounded once, from parents that were not", "[extremes][T6]") {
  const auto last_code = [](const Image<Rgba8>& image) {
    const Texture texture = *Texture::create(image, TextureEncoding::linear);
    return static_cast<int>(texture.level_image(texture.level_count() - 1).at(0, 0).r);
  };
  // Means of 0.75 and of 0.375; rounded on the way, the second one would be 0.5 of quarters that round up.
  Image<Rgba8> image(4, 4, {0, 0, 0, 255});
  for (int y = 1; y < 4; y += 2)
    for (int x = 1; x < 4; x += 2) image.at(x, y).r = 3;
  CHECK(last_code(image) == 1);
  for (Rgba8& p : image.pixels()) p.r = p.r == 3 ? 2 : 0;
  image.at(0, 0).r = 1;
  CHECK(last_code(image) == 1);
  image.at(0, 0).r = 0, image.at(3, 3).r = image.at(1, 3).r = 1;
  CHECK(last_code(image) == 0);
}

TEST_CASE("mipmaps: sizes halve down to one, and odd ones lose no texel", "[extremes][T6][case-43]") {
  const auto sizes = [](int width, int height) {
    std::vector<std::pair<int, int>> all;
    const Texture texture = *Texture::create(Image<Rgba8>(width, height), TextureEncoding::linear);
    for (const TextureLevel& level : texture.levels()) all.emplace_back(level.width, level.height);
    return all;
  };
  using Sizes = std::vector<std::pair<int, int>>;
  CHECK(sizes(5, 3) == Sizes{{5, 3}, {2, 1}, {1, 1}});
  CHECK(sizes(1, 1) == Sizes{{1, 1}});
  CHECK(sizes(1, 9) == Sizes{{1, 9}, {1, 4}, {1, 2}, {1, 1}});
  test::Random random(43);
  for (const auto& [width, height] : {std::pair{5, 3}, {1, 1}, {1, 9}, {7, 7}, {31, 17}}) {
    Image<Rgba32F> image(width, height);
    double sum = 0;
    for (Rgba32F& p : image.pixels()) p.r = random.between(0, 1), sum += static_cast<double>(p.r);
    const Texture texture = *Texture::create(image);
    CHECK(texture.float_level_image(texture.level_count() - 1).at(0, 0).r == Approx(sum / (width * height)).epsilon(1e-6));
    // Every way of reading it stays within its texels.
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror})
      for (int i = 0; i < 50; ++i) {
        const TextureLookup lookup{.at = {random.between(-2, 2), random.between(-2, 2), 0}, .lod = random.between(-1, 6)};
        const float found = sample_texture(texture, {.wrap_u = wrap, .wrap_v = wrap}, lookup).r;
        CHECK((found >= 0 && found <= 1));
      }
  }
}

TEST_CASE("mipmaps: filtered values lie within what seven bits of weight and six of level allow", "[extremes][T4]") {
  // The high tier of the conformance tests: 20 bits of coordinate, 7 of weight, 18 of derivative, 6 of level.
  test::Random random(44);
  Image<Rgba32F> noise(64, 64);
  for (Rgba32F& p : noise.pixels()) p.r = random.between(0, 1);
  const Texture texture = *Texture::create(noise);
  double worst = 0;
  for (int i = 0; i < 3000; ++i) {
    const double lod = static_cast<double>(random.between(0, 5)), fine = std::floor(lod), share = lod - fine;
    const auto step = static_cast<float>(std::exp2(lod) / 64);
    const glm::vec3 at{random.between(0, 1), random.between(0, 1), 0};
    const double found = static_cast<double>(sample_texture(texture, {}, {.at = at, .dx = {step, 0, 0}, .dy = {0, step, 0}}).r);
    const auto level = static_cast<int>(fine);
    const Filtered near = filtered_level(texture, level, static_cast<double>(at.x), static_cast<double>(at.y));
    const Filtered far = filtered_level(texture, level + 1, static_cast<double>(at.x), static_cast<double>(at.y));
    const double right = near.value + share * (far.value - near.value), error = std::abs(found - right);
    const double of_weights = 2 * 0x1p-7 * ((1 - share) * near.contrast + share * far.contrast), of_level = 0x1p-6 * std::abs(far.value - near.value);
    INFO("seed 44, lookup " << i);
    CHECK(error <= of_weights + of_level + 1e-6);
    worst = std::max(worst, error);
  }
  // Ours has 24 bits of weight, and a level that is right to 3e-7 of its size.
  CHECK(worst <= 1e-5);
}

}  // namespace tuberia
