#include <catch2/catch.hpp>

#include <array>

#include "raster/sample_texture.hpp"
#include "tests/pipeline/sampling_program_kernels.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/render.hpp"

namespace tuberia {
namespace {

using test::SampleCall;

/// The colour of a square that samples at one place all over.
Rgba32F sampled_by_program(const Texture& texture, const Sampler& sampler, SampleCall call, const glm::vec4& at) {
  test::Mesh square = test::rectangle({-1, 1, 0}, {2, 0, 0}, {0, -2, 0}, {0, 0, 1});
  square.custom.assign(4, at);
  return test::render(square, test::sample_call({std::make_shared<const Texture>(texture), sampler, call}), {}, {.width = 8, .height = 8, .colour = ColourFormat::rgba32f})
      .linear.at(3, 5);
}

Rgba32F sampled_directly(const Texture& texture, const Sampler& sampler, const glm::vec3& at, float reference = 0) {
  return sample_texture(texture, sampler, {.at = at, .reference = reference});
}

}  // namespace

TEST_CASE("sampling programs: each call reads what a lookup reads", "[pipeline]") {
  test::Random random(221);
  const auto image = [&] {
    Image<Rgba8> noise(4, 4);
    for (Rgba8& p : noise.pixels()) p = {static_cast<std::uint8_t>(random.below(256)), static_cast<std::uint8_t>(random.below(256)), 7, 255};
    return noise;
  };
  const std::array<Image<Rgba8>, 6> images{image(), image(), image(), image(), image(), image()};
  const Texture row = *Texture::create_1d(images[0].row(0), TextureEncoding::linear), rectangle = *Texture::create(images[0], TextureEncoding::srgb);
  const Texture box = *Texture::create_3d(images, TextureEncoding::linear), cube = *Texture::create_cube(images, TextureEncoding::linear);
  Image<float> depths(4, 4);
  for (float& d : depths.pixels()) d = random.between(0, 1);
  const Texture shadow_map = *Texture::create_depth(depths);
  const Sampler plain, comparing{.compare = Compare::less};

  for (int round = 0; round < 40; ++round) {
    INFO("seed 221, round " << round);
    const glm::vec4 at{random.between(-1, 2), random.between(-1, 2), random.between(-1, 1), random.between(0, 1)};
    const glm::vec3 place(at);
    CHECK(sampled_by_program(row, plain, SampleCall::one, at) == sampled_directly(row, plain, place));
    CHECK(sampled_by_program(rectangle, plain, SampleCall::two, at) == sampled_directly(rectangle, plain, place));
    CHECK(sampled_by_program(box, plain, SampleCall::two, at) == sampled_directly(box, plain, {at.x, at.y, 0}));
    CHECK(sampled_by_program(box, plain, SampleCall::three, at) == sampled_directly(box, plain, place));
    CHECK(sampled_by_program(cube, plain, SampleCall::three, at) == sampled_directly(cube, plain, place));
    CHECK(sampled_by_program(shadow_map, comparing, SampleCall::three, at) == sampled_directly(shadow_map, comparing, place, at.z));
    CHECK(sampled_by_program(shadow_map, comparing, SampleCall::compared, at) == sampled_directly(shadow_map, comparing, place, at.w));
  }
}

TEST_CASE("sampling programs: with all fragments discarded nothing is read, of the smallest textures either", "[pipeline]") {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 4}, {4, 1}}) {
    const Texture texture = *Texture::create(Image<Rgba8>(width, height), TextureEncoding::linear, false);
    test::Mesh square = test::rectangle({-1, 1, 0}, {2, 0, 0}, {0, -2, 0}, {0, 0, 1});
    square.custom.assign(4, glm::vec4(0.5f));
    const Sampler sampler{.mipmaps = MipmapFilter::none};
    const test::Picture picture = test::render(square, test::sample_discarded({std::make_shared<const Texture>(texture), sampler}), {},
                                               {.width = 8, .height = 8, .background = {1, 0, 0, 1}});
    for (const Rgba8& pixel : picture.colour.pixels()) REQUIRE(pixel == Rgba8{255, 0, 0, 255});
  }
}

}  // namespace tuberia
