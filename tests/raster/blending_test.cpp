#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

#include "math/colour.hpp"
#include "tests/support/blocks.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"

namespace tuberia {

using test::for_every_machine;

namespace {

using Colours = std::array<Rgba32F, kBlockPixels>;
constexpr ColourFormat kColourFormats[] = {ColourFormat::rgba8, ColourFormat::srgb8, ColourFormat::rgba32f};

Colours all_of(const Rgba32F& colour) {
  Colours colours;
  colours.fill(colour);
  return colours;
}

void blend_into(RenderTarget& target, const Colours& colours, BlendMode mode, InstructionSet set, Precision precision,
                std::uint64_t live = ~std::uint64_t{0}) {
  OutputState state = test::output_state(target.colour_format(), target.depth_format());
  state.blend.mode = mode;
  block_kernels(set, precision).blend(test::colour_block(colours, live), state, target.tile(0));
}

/// A white pixel after these layers, drawn in order.
Rgba8 over_white(ColourFormat format, std::span<const Rgba32F> layers, InstructionSet set, Precision precision) {
  RenderTarget target = test::small_target(format, DepthFormat::d24, {1, 1, 1, 1});
  for (const Rgba32F& layer : layers) blend_into(target, all_of(layer), BlendMode::source_over, set, precision);
  return target.colour_image().at(5, 6);
}
Rgba32F over_white_float(std::span<const Rgba32F> layers, InstructionSet set, Precision precision) {
  RenderTarget target = test::small_target(ColourFormat::rgba32f, DepthFormat::d24, {1, 1, 1, 1});
  for (const Rgba32F& layer : layers) blend_into(target, all_of(layer), BlendMode::source_over, set, precision);
  return target.linear_image().at(5, 6);
}

/// Intensities from 0 to 1 by even steps and by even steps of their bits, and all borders of codes.
std::vector<float> dense_intensities() {
  std::vector<float> values;
  for (int i = 0; i <= 30000; ++i) values.push_back(static_cast<float>(i) / 30000.0f);
  for (std::int32_t bits = 0x30000000; bits < 0x3f800000; bits += 8191) values.push_back(std::bit_cast<float>(bits));
  for (int code = 1; code < 256; ++code)
    for (const float border : {srgb_code_thresholds()[static_cast<std::size_t>(code)], (static_cast<float>(code) - 0.5f) / 255.0f})
      for (const float x : {border, std::nextafter(border, 0.0f), std::nextafter(border, 1.0f)}) values.push_back(x);
  const float inf = std::numeric_limits<float>::infinity();
  for (const float x : {-0.0f, -1e-30f, -1.0f, -inf, inf, 1.5f, 1e38f, std::nextafter(1.0f, 0.0f), 1e-45f}) values.push_back(x);
  while (values.size() % kBlockPixels != 0) values.push_back(std::numeric_limits<float>::quiet_NaN());
  return values;
}

/// Stores all values as all four channels and calls check(value, pixel).
template <class Check>
void store_all(const std::vector<float>& values, ColourFormat format, InstructionSet set, Precision precision, Check&& check) {
  RenderTarget target = test::small_target(format, DepthFormat::d24);
  for (std::size_t first = 0; first < values.size(); first += kBlockPixels) {
    Colours colours;
    for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = {values[first + i], values[first + i], values[first + i], values[first + i]};
    blend_into(target, colours, BlendMode::replace, set, precision);
    const auto pixels = test::in_block_order(target.colour_image());
    for (std::size_t i = 0; i < colours.size(); ++i) check(values[first + i], pixels[i]);
  }
}

}  // namespace

TEST_CASE("blending: an sRGB target stores the nearest code of every intensity", "[raster][exact]") {
  const std::vector<float> values = dense_intensities();
  for_every_machine([&](InstructionSet set, Precision precision) {
    store_all(values, ColourFormat::srgb8, set, precision, [](float x, const Rgba8& pixel) {
      const std::uint8_t code = srgb_code_from_linear(static_cast<double>(x));
      if (pixel != Rgba8{code, code, code, unorm8_from_linear(x)}) FAIL("intensity " << std::hexfloat << x);
    });
  });
}

// rules B1
TEST_CASE("blending: a linear target stores floor(255 x + 1/2)", "[raster][exact][case-46]") {
  const std::vector<float> values = dense_intensities();
  for_every_machine([&](InstructionSet set, Precision precision) {
    store_all(values, ColourFormat::rgba8, set, precision, [](float x, const Rgba8& pixel) {
      const std::uint8_t code = unorm8_from_linear(x);
      if (pixel != Rgba8{code, code, code, code}) FAIL("intensity " << std::hexfloat << x);
    });
    const std::vector<float> known{0.5f, static_cast<float>(1.0 / 510 - 1e-9), static_cast<float>(1.0 / 510 + 1e-9), -0.0f,
                                   std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()};
    std::vector<float> block(kBlockPixels, 0.0f);
    std::copy(known.begin(), known.end(), block.begin());
    std::vector<int> codes;
    store_all(block, ColourFormat::rgba8, set, precision, [&](float, const Rgba8& pixel) { codes.push_back(pixel.g); });
    codes.resize(6);
    CHECK(codes == std::vector<int>{128, 0, 1, 0, 0, 255});
  });
}

TEST_CASE("blending: a float target keeps every bit", "[raster][exact]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    test::Random random(82);
    Colours colours;
    for (Rgba32F& c : colours) {
      const auto any = [&] { return std::bit_cast<float>(static_cast<std::uint32_t>(random.u64() & 0x7f7fffffu)); };
      c = {any(), -any(), any(), any()};
    }
    RenderTarget target = test::small_target(ColourFormat::rgba32f, DepthFormat::d24);
    blend_into(target, colours, BlendMode::replace, set, precision);
    CHECK(test::in_block_order(target.linear_image()) == colours);
  });
}

TEST_CASE("blending: layers in order, rounded after each", "[raster][exact][case-44]") {
  const float half = 128.0f / 255.0f;
  const Rgba32F red{1, 0, 0, half}, green{0, 1, 0, half}, blue{0, 0, 1, half};
  for_every_machine([&](InstructionSet set, Precision precision) {
    CHECK(over_white(ColourFormat::rgba8, std::vector{red}, set, precision) == Rgba8{255, 127, 127, 255});
    CHECK(over_white(ColourFormat::rgba8, std::vector{blue, green, red}, set, precision) == Rgba8{159, 95, 63, 255});
    CHECK(over_white(ColourFormat::rgba8, std::vector{red, green, blue}, set, precision) == Rgba8{63, 95, 159, 255});
    const Rgba32F exact = over_white_float(std::vector{blue, green, red}, set, precision);
    CHECK(exact.r * 255 == Approx(159.50146866589773).epsilon(1e-6));
    CHECK(exact.g * 255 == Approx(95.25048827374087).epsilon(1e-6));
    CHECK(exact.b * 255 == Approx(63.25098039215686).epsilon(1e-6));
    CHECK(exact.a == Approx(1).epsilon(1e-6));
  });
}

TEST_CASE("blending: thin layers stall on codes but not on floats", "[raster][case-45]") {
  struct Known {
    std::size_t layers;
    int code;
    double exact;
  };
  for_every_machine([](InstructionSet set, Precision precision) {
    for (const Known& k : {Known{1, 254, 254}, {10, 245, 245.1746}, {100, 155, 172.1448}, {255, 127, 93.6250}, {1000, 127, 5.0128}}) {
      INFO(k.layers << " layers");
      const std::vector<Rgba32F> layers(k.layers, {0, 0, 0, 1.0f / 255.0f});
      CHECK(over_white(ColourFormat::rgba8, layers, set, precision) == Rgba8{static_cast<std::uint8_t>(k.code), static_cast<std::uint8_t>(k.code), static_cast<std::uint8_t>(k.code), 255});
      CHECK(over_white_float(layers, set, precision).g * 255 == Approx(k.exact).margin(1e-4 * 255));
    }
  });
}

TEST_CASE("blending: sRGB targets mix light, not codes", "[raster]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    CHECK(over_white(ColourFormat::srgb8, std::vector{Rgba32F{0, 0, 0, 0.5f}}, set, precision) == Rgba8{188, 188, 188, 255});
    CHECK(over_white(ColourFormat::rgba8, std::vector{Rgba32F{0, 0, 0, 0.5f}}, set, precision) == Rgba8{128, 128, 128, 255});
  });
}

TEST_CASE("blending: nothing over a pixel leaves its code, all 256 of them", "[raster][exact]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    for (const ColourFormat format : {ColourFormat::rgba8, ColourFormat::srgb8})
      for (int first = 0; first < 256; first += kBlockPixels) {
        RenderTarget target = test::small_target(format, DepthFormat::d24);
        Colours colours;
        for (std::size_t i = 0; i < colours.size(); ++i) {
          const auto code = static_cast<std::size_t>(first) + i;
          const float a = static_cast<float>(code) / 255.0f, x = format == ColourFormat::srgb8 ? linear_from_srgb_codes()[code] : a;
          colours[i] = {x, x, x, a};
        }
        blend_into(target, colours, BlendMode::replace, set, precision);
        const Image<Rgba8> before = target.colour_image();
        CHECK(test::in_block_order(before)[7] == Rgba8{static_cast<std::uint8_t>(first + 7), static_cast<std::uint8_t>(first + 7), static_cast<std::uint8_t>(first + 7), static_cast<std::uint8_t>(first + 7)});
        blend_into(target, all_of({0.7f, 0.2f, 0.9f, 0}), BlendMode::source_over, set, precision);
        blend_into(target, all_of({0, 0, 0, 0}), BlendMode::additive, set, precision);
        CHECK(target.colour_image() == before);
      }
  });
}

TEST_CASE("blending: additive light saturates codes and grows floats", "[raster]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    for (const ColourFormat format : kColourFormats) {
      RenderTarget target = test::small_target(format, DepthFormat::d24, {0.25f, 0.75f, 0, 0.5f});
      blend_into(target, all_of({0.5f, 0.5f, 0.25f, 0.75f}), BlendMode::additive, set, precision);
      const Rgba32F pixel = target.linear_image().at(0, 0);
      const bool floats = format == ColourFormat::rgba32f;
      CHECK(pixel.r == Approx(0.75).margin(0.005));
      CHECK(pixel.g == (floats ? 1.25f : 1.0f));
      CHECK(pixel.a == (floats ? 1.25f : 1.0f));
    }
  });
}

TEST_CASE("blending: fragments that are not live leave their pixels alone", "[raster][exact]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    test::Random random(83);
    for (const ColourFormat format : kColourFormats)
      for (const BlendMode mode : {BlendMode::replace, BlendMode::source_over, BlendMode::additive}) {
        RenderTarget target = test::small_target(format, DepthFormat::d24, {0.25f, 0.5f, 0.75f, 1});
        const Rgba32F before = target.linear_image().at(0, 0);
        const std::uint64_t live = random.u64();
        blend_into(target, all_of({1, 0.125f, 0.25f, 0.5f}), mode, set, precision, live);
        const auto pixels = test::in_block_order(target.linear_image());
        for (std::size_t i = 0; i < pixels.size(); ++i) CHECK((pixels[i] != before) == ((live >> i & 1u) != 0));
      }
  });
}

TEST_CASE("blending: without write nothing changes", "[raster]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    RenderTarget target = test::small_target(ColourFormat::rgba8, DepthFormat::d24);
    OutputState state = test::output_state(ColourFormat::rgba8, DepthFormat::d24);
    state.blend.write = false;
    block_kernels(set, precision).blend(test::colour_block(all_of({1, 1, 1, 1})), state, target.tile(0));
    CHECK(target.colour_image().at(3, 3) == Rgba8{0, 0, 0, 0});
  });
}

}  // namespace tuberia
