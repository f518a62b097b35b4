#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>

#include "math/colour.hpp"
#include "tests/raster/simd_kernels.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"

namespace tuberia {

using test::for_every_machine;

namespace {

constexpr Wrap kWraps[] = {Wrap::repeat, Wrap::clamp, Wrap::mirror, Wrap::border};

Texture texture_row(std::vector<int> codes, TextureEncoding encoding = TextureEncoding::linear) {
  Image<Rgba8> image(static_cast<int>(codes.size()), 1);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const auto code = static_cast<std::uint8_t>(codes[i]);
    image.at(static_cast<int>(i), 0) = {code, code, code, 255};
  }
  return *Texture::create(image, encoding);
}

struct Machine {
  InstructionSet set;
  Precision precision;
};

std::vector<Rgba32F> samples(const Texture& texture, const Sampler& sampler, std::vector<float> u, std::vector<float> v, Machine machine) {
  const std::size_t count = u.size(), padded = (count + 15) / 16 * 16;
  u.resize(padded, 0.5f), v.resize(padded, 0.5f);
  std::vector<Rgba32F> out(padded);
  test::simd_kernels(machine.set, machine.precision).sample(texture, sampler, u.data(), v.data(), static_cast<int>(padded), out.data());
  out.resize(count);
  return out;
}

/// The red code, with its fraction, of the base level at u, v = 1/2.
double code_at(const Texture& texture, TexelFilter filter, Wrap wrap, float u, Machine machine) {
  const Sampler sampler{.texels = filter, .mipmaps = MipmapFilter::none, .wrap_u = wrap, .wrap_v = wrap};
  return 255 * static_cast<double>(samples(texture, sampler, {u}, {0.5f}, machine)[0].r);
}

/// A quad of coordinates, in texels of a 256x256 texture, that grows by (dudx, dvdx) and (dudy, dvdy).
struct Quad {
  std::vector<float> u, v;
  Quad(float u0, float v0, float dudx, float dvdx, float dudy, float dvdy) {
    for (int i = 0; i < 4; ++i) {
      const float x = static_cast<float>(i % 2), y = static_cast<float>(i / 2);
      u.push_back((u0 + x * dudx + y * dudy) / 256);
      v.push_back((v0 + x * dvdx + y * dvdy) / 256);
    }
  }
};

/// What nearest texels of the two levels around lod give, by definition.
double nearest_at_lod(const Texture& texture, float u, float v, double lod) {
  const auto texel = [&](int level) {
    const Image<Rgba8> image = texture.level_image(level);
    return static_cast<double>(image.at(static_cast<int>(u * static_cast<float>(image.width())), static_cast<int>(v * static_cast<float>(image.height()))).r);
  };
  const double fine = std::floor(lod);
  const auto level = static_cast<int>(fine);
  return lod == fine ? texel(level) : texel(level) + (lod - fine) * (texel(level + 1) - texel(level));
}

}  // namespace

TEST_CASE("sampling: a ramp of four texels between their centres and beyond", "[raster][case-35]") {
  const Texture ramp = texture_row({0, 85, 170, 255});
  for_every_machine([&](InstructionSet set, Precision precision) {
    const auto at = [&](Wrap wrap, float u) { return code_at(ramp, TexelFilter::bilinear, wrap, u, {set, precision}); };
    const auto close = [](double code) { return Approx(code).margin(1e-4); };
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
      CHECK(at(wrap, 1.0f / 8) == close(0));
      CHECK(at(wrap, 1.0f / 4) == close(42.5));
      CHECK(at(wrap, 1.0f / 3) == close(70.833333));
      CHECK(at(wrap, 1.0f / 2) == close(127.5));
    }
    CHECK(at(Wrap::repeat, -1.0f / 16) == close(191.25));
    CHECK(at(Wrap::clamp, -1.0f / 16) == close(0));
    CHECK(at(Wrap::repeat, 17.0f / 16) == close(63.75));
    CHECK(at(Wrap::clamp, 17.0f / 16) == close(255));
    CHECK(at(Wrap::repeat, 1.5f) == close(127.5));
    CHECK(at(Wrap::clamp, 1.5f) == close(255));
    CHECK(at(Wrap::mirror, 1.5f) == close(127.5));
    CHECK(at(Wrap::repeat, 0) == close(127.5));
  });
}

TEST_CASE("sampling: weights of eight bits are rounded, and err by half a code at most", "[raster][case-35][trade]") {
  const Texture ramp = texture_row({0, 85, 170, 255}), steep = texture_row({0, 255});
  const Sampler eight_bits{.mipmaps = MipmapFilter::none, .wrap_u = Wrap::clamp, .wrap_v = Wrap::clamp, .weights = FilterWeights::eight_bits};
  for_every_machine([&](InstructionSet set, Precision precision) {
    const auto code = [&](const Texture& texture, float u) {
      return 255 * static_cast<double>(samples(texture, eight_bits, {u}, {0.5f}, {set, precision})[0].r);
    };
    CHECK(code(ramp, 1.0f / 3) == Approx(70.7227).margin(1e-4));
    CHECK(code(ramp, 0.25f) == Approx(42.5));
    double largest = 0;
    for (int i = 0; i <= 4096; ++i) {
      const float u = 0.25f + static_cast<float>(i) / 8192;
      const double weight = i / 4096.0;
      CHECK(code(steep, u) == Approx(255 * std::floor(weight * 256 + 0.5) / 256).margin(1e-3));
      largest = std::max(largest, std::abs(code(steep, u) - 255 * weight));
    }
    CHECK(largest == Approx(255.0 / 512).epsilon(0.01));
  });
}

TEST_CASE("sampling: the ellipse's longer axis in place of the longer step", "[raster][case-38][trade]") {
  test::Random random(133);
  Image<Rgba8> noise(256, 256);
  for (Rgba8& p : noise.pixels()) p.r = static_cast<std::uint8_t>(random.below(256));
  const Texture texture = *Texture::create(noise, TextureEncoding::linear);
  const Sampler by_ellipse{.texels = TexelFilter::nearest, .footprint = Footprint::ellipse};
  struct Known {
    float dudx, dvdx, dudy, dvdy;
    double lod;
  };
  for_every_machine([&](InstructionSet set, Precision precision) {
    // log2 of the larger singular value; where the steps are at right angles, it is the longer one.
    for (const Known& k : {Known{3, 1, -1, 2, 1.6747233}, {5, 0, 4.9f, 0.5f, 2.8093078}, {4, 0, 0, 4, 2}, {0, 1, 3, 0, 1.5849625}}) {
      const Quad quad(130.25f, 97.5f, k.dudx, k.dvdx, k.dudy, k.dvdy);
      const auto found = samples(texture, by_ellipse, quad.u, quad.v, {set, precision});
      for (std::size_t i = 0; i < 4; ++i) CHECK(255 * found[i].r == Approx(nearest_at_lod(texture, quad.u[i], quad.v[i], k.lod)).margin(3e-3));
    }
  });
}

TEST_CASE("sampling: which of five texels a coordinate names", "[raster][case-36]") {
  const Texture five = texture_row({0, 50, 100, 150, 200});
  struct Known {
    float u;
    int repeat, clamp, mirror;
  };
  for_every_machine([&](InstructionSet set, Precision precision) {
    for (const Known& k : {Known{-0.1f, 4, 0, 0}, {-0.999f, 0, 0, 4}, {-1, 0, 0, 4}, {1, 0, 4, 4}, {-2.5f, 2, 0, 2},
                           {1e6f + 0.25f, 1, 4, 1}, {-1e6f - 0.25f, 3, 0, 1}}) {
      INFO("u " << k.u);
      const auto texel = [&](Wrap wrap) { return code_at(five, TexelFilter::nearest, wrap, k.u, {set, precision}) / 50; };
      CHECK(texel(Wrap::repeat) == Approx(k.repeat).margin(1e-5));
      CHECK(texel(Wrap::clamp) == Approx(k.clamp).margin(1e-5));
      CHECK(texel(Wrap::mirror) == Approx(k.mirror).margin(1e-5));
    }
    const double below_zero = code_at(five, TexelFilter::nearest, Wrap::repeat, -1e-9f, {set, precision});
    CHECK((below_zero == Approx(200) || below_zero == 0));
  });
}

TEST_CASE("sampling: beyond the border there is its colour, and half of it on the edge", "[raster]") {
  const Texture white = texture_row({255, 255});
  for_every_machine([&](InstructionSet set, Precision precision) {
    Sampler sampler{.mipmaps = MipmapFilter::none, .wrap_u = Wrap::border, .wrap_v = Wrap::clamp, .border = {0.25f, 0.5f, 1, 0}};
    const auto bilinear = samples(white, sampler, {-0.26f, -3, 7, 0, 1, 0.5f}, std::vector<float>(6, 0.5f), {set, precision});
    for (const std::size_t outside : {0u, 1u, 2u}) CHECK(bilinear[outside].r == Approx(0.25));
    for (const std::size_t edge : {3u, 4u}) CHECK(bilinear[edge].r == Approx(0.625));
    CHECK(bilinear[3].a == Approx(0.5));
    CHECK(bilinear[5].r == Approx(1));
    sampler.texels = TexelFilter::nearest;
    const auto nearest = samples(white, sampler, {-1e-6f, 0, 0.9999f, 1}, std::vector<float>(4, 0.5f), {set, precision});
    CHECK((nearest[0].a == 0 && nearest[1].a == 1 && nearest[2].a == 1 && nearest[3].a == 0));
  });
}

TEST_CASE("sampling: the level follows from the larger step", "[raster][case-37]") {
  test::Random random(131);
  Image<Rgba8> noise(256, 256);
  for (Rgba8& p : noise.pixels()) p.r = static_cast<std::uint8_t>(random.below(256));
  const Texture texture = *Texture::create(noise, TextureEncoding::linear);
  const Sampler trilinear{.texels = TexelFilter::nearest, .mipmaps = MipmapFilter::linear};
  struct Known {
    float dudx, dvdx, dudy, dvdy;
    double lod;
  };
  for_every_machine([&](InstructionSet set, Precision precision) {
    for (const Known& k : {Known{4, 0, 0, 4, 2}, {3, 0, 0, 1, 1.5849625}, {0, 1, 3, 0, 1.5849625}, {16, 0, 0, 1, 4}, {0, 0, 0, 0, 0},
                           {0.5f, 0, 0, 0.25f, 0}, {8, 8, -1, 1, 3.5}, {64, 0, 0, 1, 6}}) {
      const Quad quad(130.25f, 97.5f, k.dudx, k.dvdx, k.dudy, k.dvdy);
      INFO("derivatives " << k.dudx << " " << k.dvdx << " " << k.dudy << " " << k.dvdy);
      const auto found = samples(texture, trilinear, quad.u, quad.v, {set, precision});
      for (std::size_t i = 0; i < 4; ++i) CHECK(255 * found[i].r == Approx(nearest_at_lod(texture, quad.u[i], quad.v[i], k.lod)).margin(1e-3));

      // The bias is added before the ends of the chain are respected.
      Sampler biased = trilinear;
      for (const float bias : {-100.0f, -1.0f, 0.5f, 100.0f}) {
        biased.lod_bias = bias;
        const double lod = k.dudx == 0 && k.dudy == 0 ? std::max(0.0, static_cast<double>(bias) - 63) : std::max(0.0, std::log2(std::max(std::hypot(k.dudx, k.dvdx), std::hypot(k.dudy, k.dvdy))) + static_cast<double>(bias));
        CHECK(255 * samples(texture, biased, quad.u, quad.v, {set, precision})[0].r == Approx(nearest_at_lod(texture, quad.u[0], quad.v[0], std::min(lod, 8.0))).margin(1e-3));
      }
    }
    const float huge = 1e36f;  // its steps overflow
    const auto last = samples(texture, trilinear, {-huge, huge, -huge, huge}, {0.5f, 0.5f, 0.5f, 0.5f}, {set, precision});
    CHECK(255 * last[0].r == Approx(texture.level_image(8).at(0, 0).r));
  });
}

TEST_CASE("sampling: the nearest level, halfway cases to the finer one", "[raster][case-37]") {
  test::Random random(132);
  Image<Rgba8> noise(256, 256);
  for (Rgba8& p : noise.pixels()) p.r = static_cast<std::uint8_t>(random.below(256));
  const Texture texture = *Texture::create(noise, TextureEncoding::linear);
  const Sampler nearest{.texels = TexelFilter::nearest, .mipmaps = MipmapFilter::nearest};
  for_every_machine([&](InstructionSet set, Precision precision) {
    for (const auto& [step, level] : {std::pair{1.0f, 0}, {1.4f, 0}, {1.43f, 1}, {2.0f, 1}, {2.8f, 1}, {2.85f, 2}, {1000.0f, 8}}) {
      const Quad quad(10.25f, 20.5f, step, 0, 0, step / 2);
      CHECK(255 * samples(texture, nearest, quad.u, quad.v, {set, precision})[0].r == Approx(nearest_at_lod(texture, quad.u[0], quad.v[0], level)).margin(1e-4));
    }
  });
}

// rules T1
TEST_CASE("sampling: a constant texture is constant however it is read", "[raster][case-42][case-43]") {
  test::Random random(133);
  std::vector<float> u(512), v(512);
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = random.between(-3, 3) * (i % 3 == 0 ? 100.0f : 1.0f), v[i] = random.between(-3, 3);
  for_every_machine([&](InstructionSet set, Precision precision) {
    for (const TextureEncoding encoding : {TextureEncoding::linear, TextureEncoding::srgb})
      for (const auto& [width, height] : {std::pair{1, 1}, {1, 6}, {5, 3}, {64, 16}}) {
        const Texture texture = *Texture::create(Image<Rgba8>(width, height, {200, 100, 3, 255}), encoding);
        const auto right = samples(texture, {.texels = TexelFilter::nearest, .mipmaps = MipmapFilter::none}, {0.5f}, {0.5f}, {set, precision})[0];
        CHECK(right.r == Approx(encoding == TextureEncoding::srgb ? linear_from_srgb_codes()[200] : 200 / 255.0f));
        for (const TexelFilter texels : {TexelFilter::nearest, TexelFilter::bilinear})
          for (const MipmapFilter mipmaps : {MipmapFilter::none, MipmapFilter::nearest, MipmapFilter::linear})
            for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror})
              for (const Rgba32F& found : samples(texture, {.texels = texels, .mipmaps = mipmaps, .wrap_u = wrap, .wrap_v = wrap}, u, v, {set, precision}))
                if (found != right) FAIL(width << "x" << height << ", wrap " << static_cast<int>(wrap));
      }
  });
}

// rules T1
TEST_CASE("sampling: between two texels the value moves one way only", "[raster]") {
  const Texture step = texture_row({10, 30, 200, 210});
  std::vector<float> u;
  for (int i = 0; i <= 4096; ++i) u.push_back(0.125f + 0.75f * static_cast<float>(i) / 4096);
  for_every_machine([&](InstructionSet set, Precision precision) {
    const auto found = samples(step, {.mipmaps = MipmapFilter::none}, u, std::vector<float>(u.size(), 0.5f), {set, precision});
    for (std::size_t i = 1; i < found.size(); ++i) CHECK(found[i].r >= found[i - 1].r);
    CHECK(255 * found.front().r == Approx(10));
    CHECK(255 * found.back().r == Approx(210));
  });
}

// rules T2
TEST_CASE("sampling: any coordinate at all reads texels of the texture", "[raster]") {
  test::Random random(134);
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> odd{nan, -nan, inf, -inf, 3e38f, -3e38f, 1e-45f, -1e-45f, -1e-9f, -0.0f, 1, -1, 2, 0x1p31f, -0x1p31f, 0x1p23f};
  for (const float x : {0.0f, 0.5f, 1.0f, 2.0f, -1.0f}) odd.push_back(std::nextafter(x, 9.0f)), odd.push_back(std::nextafter(x, -9.0f));
  while (odd.size() < 400) odd.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(random.u64())));
  std::vector<float> other(odd.rbegin(), odd.rend());
  for_every_machine([&](InstructionSet set, Precision precision) {
    for (const auto& [width, height] : {std::pair{1, 1}, {3, 5}, {7, 2}, {64, 64}}) {
      Image<Rgba8> image(width, height);
      for (Rgba8& p : image.pixels()) p = {static_cast<std::uint8_t>(100 + random.below(101)), 0, 0, 255};
      const Texture texture = *Texture::create(image, TextureEncoding::linear);
      for (const Wrap wrap : kWraps)
        for (const TexelFilter texels : {TexelFilter::nearest, TexelFilter::bilinear})
          for (const MipmapFilter mipmaps : {MipmapFilter::none, MipmapFilter::nearest, MipmapFilter::linear}) {
            const Sampler sampler{.texels = texels, .mipmaps = mipmaps, .wrap_u = wrap, .wrap_v = wrap, .border = {0.5f, 0, 0, 1}};
            for (const Rgba32F& found : samples(texture, sampler, odd, other, {set, precision}))
              if (!(found.r >= 99.9f / 255 && found.r <= 200.1f / 255 && found.a > 0.999f)) FAIL("seed 134, " << width << "x" << height << ": " << found.r);
          }
    }
  });
}

TEST_CASE("sampling: exact samples have the same bits on every machine", "[raster][exact]") {
  test::Random random(135);
  Image<Rgba8> noise(50, 37);
  for (Rgba8& p : noise.pixels()) p = {static_cast<std::uint8_t>(random.below(256)), static_cast<std::uint8_t>(random.below(256)), 9, 200};
  std::vector<float> u(4096), v(4096);
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = random.between(-2, 2), v[i] = i % 4 == 0 ? random.between(-2, 2) : v[i - 1] + random.between(-0.1f, 0.1f);
  for (const TextureEncoding encoding : {TextureEncoding::linear, TextureEncoding::srgb}) {
    const Texture texture = *Texture::create(noise, encoding);
    for (const Wrap wrap : kWraps)
      for (const MipmapFilter mipmaps : {MipmapFilter::none, MipmapFilter::nearest, MipmapFilter::linear}) {
        const Sampler sampler{.mipmaps = mipmaps, .wrap_u = wrap, .wrap_v = wrap};
        const auto right = samples(texture, sampler, u, v, {InstructionSet::baseline, Precision::exact});
        test::for_every_instruction_set([&](InstructionSet set) { CHECK(samples(texture, sampler, u, v, {set, Precision::exact}) == right); });
      }
  }
}

}  // namespace tuberia
