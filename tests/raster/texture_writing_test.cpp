#include "raster/texture_target.hpp"

#include <catch2/catch.hpp>

#include <array>

#include "raster/mipmaps.hpp"
#include "raster/sample_texture.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"

namespace tuberia {
namespace {

Image<Rgba8> noise_image(test::Random& random, int width, int height) {
  Image<Rgba8> image(width, height);
  const auto code = [&] { return static_cast<std::uint8_t>(random.below(256)); };
  for (Rgba8& p : image.pixels()) p = {code(), code(), code(), code()};
  return image;
}

template <class T>
void check_refused(const Result<T>& result, const char* words) {
  REQUIRE(!result.ok());
  CHECK_THAT(result.error().message, Catch::Matchers::Contains(words));
}

/// By definition: depths read at the four texels around the middle of a 2 x 2 texture.
double share_lit(Compare compare, const std::array<float, 4>& depths, float reference, double weight_x, double weight_y) {
  const auto truth = [&](float depth) {
    switch (compare) {
      case Compare::never: return false;
      case Compare::less: return reference < depth;
      case Compare::equal: return reference == depth;
      case Compare::less_equal: return reference <= depth;
      case Compare::greater: return reference > depth;
      case Compare::not_equal: return reference != depth;
      case Compare::greater_equal: return reference >= depth;
      default: return true;
    }
  };
  const auto value = [&](std::size_t i) { return truth(depths[i]) ? 1.0 : 0.0; };
  return (value(0) * (1 - weight_x) + value(1) * weight_x) * (1 - weight_y) + (value(2) * (1 - weight_x) + value(3) * weight_x) * weight_y;
}

}  // namespace

TEST_CASE("texture writing: a replaced slice changes itself alone, and mipmaps follow when told", "[raster]") {
  test::Random random(191);
  std::array<Image<Rgba8>, 6> faces;
  for (Image<Rgba8>& face : faces) face = noise_image(random, 8, 8);
  Texture cube = *Texture::create_cube(faces, TextureEncoding::srgb);
  CHECK(cube.level_count() == 4);
  const Texture before = cube;

  faces[3] = noise_image(random, 8, 8);
  REQUIRE(cube.replace(0, 3, faces[3]).ok());
  for (int face = 0; face < 6; ++face) {
    CHECK(cube.level_image(0, face) == faces[static_cast<std::size_t>(face)]);
    for (int level = 1; level < 4; ++level) CHECK(cube.level_image(level, face) == before.level_image(level, face));
  }
  CHECK(before.level_image(0, 3) != faces[3]);  // a copy is a texture of its own

  cube.generate_mipmaps();
  const Texture anew = *Texture::create_cube(faces, TextureEncoding::srgb);
  // Each face's chain is that of the face as a picture.
  for (int face = 0; face < 6; ++face) {
    const Texture picture = *Texture::create(faces[static_cast<std::size_t>(face)], TextureEncoding::srgb);
    for (int level = 0; level < 4; ++level) {
      CHECK(cube.level_image(level, face) == anew.level_image(level, face));
      CHECK(cube.level_image(level, face) == picture.level_image(level));
    }
  }
}

TEST_CASE("texture writing: a box is halved in depth, too, and loses no texel", "[raster][case-43]") {
  test::Random random(192);
  std::vector<Image<Rgba8>> slices;
  double sum = 0;
  for (int z = 0; z < 5; ++z) {
    slices.push_back(noise_image(random, 7, 3));
    for (const Rgba8& p : slices.back().pixels()) sum += p.r;
  }
  const Texture box = *Texture::create_3d(slices, TextureEncoding::linear);
  std::vector<std::array<int, 3>> sizes;
  for (const TextureLevel& level : box.levels()) sizes.push_back({level.width, level.height, level.slices});
  CHECK(sizes == std::vector<std::array<int, 3>>{{7, 3, 5}, {3, 1, 2}, {1, 1, 1}});
  CHECK(box.level_image(2).at(0, 0).r == Approx(sum / (7 * 3 * 5)).margin(0.5001));
  for (int z = 0; z < 5; ++z) CHECK(box.level_image(0, z) == slices[static_cast<std::size_t>(z)]);
}

TEST_CASE("texture writing: what does not fit is refused", "[raster]") {
  CHECK(!Texture::create_empty({.width = 0}).ok());
  check_refused(Texture::create_empty({.kind = TextureKind::three_dimensional, .width = 513, .height = 1}), "513");
  check_refused(Texture::create_empty({.kind = TextureKind::cube, .width = 8, .height = 4}), "squares");
  check_refused(Texture::create_empty({.kind = TextureKind::one_dimensional, .width = 8, .height = 4}), "rows");
  check_refused(Texture::create_empty({.width = 8, .height = 4, .depth = 2}), "three-dimensional");
  check_refused(Texture::create_empty({.kind = TextureKind::three_dimensional, .format = TextureFormat::depth32f}), "depth");
  check_refused(Texture::create_1d({}, TextureEncoding::linear), "0 texels");
  check_refused(Texture::create_3d({}, TextureEncoding::linear), "0 slices");
  const std::vector<Image<Rgba8>> uneven{Image<Rgba8>(4, 4), Image<Rgba8>(4, 3)};
  check_refused(Texture::create_3d(uneven, TextureEncoding::linear), "slice or face 1");

  Texture texture = *Texture::create(Image<Rgba8>(8, 8), TextureEncoding::linear);
  check_refused(texture.replace(4, 0, Image<Rgba8>(1, 1)), "level 4");
  check_refused(texture.replace(0, 1, Image<Rgba8>(8, 8)), "slice or face 1");
  check_refused(texture.replace(1, 0, Image<Rgba8>(8, 8)), "8 x 8");
  check_refused(texture.replace(0, 0, Image<float>(8, 8)), "format");

  const RenderTarget target = *RenderTarget::create(8, 8, ColourFormat::srgb8);
  const RenderTarget of_floats = *RenderTarget::create(8, 8, ColourFormat::rgba32f);
  check_refused(copy_to_texture(target, texture), "sRGB");
  check_refused(copy_to_texture(of_floats, texture), "floats");
  check_refused(copy_depth_to_texture(target, texture), "depth");
  Texture small = *Texture::create(Image<Rgba8>(4, 4), TextureEncoding::srgb);
  check_refused(copy_to_texture(target, small), "8 x 8");
  Texture depths = *Texture::create_depth(Image<float>(8, 8));
  check_refused(copy_to_texture(target, depths), "codes");
}

TEST_CASE("texture writing: a target's pixels become texels", "[raster]") {
  Workers workers(1);
  RenderTarget target = *RenderTarget::create(70, 40, ColourFormat::rgba8);
  target.clear_colour({0.2f, 0.4f, 0.6f, 0.8f}, workers);
  target.clear_depth(0.25f, workers);
  Texture texture = *Texture::create(Image<Rgba8>(140, 80), TextureEncoding::linear);
  REQUIRE(copy_to_texture(target, texture, 1).ok());
  CHECK(texture.level_image(1) == target.colour_image());

  RenderTarget of_floats = *RenderTarget::create(16, 16, ColourFormat::rgba32f);
  of_floats.clear_colour({20, -4, 0.6f, 0.8f}, workers);
  Texture cube = *Texture::create_empty({.kind = TextureKind::cube, .format = TextureFormat::rgba32f, .width = 16, .height = 16});
  REQUIRE(copy_to_texture(of_floats, cube, 0, 5).ok());
  cube.generate_mipmaps();
  CHECK(cube.float_level_image(4, 5).at(0, 0) == Rgba32F{20, -4, 0.6f, 0.8f});
  CHECK(cube.float_level_image(4, 4).at(0, 0) == Rgba32F{0, 0, 0, 0});

  Texture depths = *Texture::create_depth(Image<float>(70, 40));
  REQUIRE(copy_depth_to_texture(target, depths).ok());
  CHECK(depths.depth_level_image(0) == target.depth_image());
}

TEST_CASE("texture writing: a target's pixels fill the slice or face that is named, and no other", "[raster]") {
  Workers workers(1);
  RenderTarget target = *RenderTarget::create(8, 8, ColourFormat::srgb8);
  target.clear_colour({0.2f, 0.4f, 0.6f, 0.8f}, workers);
  target.clear_depth(0.25f, workers);
  Texture codes = *Texture::create_empty({.kind = TextureKind::cube, .encoding = TextureEncoding::srgb, .width = 8, .height = 8});
  REQUIRE(copy_to_texture(target, codes, 0, 3).ok());
  Texture depths = *Texture::create_empty({.kind = TextureKind::cube, .format = TextureFormat::depth32f, .width = 8, .height = 8});
  REQUIRE(copy_depth_to_texture(target, depths, 0, 2).ok());
  for (int face = 0; face < 6; ++face) {
    INFO("face " << face);
    CHECK((codes.level_image(0, face) == target.colour_image()) == (face == 3));
    CHECK((depths.depth_level_image(0, face) == target.depth_image()) == (face == 2));
  }
}

TEST_CASE("texture writing: depths are compared first and filtered then", "[raster]") {
  const std::array<float, 4> texels{0.25f, 0.5f, 0.75f, 0.5f};
  Image<float> image(2, 2);
  std::copy(texels.begin(), texels.end(), image.pixels().begin());
  const Texture depths = *Texture::create_depth(image);
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    for (int c = 0; c <= static_cast<int>(Compare::always); ++c)
      for (const float reference : {0.0f, 0.25f, 0.5f, 0.6f, 0.75f, 1.0f, 2.0f}) {
        const auto compare = static_cast<Compare>(c);
        const Sampler sampler{.wrap_u = Wrap::clamp, .wrap_v = Wrap::clamp, .compare = compare};
        const TextureLookup lookup{.at = {0.4f, 0.55f, 0}, .reference = reference};
        Rgba32F found;
        sample_texture(depths, sampler, std::span(&lookup, 1), std::span(&found, 1), set, precision);
        INFO("compare " << c << ", reference " << reference);
        CHECK(found.r == Approx(share_lit(compare, texels, reference, 0.3, 0.6)).margin(1e-6));
        CHECK((found.g == found.r && found.b == found.r && found.a == 1));
      }
  });
  // Without comparison the depth itself; beyond a border its red.
  CHECK(sample_texture(depths, {.texels = TexelFilter::nearest}, {.at = {0.2f, 0.7f, 0}}) == Rgba32F{0.75f, 0.75f, 0.75f, 1});
  const Sampler bordered{.wrap_u = Wrap::border, .border = {1, 0, 0, 0}, .compare = Compare::less_equal};
  CHECK(sample_texture(depths, bordered, {.at = {-1, 0.5f, 0}, .reference = 0.9f}).r == 1);
}

TEST_CASE("texture writing: there are no textures or targets of unheard-of formats", "[raster]") {
  CHECK_FALSE(Texture::create_empty({.kind = static_cast<TextureKind>(4), .width = 4, .height = 4}).ok());
  CHECK_FALSE(Texture::create_empty({.format = static_cast<TextureFormat>(3), .width = 4, .height = 4}).ok());
  CHECK_FALSE(Texture::create_empty({.encoding = static_cast<TextureEncoding>(2), .width = 4, .height = 4}).ok());
  CHECK_FALSE(RenderTarget::create(8, 8, static_cast<ColourFormat>(4)).ok());
  CHECK_FALSE(RenderTarget::create(8, 8, ColourFormat::rgba8, static_cast<DepthFormat>(3)).ok());
}

TEST_CASE("texture writing: senseless samplers are named", "[raster]") {
  CHECK(refusal_of(Sampler{}) == nullptr);
  CHECK(refusal_of(Sampler{.max_anisotropy = 16}) == nullptr);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float odd : {0.0f, 17.0f, nan}) CHECK(std::string(refusal_of(Sampler{.max_anisotropy = odd})).find("max_anisotropy") != std::string::npos);
  CHECK(refusal_of(Sampler{.lod_bias = nan}) == std::string("the sampler's lod_bias is nan; it must be finite"));
  CHECK(refusal_of(Sampler{.min_lod = 3, .max_lod = 2}) != nullptr);
  CHECK(refusal_of(Sampler{.wrap_v = static_cast<Wrap>(4)}) != nullptr);
  CHECK(refusal_of(Sampler{.compare = static_cast<Compare>(8)}) != nullptr);
  CHECK(refusal_of(Sampler{.border = {nan, 0, 0, 0}}) != nullptr);
}

}  // namespace tuberia
