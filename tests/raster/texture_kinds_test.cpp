#include <catch2/catch.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <glm/vec2.hpp>
#include <limits>

#include "raster/sample_texture.hpp"
#include "tests/raster/simd_kernels.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"

namespace tuberia {
namespace {

constexpr Wrap kEveryWrap[] = {Wrap::repeat, Wrap::clamp, Wrap::mirror, Wrap::border};
constexpr TextureKind kEveryKind[] = {TextureKind::one_dimensional, TextureKind::two_dimensional, TextureKind::three_dimensional, TextureKind::cube};

struct KindOfSampling {
  InstructionSet set = best_instruction_set();
  Precision precision = Precision::exact;
};

Rgba32F look(const Texture& texture, const Sampler& sampler, const TextureLookup& lookup, KindOfSampling how = {}) {
  Rgba32F colour;
  sample_texture(texture, sampler, std::span(&lookup, 1), std::span(&colour, 1), how.set, how.precision);
  return colour;
}

std::vector<Rgba32F> look(const Texture& texture, const Sampler& sampler, const std::vector<TextureLookup>& lookups, KindOfSampling how = {}) {
  std::vector<Rgba32F> colours(lookups.size());
  sample_texture(texture, sampler, lookups, colours, how.set, how.precision);
  return colours;
}

TextureShape shape_of_kind(TextureKind kind, TextureFormat format = TextureFormat::rgba8, int size = 6) {
  const bool is_box = kind == TextureKind::three_dimensional, is_row = kind == TextureKind::one_dimensional;
  return {.kind = kind, .format = format, .width = size, .height = is_row ? 1 : kind == TextureKind::cube ? size : size - 1,
          .depth = is_box ? size - 2 : 1};
}

/// Every texel of the base level from `make`, and mipmaps.
template <class Pixel, class Make>
Texture filled(const TextureShape& shape, Make&& make) {
  Texture texture = *Texture::create_empty(shape);
  const TextureLevel base = texture.level(0);
  for (int slice = 0; slice < base.slices; ++slice) {
    Image<Pixel> image(base.width, base.height);
    for (Pixel& p : image.pixels()) p = make();
    REQUIRE(texture.replace(0, slice, image).ok());
  }
  texture.generate_mipmaps();
  return texture;
}

Texture noisy(const TextureShape& shape, test::Random& random) {
  const auto code = [&] { return static_cast<std::uint8_t>(random.below(256)); };
  switch (shape.format) {
    case TextureFormat::rgba8: return filled<Rgba8>(shape, [&] { return Rgba8{code(), code(), code(), code()}; });
    case TextureFormat::rgba32f: return filled<Rgba32F>(shape, [&] { return Rgba32F{random.between(0, 1), random.between(0, 1), random.between(0, 1), random.between(0, 1)}; });
    case TextureFormat::depth32f: break;
  }
  return filled<float>(shape, [&] { return random.between(0, 1); });
}

/// A texture whose level i is i everywhere: it shows the level of detail.
Texture level_meter(TextureKind kind, int size) {
  Texture meter = *Texture::create_empty({.kind = kind, .format = TextureFormat::rgba32f, .width = size, .height = size});
  for (int i = 0; i < meter.level_count(); ++i) {
    const auto level = static_cast<float>(i);
    for (int slice = 0; slice < meter.level(i).slices; ++slice)
      REQUIRE(meter.replace(i, slice, Image<Rgba32F>(meter.level(i).width, meter.level(i).height, {level, level, level, 1})).ok());
  }
  return meter;
}

}  // namespace

TEST_CASE("texture kinds: the level of detail of round and of elliptic footprints", "[raster][case-37][case-38]") {
  const Texture meter = level_meter(TextureKind::two_dimensional, 256);
  const float inf = std::numeric_limits<float>::infinity();
  struct Known {
    glm::vec2 dx, dy;  // texels
    float anisotropy, lod;
  };
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    for (const Known& k : {Known{{4, 0}, {0, 4}, 1, 2}, {{4, 0}, {0, 4}, 16, 2}, {{3, 0}, {0, 1}, 1, 1.5849625f}, {{3, 0}, {0, 1}, 3, 0},
                           {{16, 0}, {0, 1}, 16, 0}, {{32, 0}, {0, 1}, 16, 1}, {{8, 8}, {-1, 1}, 16, 0.5f}, {{8, 8}, {-1, 1}, 1, 3.5f},
                           {{0, 0}, {0, 0}, 16, 0}, {{inf, 0}, {0, 1}, 16, 8}, {{inf, 0}, {0, 1}, 1, 8}, {{0, 64}, {0, 0}, 16, 2},
                           {{3, 1}, {-1, 2}, 16, 1.13263f}, {{3, 1}, {-1, 2}, 1, 1.6609640f}}) {
      INFO("(" << k.dx.x << ", " << k.dx.y << ") (" << k.dy.x << ", " << k.dy.y << ") anisotropy " << k.anisotropy);
      const TextureLookup lookup{.at = {0.4f, 0.3f, 0}, .dx = glm::vec3(k.dx / 256.0f, 0), .dy = glm::vec3(k.dy / 256.0f, 0)};
      const float found = look(meter, {.max_anisotropy = k.anisotropy}, lookup, {set, precision}).r;
      CHECK(found == Approx(k.lod).margin(2e-5));
    }
    // Below level 0, so seen through a bias.
    const TextureLookup skewed{.at = {0.4f, 0.3f, 0}, .dx = {5 / 256.0f, 0, 0}, .dy = {4.9f / 256, 0.5f / 256, 0}};
    CHECK(look(meter, {.lod_bias = 3, .max_anisotropy = 16}, skewed, {set, precision}).r == Approx(3 - 1.19069).margin(2e-5));
    CHECK(look(meter, {.max_anisotropy = 1}, skewed, {set, precision}).r == Approx(std::log2(5.0)).margin(2e-5));
    // min_lod and max_lod come after the bias; an explicit level obeys all three.
    const TextureLookup explicit_level{.at = {0.4f, 0.3f, 0}, .lod = 3.25f};
    CHECK(look(meter, {}, explicit_level, {set, precision}).r == 3.25f);
    CHECK(look(meter, {.lod_bias = 1}, explicit_level, {set, precision}).r == 4.25f);
    CHECK(look(meter, {.lod_bias = 1, .max_lod = 2.5f}, explicit_level, {set, precision}).r == 2.5f);
    CHECK(look(meter, {.lod_bias = -9, .min_lod = 1.5f}, explicit_level, {set, precision}).r == 1.5f);
  });
}

TEST_CASE("texture kinds: steps or ellipse, whatever the filter", "[raster][case-37][case-38][trade]") {
  const Texture meter = level_meter(TextureKind::two_dimensional, 256);
  struct Known {
    glm::vec2 dx, dy;
    float anisotropy, steps, ellipse;  // lod by each
  };
  const float inf = std::numeric_limits<float>::infinity();
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    for (const Known& k : {Known{{3, 1}, {-1, 2}, 16, 1.16096f, 1.13263f}, {{3, 1}, {-1, 2}, 1, 1.66096f, 1.67472f}, {{5, 0}, {4.9f, 0.5f}, 16, 2.30025f, -1.19069f},
                           {{5, 0}, {4.9f, 0.5f}, 1, 2.32193f, 2.80931f}, {{3, 0}, {0, 1}, 3, 0, 0}, {{16, 0}, {0, 1}, 16, 0, 0}, {{32, 0}, {0, 1}, 16, 1, 1},
                           {{8, 8}, {-1, 1}, 16, 0.5f, 0.5f}, {{0, 0}, {0, 0}, 16, 0, 0}, {{inf, 0}, {0, 1}, 16, 8, 8}}) {
      INFO("(" << k.dx.x << ", " << k.dx.y << ") (" << k.dy.x << ", " << k.dy.y << ") anisotropy " << k.anisotropy);
      const TextureLookup lookup{.at = {0.4f, 0.3f, 0}, .dx = glm::vec3(k.dx / 256.0f, 0), .dy = glm::vec3(k.dy / 256.0f, 0)};
      const auto lod = [&](Footprint footprint) {  // below level 0 it is seen through a bias
        const float bias = k.dx == glm::vec2(0) ? 0.0f : 2.0f;
        return look(meter, {.lod_bias = bias, .max_anisotropy = k.anisotropy, .footprint = footprint}, lookup, {set, precision}).r - bias;
      };
      CHECK(lod(Footprint::steps) == Approx(std::min(k.steps, 6.0f)).margin(3e-5));
      CHECK(lod(Footprint::ellipse) == Approx(std::min(k.ellipse, 6.0f)).margin(3e-5));
      CHECK(lod(Footprint::usual) == lod(k.anisotropy > 1 ? Footprint::ellipse : Footprint::steps));
    }
  });
}

TEST_CASE("texture kinds: anisotropic samples lie along the footprint", "[raster][case-38]") {
  test::Random random(171);
  const Texture texture = noisy({.format = TextureFormat::rgba32f, .width = 64, .height = 64}, random);
  const Image<Rgba32F> image = texture.float_level_image(0);
  const Sampler sampler{.texels = TexelFilter::nearest, .max_anisotropy = 16};
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    for (const int length : {2, 4, 8, 16}) {
      // Around a border between texels, so that the samples fall on texels' centres.
      float mean = 0, mean_down = 0;
      for (int i = 0; i < length; ++i) {
        mean += image.at(32 - length / 2 + i, 20).r / static_cast<float>(length);
        mean_down += image.at(20, 32 - length / 2 + i).r / static_cast<float>(length);
      }
      const float step = static_cast<float>(length) / 64, one = 1.0f / 64;
      CHECK(look(texture, sampler, {.at = {0.5f, 20.5f / 64, 0}, .dx = {step, 0, 0}, .dy = {0, one, 0}}, {set, precision}).r == Approx(mean).margin(1e-5));
      CHECK(look(texture, sampler, {.at = {20.5f / 64, 0.5f, 0}, .dx = {one, 0, 0}, .dy = {0, -step, 0}}, {set, precision}).r == Approx(mean_down).margin(1e-5));
    }
  });
}

// rules T1
TEST_CASE("texture kinds: a constant is constant however it is read", "[raster][case-42]") {
  test::Random random(172);
  std::vector<TextureLookup> lookups(200);
  for (TextureLookup& l : lookups) {
    for (int k = 0; k < 3; ++k) l.at[k] = random.between(-2, 2), l.dx[k] = random.between(-1, 1), l.dy[k] = random.between(-0.1f, 0.1f);
    if (random.below(4) == 0) l.lod = random.between(-1, 4);
    if (random.below(5) == 0) l.at = glm::vec3(random.below(2) == 0 ? 1 : -1, 1, random.below(2) == 0 ? 1.0f : -1.0f);  // corners of the cube
  }
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    for (const TextureKind kind : kEveryKind)
      for (const TextureFormat format : {TextureFormat::rgba8, TextureFormat::rgba32f}) {
        const TextureShape shape = shape_of_kind(kind, format);
        const Texture texture = format == TextureFormat::rgba8 ? filled<Rgba8>(shape, [] { return Rgba8{200, 100, 3, 77}; })
                                                               : filled<Rgba32F>(shape, [] { return Rgba32F{0.75f, 100, -3.25f, 0.3125f}; });
        const Rgba32F right = look(texture, {.texels = TexelFilter::nearest, .mipmaps = MipmapFilter::none}, TextureLookup{}, {set, precision});
        for (const TexelFilter texels : {TexelFilter::nearest, TexelFilter::bilinear})
          for (const MipmapFilter mipmaps : {MipmapFilter::none, MipmapFilter::nearest, MipmapFilter::linear})
            for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror})
              for (const float anisotropy : {1.0f, 3.5f, 16.0f}) {
                // Mipmaps of floats are rounded means; 200 codes and these floats are not.
                const Sampler sampler{.texels = texels, .mipmaps = format == TextureFormat::rgba8 ? mipmaps : MipmapFilter::none,
                                      .wrap_u = wrap, .wrap_v = wrap, .wrap_w = wrap, .max_anisotropy = anisotropy};
                for (const Rgba32F& found : look(texture, sampler, lookups, {set, precision}))
                  if (found != right) FAIL("seed 172, kind " << static_cast<int>(kind) << ", anisotropy " << anisotropy << ": " << found.r << " not " << right.r);
              }
      }
  });
}

// rules T2
TEST_CASE("texture kinds: any numbers at all read texels of the texture", "[raster][case-36]") {
  test::Random random(173);
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const std::array<float, 12> odd{nan, inf, -inf, 3e38f, -3e38f, 1e-45f, -1e-9f, -0.0f, 0, 1, -1, 0x1p31f};
  const auto any_float = [&] { return random.below(2) == 0 ? odd[static_cast<std::size_t>(random.below(12))] : std::bit_cast<float>(static_cast<std::uint32_t>(random.u64())); };
  std::vector<TextureLookup> lookups(600);
  for (TextureLookup& l : lookups) {
    for (int k = 0; k < 3; ++k) l.at[k] = any_float(), l.dx[k] = any_float(), l.dy[k] = any_float();
    if (random.below(4) == 0) l.lod = any_float();
    l.reference = any_float();
  }
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    for (const TextureKind kind : kEveryKind)
      for (const TextureFormat format : {TextureFormat::rgba8, TextureFormat::rgba32f, TextureFormat::depth32f}) {
        if (kind == TextureKind::three_dimensional && format == TextureFormat::depth32f) continue;
        const Texture texture = noisy(shape_of_kind(kind, format), random);
        for (const Wrap wrap : kEveryWrap)
          for (const TexelFilter texels : {TexelFilter::nearest, TexelFilter::bilinear})
            for (const MipmapFilter mipmaps : {MipmapFilter::none, MipmapFilter::nearest, MipmapFilter::linear})
              for (const float anisotropy : {1.0f, 16.0f, nan}) {
                Sampler sampler{.texels = texels, .mipmaps = mipmaps, .wrap_u = wrap, .wrap_v = wrap, .wrap_w = wrap, .lod_bias = any_float(),
                                .min_lod = any_float(), .max_lod = any_float(), .max_anisotropy = anisotropy};
                if (mipmaps == MipmapFilter::nearest) sampler.compare = Compare::less;
                for (const Rgba32F& found : look(texture, sampler, lookups, {set, precision}))
                  if (!(found.r >= -1e-5f && found.r <= 1.00001f && found.a >= -1e-5f && found.a <= 1.00001f)) FAIL("seed 173: " << found.r);
              }
      }
  });
}

TEST_CASE("texture kinds: a row reads like a rectangle of one row, bit for bit", "[raster][exact]") {
  test::Random random(174);
  std::vector<Rgba8> texels(13);
  for (Rgba8& t : texels) t = {static_cast<std::uint8_t>(random.below(256)), static_cast<std::uint8_t>(random.below(256)), 5, 6};
  Image<Rgba8> row(13, 1);
  std::copy(texels.begin(), texels.end(), row.pixels().begin());
  const Texture one = *Texture::create_1d(texels, TextureEncoding::srgb), two = *Texture::create(row, TextureEncoding::srgb);
  std::vector<TextureLookup> lookups(300);
  for (TextureLookup& l : lookups) l = {.at = {random.between(-2, 2), 0.5f, 0}, .lod = random.between(0, 4)};
  for (const Wrap wrap : kEveryWrap)
    for (const TexelFilter filter : {TexelFilter::nearest, TexelFilter::bilinear}) {
      const Sampler sampler{.texels = filter, .wrap_u = wrap, .wrap_v = Wrap::clamp};
      CHECK(look(one, sampler, lookups) == look(two, sampler, lookups));
    }
}

TEST_CASE("texture kinds: a box mixes eight texels", "[raster]") {
  test::Random random(175);
  const Texture box = noisy({.kind = TextureKind::three_dimensional, .format = TextureFormat::rgba32f, .width = 5, .height = 4, .depth = 3}, random);
  const auto wrapped = [](int i, int size) { return ((i % size) + size) % size; };
  const auto texel = [&](int x, int y, int z) {
    return static_cast<double>(box.float_level_image(0, wrapped(z, 3)).at(wrapped(x, 5), wrapped(y, 4)).g);
  };
  for (int i = 0; i < 200; ++i) {
    const glm::vec3 at{random.between(-1, 2), random.between(-1, 2), random.between(-1, 2)};
    const glm::dvec3 place = glm::dvec3(at) * glm::dvec3(5, 4, 3) - 0.5;
    const auto x = static_cast<int>(std::floor(place.x)), y = static_cast<int>(std::floor(place.y)), z = static_cast<int>(std::floor(place.z));
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
      const auto weight = [](double fraction, int far) { return far != 0 ? fraction : 1 - fraction; };
      sum += weight(place.x - x, dx) * weight(place.y - y, dy) * weight(place.z - z, dz) * texel(x + dx, y + dy, z + dz);
    }
    INFO("seed 175, lookup " << i);
    CHECK(look(box, {.mipmaps = MipmapFilter::none}, {.at = at}).g == Approx(sum).margin(1e-5));
  }
  // Beyond the last slice there is the border, if asked for.
  const Sampler sampler{.texels = TexelFilter::nearest, .mipmaps = MipmapFilter::none, .wrap_w = Wrap::border, .border = {7, 8, 9, 1}};
  CHECK(look(box, sampler, {.at = {0.5f, 0.5f, 1.01f}}).g == 8);
  CHECK(look(box, sampler, {.at = {0.5f, 0.5f, 0.99f}}).g == Approx(texel(2, 2, 2)));
}

TEST_CASE("texture kinds: exact samples have the same bits on every machine", "[raster][exact]") {
  test::Random random(176);
  std::vector<TextureLookup> lookups(500);
  for (TextureLookup& l : lookups)
    for (int k = 0; k < 3; ++k) l.at[k] = random.between(-2, 2), l.dx[k] = random.between(-0.5f, 0.5f), l.dy[k] = random.between(-0.1f, 0.1f), l.reference = 0.5f;
  for (const TextureKind kind : kEveryKind)
    for (const TextureFormat format : {TextureFormat::rgba8, TextureFormat::rgba32f, TextureFormat::depth32f}) {
      if (kind == TextureKind::three_dimensional && format == TextureFormat::depth32f) continue;
      const Texture texture = noisy(shape_of_kind(kind, format, 33), random);
      for (const float anisotropy : {1.0f, 9.0f}) {
        const Sampler sampler{.max_anisotropy = anisotropy, .compare = Compare::less};
        const auto right = look(texture, sampler, lookups, {InstructionSet::baseline, Precision::exact});
        test::for_every_instruction_set([&](InstructionSet set) { CHECK(look(texture, sampler, lookups, {set, Precision::exact}) == right); });
      }
    }
}

TEST_CASE("texture kinds: a quad's differences are the derivatives", "[raster][exact]") {
  test::Random random(177);
  for (const TextureKind kind : kEveryKind) {
    const Texture texture = noisy(shape_of_kind(kind, TextureFormat::rgba8, 64), random);
    std::array<std::vector<float>, 4> strq;
    std::vector<TextureLookup> lookups;
    for (int quad = 0; quad < 64; ++quad) {
      // Sixteenths, so that differences are exact.
      const auto vector = [&](int range) { return glm::vec3(random.below(range) - range / 2, random.below(range) - range / 2, random.below(range) - range / 2) / 256.0f; };
      const glm::vec3 at = vector(512), dx = vector(16), dy = vector(16);
      for (int i = 0; i < 4; ++i) {
        const glm::vec3 here = at + dx * static_cast<float>(i % 2) + dy * static_cast<float>(i / 2);
        lookups.push_back({.at = here, .dx = dx, .dy = dy});
        for (int k = 0; k < 3; ++k) strq[static_cast<std::size_t>(k)].push_back(here[k]);
        strq[3].push_back(0);
      }
    }
    const float* const arrays[4] = {strq[0].data(), strq[1].data(), strq[2].data(), strq[3].data()};
    for (const float anisotropy : {1.0f, 16.0f}) {
      const Sampler sampler{.max_anisotropy = anisotropy};
      const auto right = look(texture, sampler, lookups);
      test::for_every_instruction_set([&](InstructionSet set) {
        std::vector<Rgba32F> found(lookups.size());
        test::simd_kernels(set, Precision::exact).sample_any(texture, sampler, arrays, static_cast<int>(found.size()), found.data());
        INFO("seed 177, kind " << static_cast<int>(kind));
        CHECK(found == right);
      });
    }
  }
}

}  // namespace tuberia
