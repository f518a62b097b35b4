#include <catch2/catch.hpp>

#include <cmath>

#include "math/colour.hpp"
#include "raster/half_float.hpp"
#include "tests/support/blocks.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"

namespace tuberia {

using test::for_every_machine;

namespace {

constexpr int kFactors = 15, kEquations = 5, kLogicOperations = 17;
using BlockColours = std::array<Rgba32F, kBlockPixels>;
using Channels = std::array<double, 4>;

Channels channels_of(const Rgba32F& c) {
  return {static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b), static_cast<double>(c.a)};
}

double factor_of(BlendFactor factor, std::size_t c, const Channels& s, const Channels& d, const Channels& k) {
  switch (factor) {
    case BlendFactor::zero: return 0;
    case BlendFactor::one: return 1;
    case BlendFactor::source_colour: return s[c];
    case BlendFactor::one_minus_source_colour: return 1 - s[c];
    case BlendFactor::destination_colour: return d[c];
    case BlendFactor::one_minus_destination_colour: return 1 - d[c];
    case BlendFactor::source_alpha: return s[3];
    case BlendFactor::one_minus_source_alpha: return 1 - s[3];
    case BlendFactor::destination_alpha: return d[3];
    case BlendFactor::one_minus_destination_alpha: return 1 - d[3];
    case BlendFactor::constant_colour: return k[c];
    case BlendFactor::one_minus_constant_colour: return 1 - k[c];
    case BlendFactor::constant_alpha: return k[3];
    case BlendFactor::one_minus_constant_alpha: return 1 - k[3];
    case BlendFactor::source_alpha_saturate: return c == 3 ? 1 : std::min(s[3], 1 - d[3]);
  }
  return -1;
}

/// The new pixel by the definition, in double, not rounded.
Channels blended(const BlendState& state, const Channels& s, const Channels& d, const Channels& k) {
  Channels out;
  for (std::size_t c = 0; c < 4; ++c) {
    const BlendFunction& f = c == 3 ? state.alpha : state.colour;
    const double source = s[c] * factor_of(f.source, c, s, d, k), destination = d[c] * factor_of(f.destination, c, s, d, k);
    switch (f.equation) {
      case BlendEquation::add: out[c] = source + destination; break;
      case BlendEquation::subtract: out[c] = source - destination; break;
      case BlendEquation::reverse_subtract: out[c] = destination - source; break;
      case BlendEquation::min: out[c] = std::min(s[c], d[c]); break;
      case BlendEquation::max: out[c] = std::max(s[c], d[c]); break;
    }
  }
  return out;
}

BlockColours random_colours(test::Random& random, float low, float high) {
  BlockColours colours;
  for (Rgba32F& c : colours) c = {random.between(low, high), random.between(low, high), random.between(low, high), random.between(low, high)};
  return colours;
}

void store_colours(RenderTarget& target, const BlockColours& colours, InstructionSet set) {
  block_kernels(set, Precision::exact).blend(test::colour_block(colours), test::output_state(target.colour_format(), target.depth_format()), target.tile(0));
}

/// Calls law(state) for all pairs of factors and equations, each with random ones for alpha.
template <class Law>
void for_every_function(test::Random& random, Law&& law) {
  const auto any_factor = [&] { return static_cast<BlendFactor>(random.below(kFactors)); };
  for (int source = 0; source < kFactors; ++source)
    for (int destination = 0; destination < kFactors; ++destination)
      for (int equation = 0; equation < kEquations; ++equation) {
        BlendState state;
        state.mode = BlendMode::function;
        state.colour = {static_cast<BlendFactor>(source), static_cast<BlendFactor>(destination), static_cast<BlendEquation>(equation)};
        state.alpha = {any_factor(), any_factor(), static_cast<BlendEquation>(random.below(kEquations))};
        state.constant = {random.between(0, 1), random.between(0, 1), random.between(0, 1), random.between(0, 1)};
        INFO("factors " << source << " and " << destination << ", equation " << equation);
        law(state);
      }
}

Rgba8 logic_by_bits(LogicOperation operation, Rgba8 s, Rgba8 d) {
  // Rows of the truth table: the result where (S, D) is (1, 1), (1, 0), (0, 1), (0, 0).
  static constexpr int kTable[kLogicOperations] = {12, 0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15};
  const int table = kTable[static_cast<int>(operation)];
  const auto channel = [&](std::uint8_t a, std::uint8_t b) {
    int result = 0;
    for (int bit = 0; bit < 8; ++bit) result |= (table >> ((a >> bit & 1) * 2 + (b >> bit & 1)) & 1) << bit;
    return static_cast<std::uint8_t>(result);
  };
  return {channel(s.r, d.r), channel(s.g, d.g), channel(s.b, d.b), channel(s.a, d.a)};
}

}  // namespace

TEST_CASE("blending: all factors and equations on 8-bit codes come to the nearest code", "[raster][exact][C36]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    test::Random random(351);
    for_every_function(random, [&](const BlendState& blend) {
      RenderTarget target = test::small_target(ColourFormat::rgba8, DepthFormat::d24);
      store_colours(target, random_colours(random, 0, 1), set);
      const auto before = test::in_block_order(target.linear_image());
      const BlockColours colours = random_colours(random, 0, 1);
      OutputState state = test::output_state(ColourFormat::rgba8, DepthFormat::d24);
      state.blend = blend;
      block_kernels(set, precision).blend(test::colour_block(colours), state, target.tile(0));
      const auto after = test::in_block_order(target.colour_image());
      for (std::size_t i = 0; i < kBlockPixels; ++i) {
        const Channels expected = blended(blend, channels_of(colours[i]), channels_of(before[i]), channels_of(blend.constant));
        const std::uint8_t found[4] = {after[i].r, after[i].g, after[i].b, after[i].a};
        for (std::size_t c = 0; c < 4; ++c) {
          // Half a code off at most, but for what floats lose: only next to a tie another code is right.
          const double code = std::clamp(expected[c], 0.0, 1.0) * 255;
          if (std::fabs(code - found[c]) > 0.5 + 1e-4) FAIL("seed 351, fragment " << i << ", channel " << c << ": " << int{found[c]} << " for " << code);
        }
      }
    });
  });
}

TEST_CASE("blending: all factors and equations on floats and halves, unbounded", "[raster][C36]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    for (const ColourFormat format : {ColourFormat::rgba32f, ColourFormat::rgba16f}) {
      test::Random random(352);
      const double relative = format == ColourFormat::rgba16f ? 0x1p-11 * 1.01 : 1e-6;
      for_every_function(random, [&](const BlendState& blend) {
        RenderTarget target = test::small_target(format, DepthFormat::d24);
        store_colours(target, random_colours(random, -2, 3), set);
        const auto before = test::in_block_order(target.linear_image());
        const BlockColours colours = random_colours(random, -2, 3);
        OutputState state = test::output_state(format, DepthFormat::d24);
        state.blend = blend;
        block_kernels(set, precision).blend(test::colour_block(colours), state, target.tile(0));
        const auto after = test::in_block_order(target.linear_image());
        for (std::size_t i = 0; i < kBlockPixels; ++i) {
          const Channels expected = blended(blend, channels_of(colours[i]), channels_of(before[i]), channels_of(blend.constant));
          const Channels found = channels_of(after[i]);
          for (std::size_t c = 0; c < 4; ++c)
            if (std::fabs(found[c] - expected[c]) > relative * std::fabs(expected[c]) + 2e-6) FAIL("seed 352, fragment " << i << ", channel " << c << ": " << found[c] << " for " << expected[c]);
        }
      });
    }
  });
}

TEST_CASE("blending: the everyday modes are blend functions", "[raster][exact]") {
  struct Known {
    BlendMode mode;
    BlendFunction colour, alpha;
  };
  const BlendFunction copy{}, sum{BlendFactor::one, BlendFactor::one, BlendEquation::add};
  const BlendFunction over{BlendFactor::source_alpha, BlendFactor::one_minus_source_alpha, BlendEquation::add};
  const BlendFunction over_alpha{BlendFactor::one, BlendFactor::one_minus_source_alpha, BlendEquation::add};
  test::for_every_instruction_set([&](InstructionSet set) {
    for (const Known& known : {Known{BlendMode::replace, copy, copy}, {BlendMode::source_over, over, over_alpha}, {BlendMode::additive, sum, sum}})
      for (const ColourFormat format : {ColourFormat::rgba8, ColourFormat::srgb8, ColourFormat::rgba32f, ColourFormat::rgba16f}) {
        INFO("mode " << static_cast<int>(known.mode) << ", format " << static_cast<int>(format));
        test::Random random(353);
        const BlockColours below = random_colours(random, -0.5f, 1.5f), above = random_colours(random, -0.5f, 1.5f);
        Image<Rgba32F> images[2];
        for (const bool by_function : {false, true}) {
          RenderTarget target = test::small_target(format, DepthFormat::d24);
          store_colours(target, below, set);
          OutputState state = test::output_state(format, DepthFormat::d24);
          state.blend = {.mode = by_function ? BlendMode::function : known.mode, .colour = known.colour, .alpha = known.alpha};
          block_kernels(set, Precision::exact).blend(test::colour_block(above, 0xfedcba9876543210u), state, target.tile(0));
          images[by_function] = target.linear_image();
        }
        CHECK(images[0] == images[1]);
      }
  });
}

TEST_CASE("blending: logic operations work on codes bit by bit", "[raster][exact]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    test::Random random(354);
    for (int operation = 1; operation < kLogicOperations; ++operation) {
      INFO("operation " << operation);
      RenderTarget target = test::small_target(ColourFormat::rgba8, DepthFormat::d24);
      store_colours(target, random_colours(random, 0, 1), set);
      const auto before = test::in_block_order(target.colour_image());
      const BlockColours colours = random_colours(random, -0.1f, 1.1f);
      OutputState state = test::output_state(ColourFormat::rgba8, DepthFormat::d24);
      state.blend.logic = static_cast<LogicOperation>(operation);
      state.blend.mode = BlendMode::additive;  // has no say
      block_kernels(set, precision).blend(test::colour_block(colours), state, target.tile(0));
      const auto after = test::in_block_order(target.colour_image());
      for (std::size_t i = 0; i < kBlockPixels; ++i) {
        const Rgba32F& c = colours[i];
        const Rgba8 source{unorm8_from_linear(c.r), unorm8_from_linear(c.g), unorm8_from_linear(c.b), unorm8_from_linear(c.a)};
        if (after[i] != logic_by_bits(state.blend.logic, source, before[i])) FAIL("seed 354, fragment " << i);
      }
    }
  });
}

TEST_CASE("blending: channels that are masked keep every bit", "[raster][exact]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    for (const ColourFormat format : {ColourFormat::rgba8, ColourFormat::srgb8, ColourFormat::rgba32f, ColourFormat::rgba16f})
      for (int bits = 0; bits < 16; ++bits) {
        INFO("format " << static_cast<int>(format) << ", mask " << bits);
        test::Random random(355);
        RenderTarget masked = test::small_target(format, DepthFormat::d24), whole = test::small_target(format, DepthFormat::d24);
        const BlockColours below = random_colours(random, 0, 1), above = random_colours(random, 0, 1);
        store_colours(masked, below, set);
        store_colours(whole, below, set);
        const auto before = test::in_block_order(masked.linear_image());
        OutputState state = test::output_state(format, DepthFormat::d24);
        state.blend.mode = BlendMode::source_over;
        block_kernels(set, precision).blend(test::colour_block(above), state, whole.tile(0));
        state.blend.mask = {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
        block_kernels(set, precision).blend(test::colour_block(above), state, masked.tile(0));
        const auto all = test::in_block_order(whole.linear_image()), after = test::in_block_order(masked.linear_image());
        for (std::size_t i = 0; i < kBlockPixels; ++i) {
          const auto chosen = [&](int bit, float on, float off) { return (bits >> bit & 1) != 0 ? on : off; };
          const Rgba32F expected{chosen(0, all[i].r, before[i].r), chosen(1, all[i].g, before[i].g), chosen(2, all[i].b, before[i].b), chosen(3, all[i].a, before[i].a)};
          if (after[i] != expected) FAIL("seed 355, fragment " << i);
        }
      }
  });
}

TEST_CASE("blending: samples are blended each with their own pixel, and only the live ones", "[raster][exact]") {
  test::for_every_instruction_set([](InstructionSet set) {
    for (const ColourFormat format : {ColourFormat::rgba8, ColourFormat::rgba32f, ColourFormat::rgba16f}) {
      test::Random random(356);
      RenderTarget target = *RenderTarget::create({.width = kBlockSize, .height = kBlockSize, .colour = format, .samples = 4});
      OutputState state = test::output_state(format, DepthFormat::d24);
      state.samples = 4;
      FragmentBlock block = test::colour_block(random_colours(random, 0, 0.5f));
      block.samples = 4;
      for (std::uint64_t& live : block.sample_live) live = 0;
      for (int s = 0; s < 4; ++s) block.sample_live[s] = random.u64();
      state.blend.mode = BlendMode::additive;
      for (int layer = 0; layer < 2; ++layer) block_kernels(set, Precision::exact).blend(block, state, target.tile(0));
      RenderTarget one = test::small_target(format, DepthFormat::d24);
      block.samples = 1;
      block.live = block.sample_live[0] = ~std::uint64_t{0};
      for (int layer = 0; layer < 2; ++layer) block_kernels(set, Precision::exact).blend(block, state, one.tile(0));
      random = test::Random(356);
      random_colours(random, 0, 0.5f);
      const auto added = test::in_block_order(one.linear_image());
      for (int s = 0; s < 4; ++s) {
        const std::uint64_t live = random.u64();
        const auto pixels = test::in_block_order(target.sample_linear_image(s));
        for (std::size_t i = 0; i < kBlockPixels; ++i)
          if (pixels[i] != ((live >> i & 1u) != 0 ? added[i] : Rgba32F{0, 0, 0, 0})) FAIL("seed 356, sample " << s << ", fragment " << i);
      }
    }
  });
}

}  // namespace tuberia
