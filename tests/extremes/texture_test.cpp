// How textures are read, through the whole pipeline: rules T1 to T3 and T5, cases 35 to 40, 42 and 43.

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "raster/cube_map.hpp"
#include "raster/sample_texture.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/lookups.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia {

using test::for_every_instruction_set;
using test::looked_up;
using test::looked_up_with_steps;

namespace {

using SharedTexture = std::shared_ptr<const Texture>;

SharedTexture shared_texture(Texture texture) { return std::make_shared<const Texture>(std::move(texture)); }

SharedTexture row_of_codes(const std::vector<std::uint8_t>& codes) {
  Image<Rgba8> image(static_cast<int>(codes.size()), 1);
  for (std::size_t i = 0; i < codes.size(); ++i) image.at(static_cast<int>(i), 0) = {codes[i], codes[i], codes[i], 255};
  return test::texture_of(image);
}

/// Red, in codes with their fractions, at coordinates of a row.
std::vector<double> codes_at(const SharedTexture& row, TexelFilter filter, Wrap wrap, const std::vector<float>& s, InstructionSet set) {
  std::vector<glm::vec4> strq;
  for (const float each : s) strq.push_back({each, 0.5f, 0, 1});
  std::vector<double> codes;
  for (const Rgba32F& found : looked_up(row, {.texels = filter, .mipmaps = MipmapFilter::none, .wrap_u = wrap, .wrap_v = wrap}, strq, {.threads = 1, .instruction_set = set}))
    codes.push_back(255 * static_cast<double>(found.r));
  return codes;
}

/// A square texture whose level i is i everywhere: it shows the level of detail.
SharedTexture meter_of_levels(int size) {
  Texture meter = *Texture::create_empty({.format = TextureFormat::rgba32f, .width = size, .height = size});
  for (int i = 0; i < meter.level_count(); ++i) {
    const auto level = static_cast<float>(i);
    REQUIRE(meter.replace(i, 0, Image<Rgba32F>(meter.level(i).width, meter.level(i).height, {level, level, level, 1})).ok());
  }
  return shared_texture(std::move(meter));
}

/// A cube of floats that shows a function of the unit direction.
template <class Function>
SharedTexture cube_that_shows(int size, const Function& function) {
  Texture cube = *Texture::create_empty({.kind = TextureKind::cube, .format = TextureFormat::rgba32f, .width = size, .height = size});
  for (int face = 0; face < 6; ++face) {
    Image<Rgba32F> image(size, size);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const auto n = static_cast<float>(size);
        image.at(x, y) = function(glm::normalize(cube_direction({face, (static_cast<float>(x) + 0.5f) / n, (static_cast<float>(y) + 0.5f) / n})), face);
      }
    REQUIRE(cube.replace(0, face, image).ok());
  }
  return shared_texture(std::move(cube));
}

Rgba32F half_of_direction(const glm::vec3& d) { return {0.5f + 0.5f * d.x, 0.5f + 0.5f * d.y, 0.5f + 0.5f * d.z, 1}; }

double largest_difference(const Rgba32F& a, const Rgba32F& b) {
  return static_cast<double>(std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)}));
}

}  // namespace

TEST_CASE("textures: a ramp of four texels between their centres and beyond", "[extremes][T1][case-35]") {
  // With weights of 8 bits a third would be 70.7227.
  const SharedTexture ramp = row_of_codes({0, 85, 170, 255});
  const std::vector<float> s{1.0f / 8, 1.0f / 4, 1.0f / 3, 1.0f / 2, -1.0f / 16, 17.0f / 16, 1.5f, 0};
  struct Known {
    Wrap wrap;
    std::vector<double> codes;
  };
  for_every_instruction_set([&](InstructionSet set) {
    for (const Known& k : {Known{Wrap::repeat, {0, 42.5, 70.8333333, 127.5, 191.25, 63.75, 127.5, 127.5}},
                           Known{Wrap::clamp, {0, 42.5, 70.8333333, 127.5, 0, 255, 255, 0}},
                           Known{Wrap::mirror, {0, 42.5, 70.8333333, 127.5, 0, 255, 127.5, 0}}}) {
      const std::vector<double> found = codes_at(ramp, TexelFilter::bilinear, k.wrap, s, set);
      for (std::size_t i = 0; i < s.size(); ++i) {
        INFO("wrap " << static_cast<int>(k.wrap) << ", s " << s[i]);
        CHECK(found[i] == Approx(k.codes[i]).margin(1e-4));
      }
    }
  });
}

TEST_CASE("textures: between two texels a value lies between them and moves one way", "[extremes][T1][case-35]") {
  const SharedTexture row = row_of_codes({10, 30, 200, 210});
  std::vector<float> s;
  for (int i = 0; i <= 3000; ++i) s.push_back(0.125f + 0.75f * static_cast<float>(i) / 3000);
  for_every_instruction_set([&](InstructionSet set) {
    const std::vector<double> found = codes_at(row, TexelFilter::bilinear, Wrap::clamp, s, set);
    CHECK(std::is_sorted(found.begin(), found.end()));
    CHECK(found.front() == Approx(10));
    CHECK(found.back() == Approx(210));
    const double borders[4] = {10, 30, 200, 210};
    for (std::size_t i = 0; i < s.size(); ++i) {
      const auto texel = static_cast<std::size_t>(std::min(2.0f, std::floor(4 * s[i] - 0.5f)));
      CHECK((found[i] >= borders[texel] - 2e-5 && found[i] <= borders[texel + 1] + 2e-5));
    }
  });
}

TEST_CASE("textures: which of five texels a coordinate names", "[extremes][T2][case-36]") {
  const SharedTexture five = row_of_codes({0, 50, 100, 150, 200});
  const std::vector<float> s{-0.1f, -0.999f, -1, 1, -2.5f, 1e6f + 0.25f, -1e6f - 0.25f};
  const std::vector<std::pair<Wrap, std::vector<int>>> known{
      {Wrap::repeat, {4, 0, 0, 0, 2, 1, 3}}, {Wrap::clamp, {0, 0, 0, 4, 0, 4, 0}}, {Wrap::mirror, {0, 4, 4, 4, 2, 1, 1}}};
  for_every_instruction_set([&](InstructionSet set) {
    for (const auto& [wrap, texels] : known) {
      const std::vector<double> found = codes_at(five, TexelFilter::nearest, wrap, s, set);
      for (std::size_t i = 0; i < s.size(); ++i) {
        INFO("wrap " << static_cast<int>(wrap) << ", s " << s[i]);
        CHECK(found[i] / 50 == Approx(texels[i]).margin(1e-5));
      }
    }
    // The fraction of -1e-9 is 1 as a float: the last texel, or the first; never a sixth.
    const double below_zero = codes_at(five, TexelFilter::nearest, Wrap::repeat, {-1e-9f}, set)[0];
    CHECK((below_zero == Approx(200) || below_zero == 0));
  });
}

TEST_CASE("textures: any float at all addresses within the texture", "[extremes][T2][case-36]") {
  test::Random random(0x72);
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<glm::vec4> strq;
  const float odd[] = {nan, inf, -inf, 3e38f, -3e38f, 1e-45f, -1e-9f, -0.0f, 0x1p31f};
  const auto any = [&] { return random.below(2) == 0 ? odd[random.below(9)] : std::bit_cast<float>(static_cast<std::uint32_t>(random.u64())); };
  for (int i = 0; i < 2000; ++i) strq.push_back({any(), any(), any(), random.below(2) == 0 ? 1.0f : any()});
  Image<Rgba8> image(7, 3);
  for (Rgba8& p : image.pixels()) p = {static_cast<std::uint8_t>(100 + random.below(101)), 0, 0, 255};
  const SharedTexture texture = test::texture_of(image);
  for_every_instruction_set([&](InstructionSet set) {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror})
      for (const TexelFilter filter : {TexelFilter::nearest, TexelFilter::bilinear})
        for (const Rgba32F& found : looked_up(texture, {.texels = filter, .wrap_u = wrap, .wrap_v = wrap, .max_anisotropy = 16}, strq, {.threads = 1, .instruction_set = set}))
          if (!(found.r >= 99.9f / 255 && found.r <= 200.1f / 255)) FAIL("seed 0x72: " << found.r);
  });
}

TEST_CASE("textures: the level of detail of round and of long footprints", "[extremes][T3][case-37][case-38]") {
  const SharedTexture meter = meter_of_levels(256);
  struct Known {
    glm::vec2 dx, dy;  // texels
    float anisotropy;
    double lod;
  };
  for_every_instruction_set([&](InstructionSet set) {
    for (const Known& k : {Known{{4, 0}, {0, 4}, 1, 2}, {{3, 0}, {0, 1}, 1, 1.58496}, {{3, 0}, {0, 1}, 3, 0}, {{16, 0}, {0, 1}, 16, 0}, {{32, 0}, {0, 1}, 16, 1},
                           {{8, 8}, {-1, 1}, 16, .5}, {{0, 0}, {0, 0}, 1, 0}, {{0, 0}, {0, 0}, 16, 0}, {{0, 64}, {0, 0}, 16, 2}, {{1e30f, 0}, {0, 1}, 16, 8}, {{1e30f, 0}, {0, 1}, 1, 8},
                           {{3, 1}, {-1, 2}, 16, 1.13263}, {{3, 1}, {-1, 2}, 1, 1.66096}, {{5, 0}, {4.9f, .5f}, 1, 2.32193}}) {
      INFO("(" << k.dx.x << ", " << k.dx.y << ") (" << k.dy.x << ", " << k.dy.y << ") anisotropy " << k.anisotropy);
      const Rgba32F found = looked_up_with_steps(meter, {.max_anisotropy = k.anisotropy}, {0.3f, 0.6f}, k.dx / 256.0f, k.dy / 256.0f, {.threads = 1, .instruction_set = set});
      CHECK(found.r == Approx(k.lod).margin(1e-3));
    }
    // The sheared one's ratio is above 16: below level 0, so seen through a bias.
    const Rgba32F sheared = looked_up_with_steps(meter, {.lod_bias = 3, .max_anisotropy = 16}, {0.3f, 0.6f}, glm::vec2(5, 0) / 256.0f, glm::vec2(4.9f, .5f) / 256.0f, {.threads = 1, .instruction_set = set});
    CHECK(sheared.r == Approx(3 - 1.19069).margin(2e-3));
    // The bias, then min_lod and max_lod.
    const auto bounded = [&](const Sampler& sampler) { return looked_up_with_steps(meter, sampler, {0.3f, 0.6f}, {4 / 256.0f, 0}, {0, 4 / 256.0f}, {.threads = 1, .instruction_set = set}).r; };
    CHECK(bounded({.lod_bias = 1, .max_lod = 2.5f}) == Approx(2.5));
    CHECK(bounded({.lod_bias = -9, .min_lod = 1.5f}) == Approx(1.5));
    CHECK(bounded({.lod_bias = 99}) == Approx(8));
  });
  const float inf = std::numeric_limits<float>::infinity();
  for (const float anisotropy : {1.0f, 16.0f})
    CHECK(sample_texture(*meter, {.max_anisotropy = anisotropy}, {.at = {0.3f, 0.6f, 0}, .dx = {inf, 0, 0}, .dy = {0, 1 / 256.0f, 0}}).r == 8);
}

TEST_CASE("textures: halfway between two levels the finer one is nearest", "[extremes][T3][case-37]") {
  const SharedTexture meter = meter_of_levels(256);
  const Sampler nearest{.mipmaps = MipmapFilter::nearest};
  for (const auto& [lod, level] : {std::pair{0.0f, 0}, {0.5f, 0}, {0.50001f, 1}, {1.5f, 1}, {2.49f, 2}, {2.51f, 3}, {99.0f, 8}})
    CHECK(sample_texture(*meter, nearest, {.at = {0.3f, 0.6f, 0}, .lod = lod}).r == static_cast<float>(level));
}

TEST_CASE("textures: which face of a cube a direction meets, and where", "[extremes][T5][case-39]") {
  struct Known {
    glm::vec3 direction;
    int face;
    float s, t;
  };
  const std::vector<Known> known{{{1, 1, 1}, 4, 1, 0}, {{1, 1, 0}, 2, 1, .5f}, {{1, 0, 1}, 4, 1, .5f}, {{-1, -1, -1}, 5, 1, 1}, {{1, 2, 3}, 4, .6667f, .16667f},
                                 {{-3, 1, 2}, 1, .83333f, .33333f}, {{1e-30f, 2e-30f, -3e-30f}, 5, .33333f, .16667f}};
  // Each texel shows its face and its own place.
  constexpr int kSize = 64;
  Texture cube = *Texture::create_empty({.kind = TextureKind::cube, .format = TextureFormat::rgba32f, .width = kSize, .height = kSize, .with_mipmaps = false});
  for (int face = 0; face < 6; ++face) {
    Image<Rgba32F> image(kSize, kSize);
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) image.at(x, y) = {static_cast<float>(face) / 8, static_cast<float>(x) / kSize, static_cast<float>(y) / kSize, 1};
    REQUIRE(cube.replace(0, face, image).ok());
  }
  const SharedTexture texture = shared_texture(std::move(cube));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<glm::vec4> strq;
  for (const Known& k : known) strq.push_back({k.direction, 1});
  strq.push_back({0, 0, 0, 1}), strq.push_back({nan, nan, nan, 1});
  for_every_instruction_set([&](InstructionSet set) {
    const auto found = looked_up(texture, {.texels = TexelFilter::nearest}, strq, {.threads = 1, .instruction_set = set});
    for (std::size_t i = 0; i < known.size(); ++i) {
      INFO("direction " << known[i].direction.x << " " << known[i].direction.y << " " << known[i].direction.z);
      CHECK(8 * found[i].r == static_cast<float>(known[i].face));
      // To the texel; cube_point gives the place itself.
      CHECK(std::abs(found[i].g + 0.5f / kSize - known[i].s) <= 0.6f / kSize);
      CHECK(std::abs(found[i].b + 0.5f / kSize - known[i].t) <= 0.6f / kSize);
      const CubePoint point = cube_point(known[i].direction);
      CHECK((point.face == known[i].face && point.s == Approx(known[i].s).margin(1e-4) && point.t == Approx(known[i].t).margin(1e-4)));
    }
    for (std::size_t i = known.size(); i < strq.size(); ++i) CHECK((found[i].r >= 0 && found[i].r <= 5.0f / 8 && found[i].a == 1));
  });
}

TEST_CASE("textures: no seam along the edges of a cube, three texels at its corners", "[extremes][T5][case-40]") {
  const SharedTexture smooth = cube_that_shows(32, [](const glm::vec3& d, int) { return half_of_direction(d); });
  const SharedTexture faces = cube_that_shows(32, [](const glm::vec3&, int face) { return Rgba32F{static_cast<float>(1 << face) / 64, 0, 0, 1}; });
  test::Random random(40);
  std::vector<glm::vec4> pairs, corners;
  for (int i = 0; i < 500; ++i) {
    const auto axis = static_cast<int>(random.below(3)), other = (axis + 1) % 3;
    glm::vec4 edge{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), 1};
    edge[axis] = edge[axis] > 0 ? 1.0f : -1.0f;
    edge[other] = edge[other] > 0 ? 1.0f : -1.0f;
    pairs.push_back(edge), pairs.push_back(edge);
    pairs[pairs.size() - 2][other] = std::nextafter(edge[other], 0.0f);
    pairs[pairs.size() - 1][other] = std::nextafter(edge[other], 9 * edge[other]);
  }
  for (int i = 0; i < 8; ++i) corners.push_back({(i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1, 1});
  const Sampler base{.mipmaps = MipmapFilter::none};
  for_every_instruction_set([&](InstructionSet set) {
    const auto found = looked_up(smooth, base, pairs, {.threads = 1, .instruction_set = set});
    for (std::size_t i = 0; i < found.size(); i += 2) CHECK(largest_difference(found[i], found[i + 1]) <= 1.0 / 255);
    // Each face's number has a bit of its own: the mean of the three that meet.
    const auto at_corners = looked_up(faces, base, corners, {.threads = 1, .instruction_set = set});
    for (std::size_t i = 0; i < 8; ++i) {
      const int bits = ((i & 1) != 0 ? 1 : 2) + ((i & 2) != 0 ? 4 : 8) + ((i & 4) != 0 ? 16 : 32);
      CHECK(64 * 3 * at_corners[i].r == Approx(bits).margin(1e-4));
    }
  });
}

TEST_CASE("textures: a constant is constant however it is read, on textures of any size", "[extremes][T1][case-42][case-43]") {
  test::Random random(42);
  for_every_instruction_set([&](InstructionSet set) {
    for (const auto& [width, height] : {std::pair{5, 3}, {1, 1}, {1, 9}, {64, 16}}) {
      const SharedTexture texture = test::texture_of(Image<Rgba8>(width, height, {200, 100, 3, 77}), TextureEncoding::srgb);
      std::optional<Rgba32F> right;
      for (const TexelFilter texels : {TexelFilter::nearest, TexelFilter::bilinear})
        for (const MipmapFilter mipmaps : {MipmapFilter::none, MipmapFilter::nearest, MipmapFilter::linear})
          for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror})
            for (const float anisotropy : {1.0f, 16.0f}) {
              const Sampler sampler{.texels = texels, .mipmaps = mipmaps, .wrap_u = wrap, .wrap_v = wrap, .lod_bias = random.between(-2, 2), .max_anisotropy = anisotropy};
              const auto any = [&] { return glm::vec2(random.between(-2, 2), random.between(-2, 2)); };
              const Rgba32F found = looked_up_with_steps(texture, sampler, any(), any(), any() * 0.1f, {.threads = 1, .instruction_set = set});
              if (!right) right = found;
              if (found != *right) FAIL("seed 42, " << width << "x" << height << ", wrap " << static_cast<int>(wrap) << ": " << found.r << " not " << right->r);
            }
    }
  });
}

}  // namespace tuberia
