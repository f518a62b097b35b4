#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>

#include "tests/support/blocks.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"

namespace tuberia {

using test::for_every_machine;

namespace {

/// A block of colour (1, 0.5, 0, 0.25) whose fog coordinate is the same at all three corners.
struct FoggedBlock {
  ScreenTriangle triangle{};
  float corners[3];
  FragmentBlock block = test::colour_block(grey());

  explicit FoggedBlock(float coordinate) : corners{coordinate, coordinate, coordinate} {
    triangle.perspective = kIsAffine;
    triangle.vertex[1] = 1, triangle.vertex[2] = 2;
    block.triangle = &triangle;
    for (int i = 0; i < kBlockPixels; ++i) block.weight[0][i] = static_cast<float>(i) / 100, block.weight[1][i] = 0.125f;
  }
  static std::array<Rgba32F, kBlockPixels> grey() {
    std::array<Rgba32F, kBlockPixels> colours;
    colours.fill({1, 0.5f, 0, 0.25f});
    return colours;
  }
  void apply(const FogState& fog, InstructionSet set, Precision precision) {
    OutputState state;
    state.fog = fog;
    block_kernels(set, precision).fog(block, {.fog = corners}, state);
  }
};

/// What is left of the colour 1 in black fog.
float fog_left(FogMode mode, float coordinate, InstructionSet set, Precision precision, float density = 1, float start = 0, float end = 1) {
  FoggedBlock fogged(coordinate);
  fogged.apply({.mode = mode, .density = density, .start = start, .end = end}, set, precision);
  return fogged.block.colour[0][17];
}

/// Fragment i of sample counts that a block of these alphas keeps.
std::vector<int> samples_kept(const FragmentBlock& block) {
  std::vector<int> kept(kBlockPixels, 0);
  for (int s = 0; s < block.samples; ++s)
    for (std::size_t i = 0; i < kBlockPixels; ++i) {
      const int live = static_cast<int>(block.sample_live[s] >> i & 1u);
      if (live != 0) CHECK(kept[i] == s);  // the first samples, without gaps
      kept[i] += live;
    }
  return kept;
}

FragmentBlock alpha_block(const std::vector<float>& alphas, int samples) {
  std::array<Rgba32F, kBlockPixels> colours{};
  for (std::size_t i = 0; i < kBlockPixels; ++i) colours[i].a = alphas[i % alphas.size()];
  FragmentBlock block = test::colour_block(colours);
  block.samples = samples;
  for (int s = 0; s < samples; ++s) block.sample_live[s] = ~std::uint64_t{0};
  return block;
}

}  // namespace

// rules F1
TEST_CASE("fog: known shares", "[raster][case-52]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    for (const float density : {0.35f, 1.0f, 7.0f}) {
      CHECK(fog_left(FogMode::exp, 0.875f / density, set, precision, density) == Approx(.4168620196785084).epsilon(1e-6));
      CHECK(fog_left(FogMode::exp2, 0.875f / density, set, precision, density) == Approx(.46504318813405631).epsilon(1e-6));
    }
    CHECK(fog_left(FogMode::linear, 4, set, precision, 1, 2, 10) == 0.75f);
    CHECK(fog_left(FogMode::linear, -4, set, precision, 1, 2, 10) == 0.75f);  // the coordinate's absolute value
  });
}

TEST_CASE("fog: its share stays in [0, 1], whatever the coordinate", "[raster][exact]") {
  const float inf = std::numeric_limits<float>::infinity();
  for_every_machine([&](InstructionSet set, Precision precision) {
    CHECK(fog_left(FogMode::linear, 1, set, precision, 1, 2, 10) == 1);
    CHECK(fog_left(FogMode::linear, 11, set, precision, 1, 2, 10) == 0);
    CHECK(fog_left(FogMode::linear, 1, set, precision, 1, 5, 5) == 1);
    CHECK(fog_left(FogMode::linear, 9, set, precision, 1, 5, 5) == 0);
    CHECK(fog_left(FogMode::linear, 5, set, precision, 1, 5, 5) == 0);
    for (const FogMode mode : {FogMode::exp, FogMode::exp2}) {
      CHECK(fog_left(mode, 0, set, precision) == 1);
      CHECK(fog_left(mode, 1e30f, set, precision) == 0);
    }
    CHECK(fog_left(FogMode::exp, inf, set, precision) == 0);
  });
}

TEST_CASE("fog: mixes with its colour and leaves alpha alone", "[raster][exact]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    FoggedBlock fogged(3);
    fogged.apply({.mode = FogMode::linear, .colour = {0, 0.25f, 1, 1}, .start = 0, .end = 4}, set, precision);
    for (int i = 0; i < kBlockPixels; ++i) {
      const FragmentBlock& b = fogged.block;
      CHECK((b.colour[0][i] == 0.25f && b.colour[1][i] == 0.3125f && b.colour[2][i] == 0.75f && b.colour[3][i] == 0.25f));
    }
  });
}

TEST_CASE("fog: its coordinate is interpolated with perspective", "[raster]") {
  // Halfway on the screen between w = 1 and w = 3 lies a quarter of the way on the triangle.
  for_every_machine([](InstructionSet set, Precision precision) {
    FoggedBlock fogged(0);
    fogged.triangle.perspective = kDividesEachPixel;
    fogged.triangle.inverse_w[0] = 1, fogged.triangle.inverse_w[1] = 1.0f / 3.0f, fogged.triangle.inverse_w[2] = 1;
    fogged.corners[1] = 8;
    for (int i = 0; i < kBlockPixels; ++i) fogged.block.weight[0][i] = 0.5f, fogged.block.weight[1][i] = 0;
    fogged.apply({.mode = FogMode::linear, .start = 0, .end = 10}, set, precision);
    CHECK(fogged.block.colour[0][40] == Approx(0.8).epsilon(1e-6));
  });
}

TEST_CASE("alpha test: all eight comparisons, on alpha clamped to [0, 1]", "[raster][exact]") {
  const float reference = 0.4f;
  const std::vector<float> alphas{reference, std::nextafter(reference, 0.0f), std::nextafter(reference, 1.0f), 0, 1, -3, 7, std::numeric_limits<float>::quiet_NaN()};
  for_every_machine([&](InstructionSet set, Precision precision) {
    for (const float limit : {reference, 0.0f, 1.0f})
      for (int test = 0; test < 8; ++test) {
        INFO("comparison " << test << " with " << limit);
        OutputState state;
        state.alpha_test = {static_cast<Compare>(test), limit};
        FragmentBlock block = alpha_block(alphas, 1);
        const std::uint64_t before = block.live = block.sample_live[0] = 0xfedcba9876543210u;
        block_kernels(set, precision).alpha_test(block, state);
        for (std::size_t i = 0; i < kBlockPixels; ++i) {
          const float a = alphas[i % alphas.size()] > 0 ? std::min(alphas[i % alphas.size()], 1.0f) : 0.0f;
          const bool holds[] = {false, a < limit, a == limit, a <= limit, a > limit, a != limit, a >= limit, true};
          CHECK((block.live >> i & 1u) == (holds[test] ? before >> i & 1u : 0u));
        }
        CHECK(block.sample_live[0] == block.live);
      }
  });
}

TEST_CASE("alpha to coverage: alpha decides how many of the first samples stay", "[raster][exact]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    for (const int samples : {1, 2, 4, 8, 16}) {
      // Even steps, and the borders between two counts from both sides.
      std::vector<float> alphas{-1, 0, 1, 2, std::numeric_limits<float>::quiet_NaN()};
      for (int k = 0; k < samples; ++k) {
        const float border = (static_cast<float>(k) + 0.5f) / static_cast<float>(samples);
        for (const float a : {border, std::nextafter(border, 0.0f), std::nextafter(border, 1.0f)}) alphas.push_back(a);
      }
      FragmentBlock block = alpha_block(alphas, samples);
      OutputState state;
      state.multisampling.alpha_to_coverage = true;
      block_kernels(set, precision).alpha_test(block, state);
      const std::vector<int> kept = samples_kept(block);
      for (std::size_t i = 0; i < kBlockPixels; ++i) {
        const float alpha = alphas[i % alphas.size()] > 0 ? std::min(alphas[i % alphas.size()], 1.0f) : 0.0f;
        CHECK(kept[i] == static_cast<int>(std::floor(static_cast<double>(alpha) * samples + 0.5)));
        CHECK((block.live >> i & 1u) == (kept[i] > 0 ? 1u : 0u));
      }
    }
  });
}

TEST_CASE("alpha to coverage: samples that are not covered stay so, and the alpha test comes on top", "[raster][exact]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    FragmentBlock block = alpha_block({0.5f, 0.25f, 1, 0}, 4);
    block.sample_live[0] = 0, block.sample_live[2] = 0x0fu;
    OutputState state;
    state.multisampling.alpha_to_coverage = true;
    state.alpha_test = {Compare::greater, 0.3f};
    block_kernels(set, precision).alpha_test(block, state);
    CHECK(block.sample_live[0] == 0);
    CHECK(block.sample_live[1] == 0x5555555555555555u);  // of alpha 0.5 and 1
    CHECK(block.sample_live[2] == 0x4u);
    CHECK(block.sample_live[3] == 0x4444444444444444u);
    CHECK(block.live == 0x5555555555555555u);
  });
}

}  // namespace tuberia
