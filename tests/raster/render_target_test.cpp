#include "raster/render_target.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "math/colour.hpp"
#include "raster/half_float.hpp"
#include "tests/support/random.hpp"

namespace tuberia {

using Catch::Matchers::Contains;

namespace {

constexpr ColourFormat kAllColourFormats[] = {ColourFormat::rgba8, ColourFormat::srgb8, ColourFormat::rgba32f, ColourFormat::rgba16f};

RenderTarget target_of(const RenderTargetDescription& description) { return *RenderTarget::create(description); }

std::string refusal_of(const Result<Nothing>& result) { return result ? "accepted" : result.error().message; }

/// Random bits in every plane; floats and halves get random numbers.
void fill_at_random(RenderTarget& target, std::uint64_t seed) {
  test::Random random(seed);
  for (int number = 0; number < target.tile_count(); ++number)
    for (int s = 0; s < target.samples(); ++s) {
      const Tile plane = plane_of_sample(target.tile(number), target.colour_format(), s);
      for (int i = 0; i < kTilePixels; ++i) {
        for (int c = 0; c < 4; ++c) {
          const int at = i / kBlockPixels * 4 * kBlockPixels + c * kBlockPixels + i % kBlockPixels;
          const float value = random.between(-3, 3);
          if (target.colour_format() == ColourFormat::rgba32f) static_cast<float*>(plane.colour)[at] = value;
          else if (target.colour_format() == ColourFormat::rgba16f) static_cast<std::uint16_t*>(plane.colour)[at] = half_from_float(value);
          else static_cast<std::uint8_t*>(plane.colour)[4 * i + c] = static_cast<std::uint8_t>(random.below(256));
        }
        plane.depth[i] = static_cast<std::int32_t>(random.below(65536));
        if (plane.stencil != nullptr) plane.stencil[i] = static_cast<std::uint8_t>(random.below(256));
      }
    }
}

/// All that a target holds in its pixels, sample by sample.
struct Contents {
  std::vector<Image<Rgba32F>> colour;
  std::vector<Image<std::int32_t>> depth;
  std::vector<Image<std::uint8_t>> stencil;
  explicit Contents(const RenderTarget& target) {
    for (int s = 0; s < target.samples(); ++s) {
      colour.push_back(target.sample_linear_image(s));
      depth.push_back(target.sample_depth_codes(s));
      stencil.push_back(target.sample_stencil_codes(s));
    }
  }
  bool operator==(const Contents&) const = default;
};

}  // namespace

TEST_CASE("render target: samples and sizes that cannot be are refused by name", "[raster]") {
  for (const int samples : {-1, 0, 3, 5, 32}) {
    const auto target = RenderTarget::create({.width = 8, .height = 8, .samples = samples});
    REQUIRE(!target.ok());
    CHECK_THAT(target.error().message, Contains(std::to_string(samples) + " samples"));
  }
  CHECK(!RenderTarget::create({.width = 0, .height = 8}).ok());
  CHECK(!RenderTarget::create({.width = 8, .height = 16385}).ok());
  const RenderTarget target = target_of({.width = 65, .height = 3, .stencil = true, .samples = 8});
  CHECK((target.samples() == 8 && target.has_stencil() && target.width() == 65 && target.height() == 3));
  CHECK(target.stencil_codes() == Image<std::uint8_t>(65, 3, 0));
}

TEST_CASE("render target: a clear changes what it names, inside its rectangle, bit by bit of the masks", "[raster][exact]") {
  const PixelRect scissor{-5, 7, 70, 66};
  const Rgba32F colour{0.25f, 1.5f, -0.5f, 0.75f};
  Workers workers(2);
  for (const ColourFormat format : kAllColourFormats)
    for (const int samples : {1, 4})
      for (int what = 0; what < 8; ++what) {
        INFO("format " << static_cast<int>(format) << ", samples " << samples << ", what " << what);
        RenderTarget target = target_of({.width = 130, .height = 70, .colour = format, .depth = DepthFormat::d16, .stencil = true, .samples = samples});
        RenderTarget full = target_of(target.description());
        fill_at_random(target, 361);
        const Contents before(target);
        ClearCommand command{.scissor = scissor, .colour_mask = {true, false, true, false}, .stencil_write_mask = 0x3c};
        if ((what & 1) != 0) command.colour = colour;
        if ((what & 2) != 0) command.depth = 0.5f;
        if ((what & 4) != 0) command.stencil = std::uint8_t{0xa5};
        REQUIRE(target.clear(command, workers).ok());
        full.clear_colour(colour, workers);
        const Contents after(target), cleared(full);
        for (std::size_t s = 0; s < static_cast<std::size_t>(samples); ++s)
          for (int y = 0; y < 70; ++y)
            for (int x = 0; x < 130; ++x) {
              const bool inside = x < 70 && y >= 7 && y < 66;
              Rgba32F pixel = before.colour[s].at(x, y);
              if (inside && (what & 1) != 0) pixel.r = cleared.colour[s].at(x, y).r, pixel.b = cleared.colour[s].at(x, y).b;
              const int old = before.stencil[s].at(x, y);
              const int stencil = inside && (what & 4) != 0 ? (old & 0xc3) | (0xa5 & 0x3c) : old;
              const std::int32_t depth = inside && (what & 2) != 0 ? 32768 : before.depth[s].at(x, y);
              if (after.colour[s].at(x, y) != pixel || after.stencil[s].at(x, y) != stencil || after.depth[s].at(x, y) != depth)
                FAIL("seed 361, sample " << s << ", pixel (" << x << ", " << y << ")");
            }
      }
}

TEST_CASE("render target: a clear without scissor and masks fills every sample", "[raster][exact]") {
  Workers workers(1);
  for (const ColourFormat format : kAllColourFormats) {
    RenderTarget target = target_of({.width = 70, .height = 9, .colour = format, .stencil = true, .samples = 2});
    fill_at_random(target, 362);
    REQUIRE(target.clear({.colour = Rgba32F{1, 0, 1, 0}, .depth = 0.0f, .stencil = std::uint8_t{9}}, workers).ok());
    for (int s = 0; s < 2; ++s) {
      CHECK(target.sample_linear_image(s) == Image<Rgba32F>(70, 9, {1, 0, 1, 0}));
      CHECK(target.sample_colour_image(s) == Image<Rgba8>(70, 9, {255, 0, 255, 0}));
      CHECK(target.sample_depth_codes(s) == Image<std::int32_t>(70, 9, 0));
      CHECK(target.sample_stencil_codes(s) == Image<std::uint8_t>(70, 9, 9));
    }
  }
}

TEST_CASE("render target: a clear that cannot be is refused and changes nothing", "[raster]") {
  Workers workers(1);
  RenderTarget target = target_of({.width = 9, .height = 9});
  fill_at_random(target, 363);
  const Contents before(target);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK_THAT(refusal_of(target.clear({.colour = Rgba32F{1, 1, 1, 1}, .stencil = std::uint8_t{7}}, workers)), Contains("stencil is 7"));
  CHECK_THAT(refusal_of(target.clear({.colour = Rgba32F{1, 1, 1, 1}, .depth = nan}, workers)), Contains("depth"));
  CHECK_THAT(refusal_of(target.clear({.colour = Rgba32F{1, nan, 1, 1}, .depth = 1.0f}, workers)), Contains("green"));
  CHECK(Contents(target) == before);
}

TEST_CASE("render target: resolving takes the mean of the samples", "[raster][exact]") {
  Workers workers(2);
  for (const int samples : {2, 4, 8, 16})
    for (const ColourFormat format : kAllColourFormats) {
      INFO("samples " << samples << ", format " << static_cast<int>(format) << ", seed 364");
      RenderTarget from = target_of({.width = 75, .height = 68, .colour = format, .stencil = true, .samples = samples});
      RenderTarget to = target_of({.width = 75, .height = 68, .colour = format, .stencil = true});
      fill_at_random(from, 364);
      REQUIRE(resolve(from, to, workers).ok());
      CHECK(to.colour_image() == from.colour_image());
      CHECK(to.linear_image() == from.linear_image());
      CHECK(to.depth_codes() == from.sample_depth_codes(0));
      CHECK(to.stencil_codes() == from.sample_stencil_codes(0));
      const Image<Rgba8> codes = to.colour_image();
      const Image<Rgba32F> linear = to.linear_image();
      std::vector<Image<Rgba8>> sample_codes;
      std::vector<Image<Rgba32F>> sample_light;
      for (int s = 0; s < samples; ++s) {
        sample_codes.push_back(from.sample_colour_image(s));
        sample_light.push_back(from.sample_linear_image(s));
      }
      for (int y = 0; y < 68; ++y)
        for (int x = 0; x < 75; ++x) {
          int sum = 0, alpha_sum = 0;
          double light = 0;
          for (std::size_t s = 0; s < sample_codes.size(); ++s) {
            sum += sample_codes[s].at(x, y).g, alpha_sum += sample_codes[s].at(x, y).a;
            light += static_cast<double>(sample_light[s].at(x, y).g);
          }
          const auto mean = [&](int total) { return static_cast<int>(std::floor(static_cast<double>(total) / samples + 0.5)); };
          if (format == ColourFormat::rgba8) CHECK(codes.at(x, y).g == mean(sum));
          if (format == ColourFormat::srgb8) CHECK(codes.at(x, y).g == srgb_code_from_linear(light / samples));
          if (format == ColourFormat::rgba8 || format == ColourFormat::srgb8) CHECK(codes.at(x, y).a == mean(alpha_sum));
          if (format == ColourFormat::rgba32f) CHECK(linear.at(x, y).g == Approx(light / samples).margin(1e-6));
          if (format == ColourFormat::rgba16f) CHECK(linear.at(x, y).g == Approx(light / samples).epsilon(0x1p-10).margin(1e-6));
        }
    }
}

TEST_CASE("render target: resolving refuses targets that do not fit", "[raster]") {
  Workers workers(1);
  const RenderTarget from = target_of({.width = 16, .height = 8, .samples = 4});
  RenderTarget other_size = target_of({.width = 16, .height = 9}), other_format = target_of({.width = 16, .height = 8, .colour = ColourFormat::srgb8});
  RenderTarget sampled = target_of({.width = 16, .height = 8, .samples = 2});
  CHECK_THAT(refusal_of(resolve(from, other_size, workers)), Contains("16x8 and 16x9"));
  CHECK_THAT(refusal_of(resolve(from, other_format, workers)), Contains("rgba8 and srgb8"));
  CHECK_THAT(refusal_of(resolve(from, sampled, workers)), Contains("2 samples"));
}

}  // namespace tuberia
