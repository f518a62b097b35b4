// The short ways of reading a rectangle of codes against the long ones: each finds the same texels and
// levels, to the last bit.

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>

#include "math/colour.hpp"
#include "raster/sample_texture.hpp"
#include "tests/raster/simd_kernels.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"

namespace tuberia {

using test::for_every_instruction_set;
using test::for_every_machine;

namespace {

/// Random texels; half the images have no transparency.
Image<Rgba8> random_codes(int width, int height, test::Random& random) {
  Image<Rgba8> image(width, height);
  const bool is_opaque = random.below(2) == 0;
  const auto code = [&] { return static_cast<std::uint8_t>(random.below(256)); };
  for (Rgba8& p : image.pixels()) p = {code(), code(), code(), is_opaque ? std::uint8_t{255} : code()};
  return image;
}

/// A level of codes read as docs/machine.md says, one texel at a time.
class PlainLevel {
 public:
  PlainLevel(const Texture& texture, int level, const Sampler& sampler)
      : image_(texture.level_image(level)), is_srgb_(texture.encoding() == TextureEncoding::srgb), sampler_(sampler) {}

  Rgba32F at(float u, float v) const {
    const float x = reduced(u, sampler_.wrap_u) * static_cast<float>(image_.width());
    const float y = reduced(v, sampler_.wrap_v) * static_cast<float>(image_.height());
    if (sampler_.texels == TexelFilter::nearest) return finished(texel(static_cast<int>(std::floor(x)), static_cast<int>(std::floor(y))));
    const float left = std::floor(x - 0.5f), top = std::floor(y - 0.5f);
    const auto column = static_cast<int>(left), row = static_cast<int>(top);
    const auto mean_of_row = [&](int i) { return mean(texel(column, i), texel(column + 1, i), (x - 0.5f) - left); };
    return finished(mean(mean_of_row(row), mean_of_row(row + 1), (y - 0.5f) - top));
  }

 private:
  static float reduced(float c, Wrap wrap) {
    switch (wrap) {
      case Wrap::repeat: return c - std::floor(c);
      case Wrap::mirror: {
        const float period = 2.0f * (c * 0.5f - std::floor(c * 0.5f));
        return std::min(period, 2.0f - period);
      }
      case Wrap::clamp: return std::clamp(c, 0.0f, 1.0f);
      case Wrap::border: break;
    }
    return std::clamp(c, -1.0f, 2.0f);
  }
  static int wrapped(int i, int size, Wrap wrap) {
    return wrap == Wrap::repeat ? (i + size) % size : wrap == Wrap::border ? i : std::clamp(i, 0, size - 1);
  }
  static Rgba32F mean(const Rgba32F& a, const Rgba32F& b, float w) {
    return {a.r + (b.r - a.r) * w, a.g + (b.g - a.g) * w, a.b + (b.b - a.b) * w, a.a + (b.a - a.a) * w};
  }
  Rgba32F texel(int column, int row) const {
    const int x = wrapped(column, image_.width(), sampler_.wrap_u), y = wrapped(row, image_.height(), sampler_.wrap_v);
    const float scale = is_srgb_ ? 1.0f : 255.0f;
    const Rgba32F& border = sampler_.border;
    if (x < 0 || y < 0 || x >= image_.width() || y >= image_.height()) return {border.r * scale, border.g * scale, border.b * scale, border.a * 255.0f};
    const Rgba8 code = image_.at(x, y);
    const auto decoded = [&](std::uint8_t c) { return is_srgb_ ? linear_from_srgb_codes()[c] : static_cast<float>(c); };
    return {decoded(code.r), decoded(code.g), decoded(code.b), static_cast<float>(code.a)};
  }
  Rgba32F finished(const Rgba32F& c) const {
    const float unit = 1.0f / 255.0f;
    if (is_srgb_) return {c.r, c.g, c.b, c.a * unit};
    return {c.r * unit, c.g * unit, c.b * unit, c.a * unit};
  }

  Image<Rgba8> image_;
  bool is_srgb_;
  Sampler sampler_;
};

bool same_bits(const Rgba32F& a, const Rgba32F& b) {
  const auto same = [](float x, float y) { return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y); };
  return same(a.r, b.r) && same(a.g, b.g) && same(a.b, b.b) && same(a.a, b.a);
}

/// 64 places: in the middle, where whole registers lie within, and then anywhere around.
struct Places {
  static constexpr int kCount = 64;
  float u[kCount], v[kCount];
  explicit Places(test::Random& random) {
    for (int i = 0; i < kCount; ++i) {
      const float reach = i < kCount / 2 ? 0.2f : 1.6f;
      u[i] = random.between(0.5f - reach, 0.5f + reach), v[i] = random.between(0.5f - reach, 0.5f + reach);
    }
  }
};

}  // namespace

TEST_CASE("rectangles: every level of every size is read by its definition", "[raster][exact]") {
  test::Random random(1201);
  for (int width = 1; width <= 17; ++width)
    for (const int height : {1, 2, 3, 7, 8, 17}) {
      const auto encoding = random.below(2) == 0 ? TextureEncoding::linear : TextureEncoding::srgb;
      const Texture texture = *Texture::create(random_codes(width, height, random), encoding);
      const Places places(random);
      for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror, Wrap::border})
        for (const TexelFilter filter : {TexelFilter::nearest, TexelFilter::bilinear})
          for (int level = 0; level < texture.level_count(); ++level) {
            const auto lod = static_cast<float>(level);
            const Sampler sampler{.texels = filter, .wrap_u = wrap, .wrap_v = wrap == Wrap::border ? Wrap::repeat : wrap,
                                  .border = {0.25f, 0.5f, 1, 0.75f}, .min_lod = lod, .max_lod = lod};
            const PlainLevel plain(texture, level, sampler);
            for_every_instruction_set([&](InstructionSet set) {
              Rgba32F found[Places::kCount];
              test::simd_kernels(set, Precision::exact).sample(texture, sampler, places.u, places.v, Places::kCount, found);
              for (int i = 0; i < Places::kCount; ++i)
                if (!same_bits(found[i], plain.at(places.u[i], places.v[i])))
                  FAIL("seed 1201, " << width << "x" << height << ", level " << level << ", wrap " << static_cast<int>(wrap) << ", filter " << static_cast<int>(filter) << ", place " << i);
            });
          }
    }
}

TEST_CASE("rectangles: a texture that was opaque is read anew when it no longer is", "[raster]") {
  Texture texture = *Texture::create(Image<Rgba8>(8, 8, {1, 2, 3, 255}), TextureEncoding::linear);
  const Sampler sampler{.mipmaps = MipmapFilter::none};
  const auto alpha = [&](InstructionSet set) {
    const std::vector<float> middle(16, 0.5f);
    Rgba32F found[16];
    test::simd_kernels(set, Precision::exact).sample(texture, sampler, middle.data(), middle.data(), 16, found);
    return found[0].a;
  };
  for_every_instruction_set([&](InstructionSet set) { CHECK(alpha(set) == 1.0f); });
  REQUIRE(texture.replace(0, 0, Image<Rgba8>(8, 8, {1, 2, 3, 51})));
  for_every_instruction_set([&](InstructionSet set) { CHECK(alpha(set) == 51 * (1.0f / 255.0f)); });
  CHECK(texture.level(1).is_opaque);
  texture.generate_mipmaps();
  CHECK_FALSE(texture.level(1).is_opaque);
}

// Quads get their level by a short way; single lookups take the logarithm of every step. The steps here
// are those where levels change, and some hundred floats around each.
TEST_CASE("rectangles: the level of a quad is that of its logarithm", "[raster]") {
  constexpr int kSize = 256;
  Texture texture = *Texture::create(Image<Rgba8>(kSize, kSize, {0, 0, 0, 255}), TextureEncoding::linear);
  for (int i = 0; i < texture.level_count(); ++i) {
    const auto shade = static_cast<std::uint8_t>(20 * i + 7);
    REQUIRE(texture.replace(i, 0, Image<Rgba8>(kSize >> i, kSize >> i, {shade, static_cast<std::uint8_t>(255 - shade), shade, shade})));
  }
  // Neighbours in the first half; then quads of one register have levels of their own.
  std::vector<float> steps;
  for (int k = 0; k <= 17; ++k)
    for (int ulps = -400; ulps < 400; ++ulps) steps.push_back(std::bit_cast<float>(std::bit_cast<std::int32_t>(std::sqrt(std::ldexp(1.0f, k))) + ulps));
  const std::size_t ordered = steps.size();
  for (std::size_t i = 0; i < ordered; ++i) steps.push_back(steps[i * 4801 % ordered]);

  std::vector<float> u, v;
  std::vector<TextureLookup> lookups;
  for (const float step : steps) {
    const float du = step / kSize;
    u.insert(u.end(), {0, du, 0, du}), v.insert(v.end(), {0.25f, 0.25f, 0.25f, 0.25f});
    lookups.push_back({.at = {0, 0.25f, 0}, .dx = {du, 0, 0}});
  }
  for_every_machine([&](InstructionSet set, Precision precision) {
    for (const MipmapFilter mipmaps : {MipmapFilter::nearest, MipmapFilter::linear})
      for (const float bias : {0.0f, 0.3f}) {
        const Sampler sampler{.mipmaps = mipmaps, .lod_bias = bias};
        std::vector<Rgba32F> found(u.size()), right(lookups.size());
        test::simd_kernels(set, precision).sample(texture, sampler, u.data(), v.data(), static_cast<int>(u.size()), found.data());
        sample_texture(texture, sampler, lookups, right, set, precision);
        for (std::size_t i = 0; i < right.size(); ++i)
          if (!same_bits(found[4 * i], right[i])) FAIL("step " << steps[i] << ", mipmaps " << static_cast<int>(mipmaps) << ": " << found[4 * i].r << " instead of " << right[i].r);
      }
  });
}

}  // namespace tuberia
