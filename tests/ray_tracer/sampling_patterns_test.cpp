#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <vector>

#include "reference/ray_tracer/sampling.hpp"

using namespace tuberia;
using namespace tuberia::tracer;
using description::Sampling;

namespace {

/// What is written is float; the light is grey and 0..1.
Image<Rgba32F> sampled(const Sampling& sampling, int width, int height, const std::function<double(double x, double y)>& grey) {
  Workers one(1);
  return sample_picture([&](const glm::dvec2& at, int) { return glm::dvec3(grey(at.x, at.y)); }, width, height, sampling, one).light;
}

}  // namespace

TEST_CASE("sampling: uniform samples are the centres of k x k equal parts", "[ray_tracer][sampling][B69]") {
  for (const int k : {1, 2, 3, 4}) {
    const SamplePattern pattern(Sampling{.per_pixel = k * k});
    REQUIRE(pattern.cells() == k);
    for (int j = 0; j < k; ++j)
      for (int i = 0; i < k; ++i) {
        const glm::dvec2 wanted(7 + (i + 0.5) / k, 3 + (j + 0.5) / k);
        CHECK(glm::length(pattern.position({7 * k + i, 3 * k + j}) - wanted) < 1e-14);
      }
  }
}

TEST_CASE("sampling: a pixel is the mean of its samples", "[ray_tracer][sampling][B69]") {
  const auto light = [](double x, double y) { return 0.5 + 0.3 * std::sin(3 * x) * std::cos(2 * y + x); };
  for (const int k : {1, 2, 3, 4}) {
    const Image<Rgba32F> picture = sampled({.per_pixel = k * k}, 5, 4, light);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 5; ++x) {
        double sum = 0;
        for (int part = 0; part < k * k; ++part) sum += light(x + (part % k + 0.5) / k, y + (part / k + 0.5) / k);
        CHECK(picture.at(x, y).r == Approx(sum / (k * k)).margin(1e-7));
      }
  }
}

TEST_CASE("sampling: jittered samples lie anywhere in their cells, and nowhere else", "[ray_tracer][sampling][B70]") {
  const Sampling sampling{.pattern = Sampling::Pattern::jittered, .per_pixel = 16};
  const SamplePattern pattern(sampling), same(sampling), other(Sampling{.pattern = Sampling::Pattern::jittered, .per_pixel = 16, .seed = 2});
  constexpr int kSide = 400;
  glm::dvec2 sum(0), squares(0), neighbours(0);
  double across = 0;
  int moved = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const glm::dvec2 at = pattern.position({x, y}), within = at * 4.0 - glm::dvec2(x, y);
      REQUIRE((within.x >= 0 && within.x < 1 && within.y >= 0 && within.y < 1));
      REQUIRE(same.position({x, y}) == at);
      moved += other.position({x, y}) != at;
      const glm::dvec2 next = pattern.position({x + 1, y}) * 4.0 - glm::dvec2(x + 1, y);
      sum += within;
      squares += (within - 0.5) * (within - 0.5);
      neighbours += (within - 0.5) * (next - 0.5);
      across += (within.x - 0.5) * (within.y - 0.5);
    }
  // As even as independent numbers of [0, 1) are: mean 1/2, variance 1/12, no correlation, to five standard errors.
  constexpr double kCount = kSide * kSide, kOfMean = 5 * 0.2887 / kSide, kOfProduct = 5 / 12.0 / kSide;
  CHECK(moved == kCount);
  for (int axis = 0; axis < 2; ++axis) {
    CHECK(std::abs(sum[axis] / kCount - 0.5) < kOfMean);
    CHECK(std::abs(squares[axis] / kCount - 1 / 12.0) < kOfProduct);
    CHECK(std::abs(neighbours[axis] / kCount) < kOfProduct);
  }
  CHECK(std::abs(across / kCount) < kOfProduct);
}

TEST_CASE("sampling: what is even stays as it is, to 1e-12", "[ray_tracer][sampling][B71]") {
  // Pictures are floats. A light just above, or just below, the middle of two floats must become the upper, or the lower one,
  // and does not if the filter's weights are off by more than the distance.
  for (const float lower : {0.5f, 0.7310585f, 0.9999f}) {
    const float upper = std::nextafter(lower, 2.0f);
    const double middle = 0.5 * lower + 0.5 * upper;
    for (const Sampling::Filter filter : {Sampling::Filter::box, Sampling::Filter::gaussian})
      for (const Sampling::Pattern pattern : {Sampling::Pattern::uniform, Sampling::Pattern::jittered})
        for (const bool adaptive : {false, true})
          for (const double radius : {0.05, 1.0, 2.7}) {
            const Sampling sampling{.pattern = pattern, .per_pixel = 9, .adaptive = adaptive, .filter = filter, .filter_radius = radius};
            const Image<Rgba32F> above = sampled(sampling, 6, 5, [&](double, double) { return middle + 1e-12; });
            const Image<Rgba32F> below = sampled(sampling, 6, 5, [&](double, double) { return middle - 1e-12; });
            for (const Rgba32F& pixel : above.pixels()) REQUIRE(pixel.g == upper);
            for (const Rgba32F& pixel : below.pixels()) REQUIRE(pixel.g == lower);
          }
  }
}

TEST_CASE("sampling: the weights of a filter sum to 1", "[ray_tracer][sampling][B71]") {
  // The response of one pixel to one bright cell is that cell's weight.
  const bool gaussian = GENERATE(false, true);
  const Sampling sampling{.per_pixel = 9, .filter = gaussian ? Sampling::Filter::gaussian : Sampling::Filter::box, .filter_radius = 1.2};
  const auto weight_of = [&](int cell_x, int cell_y, int pixel) {
    const auto light = [&](double x, double y) { return std::floor(x * 3) == cell_x && std::floor(y * 3) == cell_y ? 1.0 : 0.0; };
    return static_cast<double>(sampled(sampling, 7, 7, light).at(pixel, pixel).r);
  };
  double sum = 0;
  for (int y = 3; y < 18; ++y)
    for (int x = 3; x < 18; ++x) sum += weight_of(x, y, 3);
  CHECK(sum == Approx(1).margin(1e-6));

  // The box takes its own nine, alike; the Gaussian falls off with the distance, exp(-d^2 / (2 s^2)), s a third of the radius.
  const double centre = weight_of(10, 10, 3), beside = weight_of(11, 10, 3), beyond = weight_of(12, 10, 3), outside = weight_of(14, 10, 3);
  if (!gaussian) {
    CHECK(centre == Approx(1 / 9.0));
    CHECK(beside == centre);
    CHECK(beyond == 0);
    return;
  }
  CHECK(beside / centre == Approx(std::exp(-(1 / 9.0) / (2 * 0.16))));
  CHECK(beyond / centre == Approx(std::exp(-(4 / 9.0) / (2 * 0.16))));
  CHECK(outside == 0);
  CHECK(weight_of(9, 10, 3) == beside);
  CHECK(weight_of(10, 9, 3) == beside);
}

TEST_CASE("sampling: a narrow filter still finds a sample", "[ray_tracer][sampling][B71]") {
  for (const int per_pixel : {1, 4, 9, 16})
    for (const Sampling::Pattern pattern : {Sampling::Pattern::uniform, Sampling::Pattern::jittered})
      for (const double radius : {1e-9, 0.0, -1.0, std::nan("")}) {
        const Sampling sampling{.pattern = pattern, .per_pixel = per_pixel, .filter = Sampling::Filter::gaussian, .filter_radius = radius};
        const Image<Rgba32F> picture = sampled(sampling, 20, 20, [](double x, double) { return x; });
        for (const Rgba32F& pixel : picture.pixels()) REQUIRE(std::isfinite(pixel.r));
      }
}

TEST_CASE("sampling: numbers out of range are brought into it", "[ray_tracer][sampling]") {
  CHECK(SamplePattern(Sampling{.per_pixel = 0}).cells() == 1);
  CHECK(SamplePattern(Sampling{.per_pixel = -9}).cells() == 1);
  CHECK(SamplePattern(Sampling{.per_pixel = 1 << 30}).cells() == 32);
  CHECK(PixelFilter(Sampling{.filter = Sampling::Filter::gaussian, .filter_radius = 1e9}).margin() == 8);
  CHECK(sampled({}, 0, 5, [](double, double) { return 1.0; }).empty());
  CHECK(sampled({}, 5, -1, [](double, double) { return 1.0; }).empty());
}
