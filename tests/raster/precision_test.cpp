#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "tests/raster/simd_kernels.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/random.hpp"

// Every bound here is the one that the function's own comment states.

namespace tuberia {

using test::for_every_machine;
using test::simd_kernels;
using test::SimdKernels;

namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity(), kNotANumber = std::numeric_limits<float>::quiet_NaN();
constexpr int kSamples = 1 << 16;

using Unary = void (*SimdKernels::*)(const float*, int, float*);

std::vector<float> results(Unary function, std::vector<float> a, InstructionSet set, Precision precision) {
  const std::size_t count = a.size();
  a.resize((count + 15) / 16 * 16, 1.0f);
  std::vector<float> out(a.size());
  (simd_kernels(set, precision).*function)(a.data(), static_cast<int>(a.size()), out.data());
  out.resize(count);
  return out;
}

double relative_error(float found, double right) {
  const double difference = std::abs(static_cast<double>(found) - right);
  return difference == 0 ? 0 : difference / std::abs(right);
}

/// The largest relative error over random arguments.
double worst(Unary function, const std::vector<float>& arguments, double (*right)(double), InstructionSet set, Precision precision) {
  const std::vector<float> found = results(function, arguments, set, precision);
  double most = 0;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const double error = relative_error(found[i], right(static_cast<double>(arguments[i])));
    most = std::max(most, std::isnan(error) ? 1e9 : error);
  }
  return most;
}

/// Positive floats between two powers of two, evenly by their logarithm.
std::vector<float> logarithmic(float low_exponent, float high_exponent) {
  test::Random random(91);
  std::vector<float> values(kSamples);
  for (float& x : values) x = static_cast<float>(std::exp2(static_cast<double>(random.between(low_exponent, high_exponent))));
  return values;
}

std::vector<float> linear(float low, float high) {
  test::Random random(92);
  std::vector<float> values(kSamples);
  for (float& x : values) x = random.between(low, high);
  return values;
}

}  // namespace

TEST_CASE("precision: log2 is right to 3e-7, next to 1, too, the fast one to 4e-7", "[raster][precision]") {
  std::vector<float> near_one = linear(0.7f, 1.4142f);
  for (int ulps = -2000; ulps <= 2000; ++ulps) near_one.push_back(std::bit_cast<float>(0x3f800000 + ulps));
  for_every_machine([&](InstructionSet set, Precision precision) {
    const double allowed = precision == Precision::exact ? 3e-7 : 4e-7;
    for (const std::vector<float>& arguments : {logarithmic(-126, 127.99f), near_one})
      CHECK(worst(&SimdKernels::log2, arguments, [](double x) { return std::log2(x); }, set, precision) <= allowed);
    const auto odd = results(&SimdKernels::log2, {1, 2, 1024, 0, -1, kNotANumber, 1e-45f}, set, precision);
    CHECK(odd == std::vector<float>{0, 1, 10, -126, -126, -126, -126});
  });
}

TEST_CASE("precision: exp2 is right to 2e-7 and stays finite", "[raster][precision]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    CHECK(worst(&SimdKernels::exp2, linear(-126, 127), [](double x) { return std::exp2(x); }, set, precision) <= 2e-7);
    CHECK(worst(&SimdKernels::exp2, linear(-1, 1), [](double x) { return std::exp2(x); }, set, precision) <= 2e-7);
    CHECK(results(&SimdKernels::exp2, {0, 1, -1, 100, -126, -126.5f, -1e30f, -kInfinite, kNotANumber}, set, precision) ==
          std::vector<float>{1, 2, 0.5f, 0x1p100f, 0x1p-126f, 0, 0, 0, 0});
    for (const float x : results(&SimdKernels::exp2, {127.3f, 127.5f, 127.7f, 128, 1e30f, kInfinite}, set, precision)) {
      CHECK(std::isfinite(x));
      CHECK(x >= 0x1p127f);
    }
  });
}

// rules S2
TEST_CASE("precision: pow is right to 3e-7 times one plus the logarithm of its result", "[raster][precision][case-50]") {
  test::Random random(93);
  std::vector<float> base(kSamples), exponent(kSamples), found(kSamples);
  for (std::size_t i = 0; i < kSamples; ++i) {
    base[i] = i % 2 == 0 ? random.between(0.001f, 1) : static_cast<float>(std::exp2(static_cast<double>(random.between(-20, 20))));
    // Results between 2^-126 and 2^127.
    const float most = 125.0f / std::max(0.01f, std::abs(std::log2(base[i])));
    exponent[i] = random.between(-std::min(most, 1000.0f), std::min(most, 1000.0f));
  }
  for_every_machine([&](InstructionSet set, Precision precision) {
    simd_kernels(set, precision).pow(base.data(), exponent.data(), kSamples, found.data());
    double most = 0;
    for (std::size_t i = 0; i < kSamples; ++i) {
      const double b = static_cast<double>(base[i]), e = static_cast<double>(exponent[i]);
      most = std::max(most, relative_error(found[i], std::pow(b, e)) / (1 + std::abs(e * std::log2(b))));
    }
    CHECK(most <= 3e-7);

    const std::vector<float> bases{0, 0, -1, 1, 0.9990234375f, 0, 0.999f, 2, 1, 5, 1, 1, 1, 1, 1, 1};
    const std::vector<float> exponents{0, 5, 3, 1e9f, 16384, 1e-30f, 1e5f, 10, -7, 0, 1, 1, 1, 1, 1, 1};
    std::vector<float> out(16);
    simd_kernels(set, precision).pow(bases.data(), exponents.data(), 16, out.data());
    CHECK((out[0] == 1 && out[1] == 0 && out[2] == 0 && out[3] == 1 && out[5] == 0 && out[8] == 1 && out[9] == 1));
    CHECK(out[4] == Approx(1.11658850697683e-7).epsilon(1e-4));
    CHECK(out[6] <= 1e-43f);
    CHECK(out[7] == Approx(1024).epsilon(1e-5));
  });
}

TEST_CASE("precision: the fast reciprocal is right to 3e-7, the exact one to half a unit", "[raster][precision]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    const double allowed = precision == Precision::fast ? 3e-7 : 0x1p-24;
    for (const float sign : {1.0f, -1.0f}) {
      std::vector<float> a = logarithmic(-99.6f, 99.6f);
      for (float& x : a) x *= sign;
      CHECK(worst(&SimdKernels::reciprocal, a, [](double x) { return 1 / x; }, set, precision) <= allowed);
    }
  });
}

TEST_CASE("precision: the fast inverse square root is right to 5e-7", "[raster][precision]") {
  for_every_machine([](InstructionSet set, Precision precision) {
    // The exact one divides by a root that was rounded: one unit and a half.
    const double allowed = precision == Precision::fast ? 5e-7 : 1.5 * 0x1p-24 * 1.01;
    CHECK(worst(&SimdKernels::inverse_sqrt, logarithmic(-99.6f, 99.6f), [](double x) { return 1 / std::sqrt(x); }, set, precision) <= allowed);
  });
}

// rules S1
TEST_CASE("precision: any vector but 0 gets unit length", "[raster][precision][case-51]") {
  test::Random random(94);
  std::vector<float> v[3], out[3];
  for (int axis = 0; axis < 3; ++axis) v[axis].resize(kSamples), out[axis].resize(kSamples);
  for (std::size_t i = 0; i < kSamples; ++i) {
    const double size = std::exp2(static_cast<double>(i % 2 == 0 ? random.between(-40, 40) : random.between(-148, 127)));
    for (auto& axis : v) axis[i] = static_cast<float>(static_cast<double>(random.between(-1, 1)) * size);
  }
  const float odd[][3] = {{1e-25f, 0, 0}, {1e25f, 1e25f, 0}, {1e-40f, 0, 0}, {0, 0, 0}, {3e38f, -3e38f, 3e38f}, {0, 1e-45f, 0}, {-1e-44f, 1e-44f, 0}};
  for (std::size_t i = 0; i < std::size(odd); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) v[axis][i] = odd[i][axis];

  for_every_machine([&](InstructionSet set, Precision precision) {
    simd_kernels(set, precision).normalize(v[0].data(), v[1].data(), v[2].data(), kSamples, out[0].data(), out[1].data(), out[2].data());
    const double allowed = precision == Precision::exact ? 2 * 0x1p-23 : 6e-7;
    double most = 0;
    for (std::size_t i = 0; i < kSamples; ++i) {
      const double x = static_cast<double>(out[0][i]), y = static_cast<double>(out[1][i]), z = static_cast<double>(out[2][i]);
      const double off = std::abs(std::sqrt(x * x + y * y + z * z) - 1);
      const bool zero = v[0][i] == 0 && v[1][i] == 0 && v[2][i] == 0;
      if (zero) CHECK((x == 0 && y == 0 && z == 0));
      else if (!(off <= allowed)) FAIL("seed 94, (" << v[0][i] << ", " << v[1][i] << ", " << v[2][i] << ") has length 1 + " << off);
      most = std::max(most, zero ? 0 : off);
    }
    CHECK(most <= allowed);
    CHECK(out[1][1] == Approx(0.70710678).epsilon(1e-6));
  });
}

}  // namespace tuberia
