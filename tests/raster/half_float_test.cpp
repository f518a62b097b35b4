#include "raster/half_float.hpp"

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <limits>

#include "tests/support/blocks.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"

namespace tuberia {

namespace {

/// The nearest half by the definition, in double: steps of 2^-24 up to 2^-14, then 11 leading bits.
std::uint16_t half_by_definition(float value) {
  if (std::isnan(value)) return 0x7e00;
  const int sign = std::signbit(value) ? 0x8000 : 0;
  const double magnitude = std::fabs(static_cast<double>(value));
  if (magnitude >= 65520) return static_cast<std::uint16_t>(sign | 0x7c00);
  const int exponent = std::max(magnitude == 0 ? -14 : std::ilogb(magnitude), -14);
  const double steps = std::nearbyint(std::ldexp(magnitude, 10 - exponent));  // ties to even
  return static_cast<std::uint16_t>(sign | (static_cast<int>(steps) + ((exponent + 14) << 10)));
}

/// Every half, the middles between neighbours and the floats on both sides of those; random bits.
std::vector<float> floats_around_halves() {
  std::vector<float> values;
  for (std::uint32_t half = 0; half < 0x7c00; ++half) {
    const float low = float_from_half(static_cast<std::uint16_t>(half));
    const float high = half == 0x7bff ? 65536.0f : float_from_half(static_cast<std::uint16_t>(half + 1));
    const float middle = low + (high - low) / 2;
    for (const float x : {low, middle, std::nextafter(middle, low), std::nextafter(middle, high)}) {
      values.push_back(x);
      values.push_back(-x);
    }
  }
  test::Random random(331);
  for (int i = 0; i < 50000; ++i) values.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(random.u64())));
  const float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  for (const float x : {inf, -inf, nan, -nan, 1e-45f, -1e-45f, 65519.99f, 65520.0f, -65519.99f, 3e38f}) values.push_back(x);
  while (values.size() % kBlockPixels != 0) values.push_back(0);
  return values;
}

}  // namespace

TEST_CASE("halves: every half is the half of its own value", "[raster][exact]") {
  for (std::uint32_t half = 0; half < 0x10000; ++half) {
    const auto code = static_cast<std::uint16_t>(half);
    const float value = float_from_half(code);
    if (std::isnan(value)) CHECK(half_from_float(value) == 0x7e00);
    else if (half_from_float(value) != code) FAIL("half " << half);
  }
  CHECK(float_from_half(0x3c00) == 1.0f);
  CHECK(float_from_half(0x0001) == 0x1p-24f);
  CHECK(float_from_half(0x7bff) == 65504.0f);
  CHECK(float_from_half(0xfc00) == -std::numeric_limits<float>::infinity());
}

// rules B1
TEST_CASE("halves: the nearest one, ties to even, infinite from 65520 on", "[raster][exact][case-46]") {
  CHECK(half_from_float(65519.99f) == 0x7bff);
  CHECK(half_from_float(65520.0f) == 0x7c00);
  for (const float value : floats_around_halves())
    if (half_from_float(value) != half_by_definition(value)) FAIL("seed 331, value " << std::hexfloat << value);
}

TEST_CASE("halves: the kernels store and read what one conversion does", "[raster][exact]") {
  const std::vector<float> values = floats_around_halves();
  test::for_every_machine([&](InstructionSet set, Precision precision) {
    RenderTarget target = test::small_target(ColourFormat::rgba16f, DepthFormat::d24);
    OutputState state = test::output_state(ColourFormat::rgba16f, DepthFormat::d24);
    for (std::size_t first = 0; first < values.size(); first += kBlockPixels) {
      std::array<Rgba32F, kBlockPixels> colours;
      for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = {values[first + i], 0, values[first + i], 1};
      state.blend.mode = BlendMode::replace;
      block_kernels(set, precision).blend(test::colour_block(colours), state, target.tile(0));
      // Added to the smallest zero, a half stays what it is when it is read and written once more.
      for (Rgba32F& c : colours) c = {-0.0f, 0, -0.0f, 0};
      state.blend.mode = BlendMode::additive;
      block_kernels(set, precision).blend(test::colour_block(colours), state, target.tile(0));
      const auto pixels = test::in_block_order(target.linear_image());
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        const float expected = float_from_half(half_from_float(values[first + i]));
        for (const float stored : {pixels[i].r, pixels[i].b})
          if (std::bit_cast<std::uint32_t>(stored) != std::bit_cast<std::uint32_t>(expected)) FAIL("seed 331, value " << std::hexfloat << values[first + i]);
        CHECK((pixels[i].g == 0 && pixels[i].a == 1));
      }
    }
  });
}

}  // namespace tuberia
