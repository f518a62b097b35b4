#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>

#include "tests/support/blocks.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"

namespace tuberia {

using test::BlockFloats;
using test::for_every_machine;

namespace {

constexpr DepthFormat kDepthFormats[] = {DepthFormat::d16, DepthFormat::d24, DepthFormat::d32f};

/// What the buffer holds after an unconditional write of these depths.
std::array<std::int32_t, kBlockPixels> codes_of(const BlockFloats& depths, DepthFormat format, InstructionSet set, Precision precision,
                                                float min_depth = 0, float max_depth = 1) {
  RenderTarget target = test::small_target(ColourFormat::rgba8, format);
  OutputState state = test::output_state(ColourFormat::rgba8, format);
  state.depth = {.test = Compare::always, .write = true};
  state.min_depth = min_depth, state.max_depth = max_depth;
  test::DepthBlock block(depths);
  block_kernels(set, precision).depth_test(block.block(), state, target.tile(0));
  CHECK(block.block().live == ~std::uint64_t{0});
  return test::in_block_order(target.depth_codes());
}

bool holds(Compare test, float depth, float stored) {
  switch (test) {
    case Compare::never: return false;
    case Compare::less: return depth < stored;
    case Compare::equal: return depth == stored;
    case Compare::less_equal: return depth <= stored;
    case Compare::greater: return depth > stored;
    case Compare::not_equal: return depth != stored;
    case Compare::greater_equal: return depth >= stored;
    case Compare::always: break;
  }
  return true;
}

}  // namespace

// rules Z1
TEST_CASE("depth: one half is 8388608 of 24 bits and 32768 of 16", "[raster][exact]") {
  CHECK(code_of_depth(0.5f, DepthFormat::d24) == 8388608);
  CHECK(code_of_depth(0.5f, DepthFormat::d16) == 32768);
  CHECK(code_of_depth(0.5f, DepthFormat::d32f) == 0x3f000000);
  CHECK(code_of_depth(1, DepthFormat::d24) == 16777215);
  CHECK(code_of_depth(1, DepthFormat::d16) == 65535);
  for (const DepthFormat format : kDepthFormats) {
    CHECK(code_of_depth(-0.0f, format) == 0);
    CHECK(code_of_depth(-5, format) == 0);
    CHECK(code_of_depth(7, format) == code_of_depth(1, format));
    CHECK(code_of_depth(std::numeric_limits<float>::quiet_NaN(), format) == 0);
  }
}

TEST_CASE("depth: every code is the code of its own depth", "[raster][exact]") {
  const auto first_lost = [](DepthFormat format, std::int32_t last) {
    for (std::int32_t code = 0; code <= last; ++code)
      if (code_of_depth(depth_of_code(code, format), format) != code) return code;
    return last + 1;
  };
  CHECK(first_lost(DepthFormat::d16, 65535) == 65536);
  CHECK(first_lost(DepthFormat::d24, 16777215) == 16777216);
  for (const float depth : {0.0f, 1e-45f, 1e-30f, 0.1f, 0.99999994f, 1.0f})
    CHECK(depth_of_code(code_of_depth(depth, DepthFormat::d32f), DepthFormat::d32f) == depth);
}

TEST_CASE("depth: the kernels store the nearest code", "[raster][exact]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    test::Random random(81);
    for (int round = 0; round < 1500; ++round) {
      BlockFloats depths;
      for (float& depth : depths) {
        // A third of them anywhere, the others next to where one code of 16 or 24 bits becomes the next.
        const std::int64_t kind = random.below(3), bits = kind == 1 ? 16 : 24;
        const double last = static_cast<double>((1 << bits) - 1), border = (static_cast<double>(random.below(1 << random.below(bits + 1))) + 0.5) / last;
        depth = kind == 0 ? random.between(0, 1) : std::nextafter(static_cast<float>(border), random.between(0, 1));
      }
      for (const DepthFormat format : kDepthFormats) {
        const auto codes = codes_of(depths, format, set, precision);
        for (std::size_t i = 0; i < depths.size(); ++i)
          if (codes[i] != code_of_depth(depths[i], format))
            FAIL("seed 81, depth " << std::hexfloat << depths[i] << std::defaultfloat << ", format " << static_cast<int>(format)
                                   << ": code " << codes[i] << " instead of " << code_of_depth(depths[i], format));
      }
    }
  });
}

// rules Z2
TEST_CASE("depth: it is clamped to the viewport's range just before", "[raster][exact]") {
  BlockFloats depths{};
  const float some[] = {-1, -0.0f, 0, 0.1f, 0.25f, 0.3f, 0.75f, 0.9f, 1, 2, 1e30f, -1e30f};
  for (std::size_t i = 0; i < depths.size(); ++i) depths[i] = some[i % std::size(some)];
  for_every_machine([&](InstructionSet set, Precision precision) {
    for (const DepthFormat format : kDepthFormats)
      for (const auto& [low, high] : {std::pair{0.0f, 1.0f}, {0.25f, 0.75f}, {0.5f, 0.5f}}) {
        const auto codes = codes_of(depths, format, set, precision, low, high);
        for (std::size_t i = 0; i < depths.size(); ++i) CHECK(codes[i] == code_of_depth(std::clamp(depths[i], low, high), format));
      }
  });
}

TEST_CASE("depth: all eight comparisons pass what they say, and only that is written", "[raster][exact]") {
  // Neighbouring depths of a float buffer, on both sides of the stored one.
  const float stored = 0.625f;
  BlockFloats depths{};
  const float around[] = {stored, std::nextafter(stored, 0.0f), std::nextafter(stored, 1.0f), 0, 1};
  for (std::size_t i = 0; i < depths.size(); ++i) depths[i] = around[i % std::size(around)];
  constexpr std::uint64_t kLive = 0xfedcba9876543210u;
  for_every_machine([&](InstructionSet set, Precision precision) {
    for (int number = 0; number < 8; ++number)
      for (const bool write : {false, true}) {
        const auto test = static_cast<Compare>(number);
        INFO("comparison " << number << ", write " << write);
        RenderTarget target = test::small_target(ColourFormat::rgba8, DepthFormat::d32f, {0, 0, 0, 0}, stored);
        OutputState state = test::output_state(ColourFormat::rgba8, DepthFormat::d32f);
        state.depth = {.test = test, .write = write};
        test::DepthBlock block(depths, kLive);
        block_kernels(set, precision).depth_test(block.block(), state, target.tile(0));
        const auto codes = test::in_block_order(target.depth_codes());
        for (std::size_t i = 0; i < depths.size(); ++i) {
          const bool passes = (kLive >> i & 1u) != 0 && holds(test, depths[i], stored);
          CHECK((block.block().live >> i & 1u) == (passes ? 1u : 0u));
          CHECK(codes[i] == std::bit_cast<std::int32_t>(passes && write ? depths[i] : stored));
        }
      }
  });
}

TEST_CASE("depth: equal codes are equal depths, however different the floats were", "[raster][exact]") {
  // 16 bits cannot tell 0.500001 from 0.50001, so neither is less.
  BlockFloats depths{};
  depths.fill(0.500001f);
  for_every_machine([&](InstructionSet set, Precision precision) {
    for (const DepthFormat format : kDepthFormats) {
      RenderTarget target = test::small_target(ColourFormat::rgba8, format, {0, 0, 0, 0}, 0.50001f);
      test::DepthBlock block(depths);
      block_kernels(set, precision).depth_test(block.block(), test::output_state(ColourFormat::rgba8, format), target.tile(0));
      CHECK((block.block().live != 0) == (format != DepthFormat::d16));
    }
  });
}

}  // namespace tuberia
