#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/raster/simd_kernels.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"

// Every bound here is the one that the function's own comment states.

namespace tuberia {
namespace {

using test::for_every_machine;
using test::simd_kernels;

constexpr float kEndless = std::numeric_limits<float>::infinity(), kNoNumber = std::numeric_limits<float>::quiet_NaN();
constexpr double kPi = std::numbers::pi;

struct SinesAndCosines {
  std::vector<float> sine, cosine;
};

using Angular = void (*test::SimdKernels::*)(const float*, int, float*, float*);

SinesAndCosines angular(Angular function, std::vector<float> a, InstructionSet set, Precision precision) {
  const std::size_t count = a.size();
  a.resize((count + 15) / 16 * 16, 1.0f);
  SinesAndCosines out{std::vector<float>(a.size()), std::vector<float>(a.size())};
  (simd_kernels(set, precision).*function)(a.data(), static_cast<int>(a.size()), out.sine.data(), out.cosine.data());
  out.sine.resize(count);
  out.cosine.resize(count);
  return out;
}

std::vector<float> atan2_of(std::vector<float> y, std::vector<float> x, InstructionSet set, Precision precision) {
  const std::size_t count = y.size();
  y.resize((count + 15) / 16 * 16, 1.0f);
  x.resize(y.size(), 1.0f);
  std::vector<float> out(y.size());
  simd_kernels(set, precision).atan2(y.data(), x.data(), static_cast<int>(y.size()), out.data());
  out.resize(count);
  return out;
}

std::vector<float> acos_of(std::vector<float> a, InstructionSet set, Precision precision) {
  const std::size_t count = a.size();
  a.resize((count + 15) / 16 * 16, 1.0f);
  std::vector<float> out(a.size());
  simd_kernels(set, precision).acos(a.data(), static_cast<int>(a.size()), out.data());
  out.resize(count);
  return out;
}

std::vector<float> between(float low, float high, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<float> values(1 << 16);
  for (float& x : values) x = random.between(low, high);
  return values;
}

/// Of both signs, evenly by the logarithm of the size.
std::vector<float> of_all_sizes(float low_exponent, float high_exponent, std::uint64_t seed) {
  test::Random random(seed);
  std::vector<float> values(1 << 16);
  for (float& x : values) x = std::exp2(random.between(low_exponent, high_exponent)) * (random.below(2) == 0 ? 1.0f : -1.0f);
  return values;
}

/// The larger error; not-a-number is the largest of all.
double worse(double most, double off) { return std::isnan(off) ? 1e9 : std::max(most, off); }

/// The angles next to the multiples of pi/2, where a sine or cosine is all but 0.
std::vector<float> next_to_quarters() {
  std::vector<float> values;
  for (int quarter = -5215; quarter <= 5215; ++quarter) {
    const float at = static_cast<float>(quarter * kPi / 2);
    for (const float x : {std::nextafter(at, -kEndless), at, std::nextafter(at, kEndless)}) values.push_back(x);
  }
  return values;
}

}  // namespace

TEST_CASE("precision: sine and cosine are right to 1.2e-7 up to 8192 radians", "[raster][precision]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    for (const std::vector<float>& arguments : {between(-8192, 8192, 301), between(-4, 4, 302), next_to_quarters(), of_all_sizes(-149, 0, 303)}) {
      const SinesAndCosines found = angular(&test::SimdKernels::sine_cosine, arguments, set, precision);
      double most = 0;
      for (std::size_t i = 0; i < arguments.size(); ++i) {
        const double a = static_cast<double>(arguments[i]);
        most = worse(most, std::abs(static_cast<double>(found.sine[i]) - std::sin(a)));
        most = worse(most, std::abs(static_cast<double>(found.cosine[i]) - std::cos(a)));
      }
      CHECK(most <= 1.2e-7);
    }
  });
}

TEST_CASE("precision: beyond 8192 radians a sine's error grows with the angle's own", "[raster][precision]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    const std::vector<float> arguments = of_all_sizes(13, 22, 304);
    const SinesAndCosines found = angular(&test::SimdKernels::sine_cosine, arguments, set, precision);
    double most = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const double a = static_cast<double>(arguments[i]);
      most = worse(most, std::abs(static_cast<double>(found.sine[i]) - std::sin(a)) / std::abs(a));
      most = worse(most, std::abs(static_cast<double>(found.cosine[i]) - std::cos(a)) / std::abs(a));
    }
    CHECK(most <= 2.5e-7);
    const std::vector<float> huge = of_all_sizes(13, 127.9f, 305);
    const SinesAndCosines bounded = angular(&test::SimdKernels::sine_cosine, huge, set, precision);
    for (std::size_t i = 0; i < huge.size(); ++i) {
      const double sine = static_cast<double>(bounded.sine[i]), cosine = static_cast<double>(bounded.cosine[i]);
      if (!(std::abs(sine * sine + cosine * cosine - 1) <= 5e-7)) FAIL("seed 305, angle " << huge[i]);
    }
    const SinesAndCosines odd = angular(&test::SimdKernels::sine_cosine, {0, -0.0f, kEndless, -kEndless, kNoNumber}, set, precision);
    CHECK(odd.sine == std::vector<float>(5, 0));
    CHECK(odd.cosine == std::vector<float>(5, 1));
  });
}

TEST_CASE("precision: the sine of turns loses nothing to the size of its argument", "[raster][precision]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    for (const std::vector<float>& arguments : {between(-2, 2, 306), of_all_sizes(-149, 24, 307), of_all_sizes(24, 127.9f, 308)}) {
      const SinesAndCosines found = angular(&test::SimdKernels::sine_cosine_of_turns, arguments, set, precision);
      double most = 0;
      for (std::size_t i = 0; i < arguments.size(); ++i) {
        const double angle = std::remainder(static_cast<double>(arguments[i]), 1.0) * 2 * kPi;
        most = worse(most, std::abs(static_cast<double>(found.sine[i]) - std::sin(angle)));
        most = worse(most, std::abs(static_cast<double>(found.cosine[i]) - std::cos(angle)));
      }
      CHECK(most <= 1.2e-7);
    }
    const SinesAndCosines quarters = angular(&test::SimdKernels::sine_cosine_of_turns, {0, 0.25f, 0.5f, 0.75f, 1, -0.25f, -0.5f, 8388609, kEndless, kNoNumber}, set, precision);
    CHECK(quarters.sine == std::vector<float>{0, 1, 0, -1, 0, -1, 0, 0, 0, 0});
    CHECK(quarters.cosine == std::vector<float>{1, 0, -1, 0, 1, 0, -1, 1, 1, 1});
  });
}

TEST_CASE("precision: arc cosine is right to 4e-7, next to 1, too", "[raster][precision]") {
  std::vector<float> arguments = between(-1, 1, 309);
  float up = 1, down = -1, half = 0.5f;
  for (int ulps = 0; ulps < 3000; ++ulps) {
    for (const float x : {up, down, half, -half}) arguments.push_back(x);
    up = std::nextafter(up, 0.0f), down = std::nextafter(down, 0.0f);
    half = std::nextafter(half, ulps < 1500 ? 0.0f : 1.0f);
  }
  for_every_machine([&](InstructionSet set, Precision precision) {
    const std::vector<float> found = acos_of(arguments, set, precision);
    double most = 0, most_relative = 0;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const double right = std::acos(static_cast<double>(arguments[i])), off = std::abs(static_cast<double>(found[i]) - right);
      most = worse(most, off);
      most_relative = worse(most_relative, off == 0 ? 0 : off / right);
    }
    CHECK(most <= 4e-7);
    CHECK(most_relative <= 4e-7);
    const float pi = static_cast<float>(kPi);
    CHECK(acos_of({1, 0, -0.0f, -1, 2, kEndless, -2, -kEndless, kNoNumber}, set, precision) ==
          std::vector<float>{0, pi / 2, pi / 2, pi, 0, 0, pi, pi, pi});
  });
}

TEST_CASE("precision: the angle of a direction is right to 4e-7 whatever its length", "[raster][precision]") {
  const std::vector<float> all = of_all_sizes(-126, 127.9f, 310), others = of_all_sizes(-126, 127.9f, 311);
  const std::vector<float> usual = between(-1, 1, 312), usual_others = between(-1, 1, 313);
  for_every_machine([&](InstructionSet set, Precision precision) {
    for (const auto& [ys, xs] : {std::pair{&all, &others}, {&usual, &usual_others}, {&all, &all}}) {
      const std::vector<float> found = atan2_of(*ys, *xs, set, precision);
      double most = 0, most_relative = 0;
      for (std::size_t i = 0; i < ys->size(); ++i) {
        const double right = std::atan2(static_cast<double>((*ys)[i]), static_cast<double>((*xs)[i])), off = std::abs(static_cast<double>(found[i]) - right);
        most = worse(most, off);
        if (std::abs(right) >= 1.2e-38) most_relative = worse(most_relative, off / std::abs(right));
      }
      CHECK(most <= 4e-7);
      CHECK(most_relative <= 4e-7);
    }
  });
}

TEST_CASE("precision: every pair of floats has an angle", "[raster][precision]") {
  const float pi = static_cast<float>(kPi), tiny = 1e-45f, large = std::numeric_limits<float>::max();
  const std::vector<std::array<float, 3>> cases{
      {0, 0, 0}, {-0.0f, 0, 0}, {0, -0.0f, 0}, {0, 1, 0}, {0, -1, pi}, {-0.0f, -1, pi}, {1, 0, pi / 2}, {-1, 0, -pi / 2},
      {1, 1, pi / 4}, {-1, 1, -pi / 4}, {1, -1, 3 * pi / 4}, {-1, -1, -3 * pi / 4}, {tiny, tiny, pi / 4}, {tiny, 0, pi / 2},
      {large, large, pi / 4}, {kEndless, kEndless, pi / 4}, {kEndless, -kEndless, 3 * pi / 4}, {-kEndless, 1, -pi / 2},
      {1, -kEndless, pi}, {kNoNumber, kNoNumber, 0}, {kNoNumber, -1, pi}, {1, kNoNumber, pi / 2}};
  std::vector<float> y, x;
  for (const auto& c : cases) y.push_back(c[0]), x.push_back(c[1]);
  for_every_machine([&](InstructionSet set, Precision precision) {
    const std::vector<float> found = atan2_of(y, x, set, precision);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      INFO("atan2(" << y[i] << ", " << x[i] << ")");
      CHECK(found[i] == Approx(cases[i][2]).epsilon(2e-7).margin(1e-38));
    }
  });
}

TEST_CASE("precision: exact angles have the same bits on every instruction set", "[raster][exact]") {
  const std::vector<float> arguments = of_all_sizes(-30, 30, 314), others = of_all_sizes(-30, 30, 315);
  const SinesAndCosines first = angular(&test::SimdKernels::sine_cosine, arguments, supported_instruction_sets().front(), Precision::exact);
  const std::vector<float> first_angles = atan2_of(arguments, others, supported_instruction_sets().front(), Precision::exact);
  const std::vector<float> first_arcs = acos_of(first.sine, supported_instruction_sets().front(), Precision::exact);
  test::for_every_instruction_set([&](InstructionSet set) {
    const SinesAndCosines found = angular(&test::SimdKernels::sine_cosine, arguments, set, Precision::exact);
    CHECK((found.sine == first.sine && found.cosine == first.cosine));
    CHECK(atan2_of(arguments, others, set, Precision::exact) == first_angles);
    CHECK(acos_of(first.sine, set, Precision::exact) == first_arcs);
  });
}

}  // namespace tuberia
