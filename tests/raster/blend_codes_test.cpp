// Everyday blending on codes of 8 bits, against the same arithmetic done one float at a time.

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "math/colour.hpp"
#include "tests/support/blocks.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"

namespace tuberia {
namespace {

using Codes = std::array<Rgba8, kBlockPixels>;
constexpr int kBlocksOfAllCodes = 256 / kBlockPixels;

/// Blocks that hold every code in every channel, with other neighbours in each.
Codes codes_of_block(int block) {
  Codes codes;
  for (int i = 0; i < kBlockPixels; ++i) {
    const int code = block * kBlockPixels + i;
    const auto byte = [](int value) { return static_cast<std::uint8_t>(value & 255); };
    codes[static_cast<std::size_t>(i)] = {byte(code), byte(255 - code), byte(code * 7 + 3), byte(code * 13 + 101)};
  }
  return codes;
}

float in_unit(float x) { return x > 0 ? (x < 1 ? x : 1.0f) : 0.0f; }

/// One channel of a pixel, by the rules; `source` and `alpha` as the fragment has them.
float blended(float source, float alpha, bool is_alpha, float stored, BlendMode mode) {
  const float c = in_unit(source), a = in_unit(alpha);
  if (mode == BlendMode::additive) return in_unit(c + stored);
  const float rest = 1.0f - a, kept = stored * rest;
  return in_unit(kept + (is_alpha ? a : c * a));
}

std::uint8_t blended_code(float source, float alpha, bool is_alpha, std::uint8_t code, BlendMode mode, ColourFormat format) {
  if (format == ColourFormat::srgb8 && !is_alpha)
    return srgb_code_from_linear(static_cast<double>(blended(source, alpha, false, linear_from_srgb_codes()[code], mode)));
  return unorm8_from_linear(blended(source, alpha, is_alpha, static_cast<float>(code) * (1.0f / 255.0f), mode));
}

Rgba8 blended_pixel(const Rgba32F& source, const Rgba8& p, BlendMode mode, ColourFormat format) {
  return {blended_code(source.r, source.a, false, p.r, mode, format), blended_code(source.g, source.a, false, p.g, mode, format),
          blended_code(source.b, source.a, false, p.b, mode, format), blended_code(source.a, source.a, true, p.a, mode, format)};
}

/// What a block's pixels become under one colour.
Codes laid_on(const Codes& codes, const Rgba32F& colour, BlendMode mode, ColourFormat format, InstructionSet set, Precision precision) {
  RenderTarget target = test::small_target(format, DepthFormat::d24);
  std::array<Rgba32F, kBlockPixels> colours;
  colours.fill(colour);
  OutputState state = test::output_state(format, DepthFormat::d24);
  state.blend.mode = mode;
  const Tile tile = target.tile(0);
  std::memcpy(tile.colour, codes.data(), sizeof codes);
  block_kernels(set, precision).blend(test::colour_block(colours), state, tile);
  Codes result;
  std::memcpy(result.data(), tile.colour, sizeof result);
  return result;
}

/// Colours of fragments: the ends, what lies outside and next to them, codes, and any.
std::vector<Rgba32F> many_sources(test::Random& random) {
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const float special[] = {0, -0.0f, 1, 0.5f, 0.25f, 128.0f / 255.0f, std::nextafter(1.0f, 0.0f), std::nextafter(1.0f, 2.0f), 1e-30f,
                           0x1p-24f, -1e-7f, -3, 7, inf, -inf, nan};
  const auto any = [&] {
    const std::int64_t kind = random.below(4);
    if (kind == 0) return special[random.below(std::ssize(special))];
    if (kind == 1) return static_cast<float>(random.below(256)) / 255.0f;
    return random.between(0, 1);
  };
  std::vector<Rgba32F> sources;
  for (const float alpha : special) sources.push_back({any(), any(), any(), alpha});
  for (int code = 0; code < 256; ++code) sources.push_back({any(), any(), any(), static_cast<float>(code) / 255.0f});
  for (int i = 0; i < 500; ++i) sources.push_back({any(), any(), any(), any()});
  return sources;
}

bool differ_by_one_at_most(const Rgba8& a, const Rgba8& b) {
  return std::abs(a.r - b.r) <= 1 && std::abs(a.g - b.g) <= 1 && std::abs(a.b - b.b) <= 1 && std::abs(a.a - b.a) <= 1;
}

}  // namespace

TEST_CASE("blend codes: every stored code under many colours is what floats make of it", "[raster][exact]") {
  test::Random random(1301);
  const std::vector<Rgba32F> sources = many_sources(random);
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    for (const ColourFormat format : {ColourFormat::rgba8, ColourFormat::srgb8})
      for (const BlendMode mode : {BlendMode::source_over, BlendMode::additive})
        for (const Rgba32F& source : sources)
          for (int block = 0; block < kBlocksOfAllCodes; ++block) {
            const Codes before = codes_of_block(block), after = laid_on(before, source, mode, format, set, precision);
            for (std::size_t i = 0; i < before.size(); ++i) {
              const Rgba8 expected = blended_pixel(source, before[i], mode, format);
              // Fast: one rounding fewer, which may take a code across its border.
              if (precision == Precision::exact ? after[i] != expected : !differ_by_one_at_most(after[i], expected))
                FAIL("mode " << static_cast<int>(mode) << ", format " << static_cast<int>(format) << ", source " << source.r << ' ' << source.g
                             << ' ' << source.b << ' ' << source.a << ", pixel " << i << " of block " << block);
            }
          }
  });
}

// rules B1; a code's border is where roundings of the product, of the sum or of both would show.
TEST_CASE("blend codes: every float within a thousand of a code's border is rounded right", "[raster][exact]") {
  constexpr std::int32_t kAround = 1000;
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    RenderTarget target = test::small_target(ColourFormat::rgba8, DepthFormat::d24);
    const Tile tile = target.tile(0);
    const OutputState state = test::output_state(ColourFormat::rgba8, DepthFormat::d24);
    for (int code = 0; code < 255; ++code) {
      const std::int32_t border = std::bit_cast<std::int32_t>((static_cast<float>(code) + 0.5f) / 255.0f);
      for (std::int32_t bits = border - kAround; bits <= border + kAround; bits += kBlockPixels) {
        std::array<Rgba32F, kBlockPixels> colours;
        for (std::size_t i = 0; i < colours.size(); ++i) {
          const auto x = [&](int further) { return std::bit_cast<float>(bits + static_cast<std::int32_t>(i) + further); };
          colours[i] = {x(0), x(1), x(2), x(3)};
        }
        block_kernels(set, precision).blend(test::colour_block(colours), state, tile);
        for (std::size_t i = 0; i < colours.size(); ++i) {
          const Rgba8 stored = static_cast<const Rgba8*>(tile.colour)[i];
          const Rgba8 expected = blended_pixel(colours[i], {0, 0, 0, 0}, BlendMode::additive, ColourFormat::rgba8);
          if (stored != expected) FAIL("intensity " << std::hexfloat << colours[i].r << " and the next three");
        }
      }
    }
  });
}

}  // namespace tuberia
