#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <vector>

#include "reference/ray_tracer/sampling.hpp"

using namespace tuberia;
using namespace tuberia::tracer;
using description::Sampling;

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

std::vector<double> sampled_row(const Sampling& sampling, int width, const std::function<double(double x)>& grey) {
  Workers one(1);
  const Image<Rgba32F> picture = sample_picture([&](const glm::dvec2& at, int) { return glm::dvec3(grey(at.x)); }, width, 1, sampling, one).light;
  std::vector<double> row;
  for (const Rgba32F& pixel : picture.pixels()) row.push_back(pixel.r);
  return row;
}

double root_mean_square(const std::vector<double>& values, const std::vector<double>& wanted) {
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += (values[i] - wanted[i]) * (values[i] - wanted[i]);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Rings that get finer outwards, 0..1: 1 / 50 cycles a pixel more with every pixel.
double zone_plate(double x) { return 0.5 + 0.5 * std::cos(kTurn * x * x / 100); }

}  // namespace

TEST_CASE("sampling: stripes above the Nyquist frequency look like wider ones", "[ray_tracer][sampling][B68]") {
  // .9 stripes a pixel, sampled at i + 1/2: cos(2 pi .9 (i + 1/2)) = -cos(2 pi .1 (i + 1/2)). Nothing can tell them apart.
  const auto stripes = [](double frequency) { return [=](double x) { return 0.5 + 0.5 * std::cos(kTurn * frequency * x); }; };
  const std::vector<double> fine = sampled_row({}, 100, stripes(0.9)), wide = sampled_row({}, 100, stripes(0.1));
  for (std::size_t i = 0; i < fine.size(); ++i) CHECK(fine[i] == Approx(1 - wide[i]).margin(1e-6));

  // k samples a pixel move the limit to k / 2. Their mean is sin(pi f) / (k sin(pi f / k)) times the stripes, nearly what the pixel holds.
  for (const int k : {2, 3, 4}) {
    const std::vector<double> row = sampled_row({.per_pixel = k * k}, 100, stripes(0.9));
    const double left = std::sin(std::numbers::pi * 0.9) / (k * std::sin(std::numbers::pi * 0.9 / k));
    for (std::size_t i = 0; i < row.size(); ++i)
      CHECK(row[i] == Approx(0.5 + 0.5 * left * std::cos(kTurn * 0.9 * (static_cast<double>(i) + 0.5))).margin(1e-6));
  }
}

TEST_CASE("sampling: a zone plate has false rings, and fewer with more samples", "[ray_tracer][sampling][B68][C45]") {
  // One period more a pixel at x = 50: there a single sample draws the rings of the centre once more, at full contrast.
  const std::vector<double> one = sampled_row({}, 58, zone_plate);
  CHECK(*std::max_element(one.begin() + 42, one.begin() + 58) - *std::min_element(one.begin() + 42, one.begin() + 58) > 0.9);

  std::vector<double> wanted;
  for (int x = 0; x < 58; ++x) {
    double sum = 0;
    for (int part = 0; part < 1000; ++part) sum += zone_plate(x + (part + 0.5) / 1000) / 1000;
    wanted.push_back(sum);
  }
  double last = root_mean_square(one, wanted);
  for (const int per_pixel : {4, 9, 16}) {
    const double error = root_mean_square(sampled_row({.per_pixel = per_pixel}, 58, zone_plate), wanted);
    CHECK(error < 0.6 * last);
    last = error;
  }

  // Jittered samples err, too, but at random: where the uniform one repeats the centre's rings, errors of neighbours have
  // nothing to do with them.
  const auto likeness = [&](const std::vector<double>& row) {
    double product = 0, own = 0, other = 0;
    for (std::size_t i = 0; i < 6; ++i)
      for (const int side : {-1, 1}) {
        const double centre = zone_plate(static_cast<double>(i) + 0.5) - 0.5, here = row[static_cast<std::size_t>(50 + side * static_cast<int>(i) - (side < 0))] - 0.5;
        product += centre * here;
        own += centre * centre;
        other += here * here;
      }
    return product / std::sqrt(own * other);
  };
  CHECK(std::abs(likeness(one)) > 0.99);
  double mean = 0;
  for (std::uint32_t seed = 1; seed <= 64; ++seed) mean += likeness(sampled_row({.pattern = Sampling::Pattern::jittered, .seed = seed}, 58, zone_plate)) / 64;
  CHECK(std::abs(mean) < 0.2);
}

TEST_CASE("sampling: figure 47, the box filter counts how many of nine samples are covered", "[ray_tracer][sampling][B72]") {
  // A white polygon's edge across 3 x 2 pixels: below 3 y = 2 + 2 x. Samples lie at sixths, so that counting needs whole numbers only.
  Workers one(1);
  const auto light = [](const glm::dvec2& at, int) { return glm::dvec3(3 * at.y > 2 + 2 * at.x ? 1.0 : 0.0); };
  const Image<Rgba32F> picture = sample_picture(light, 3, 2, {.per_pixel = 9}, one).light;
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x) {
      int covered = 0;
      for (int sample = 0; sample < 9; ++sample) covered += 3 * (6 * y + 2 * (sample / 3) + 1) > 12 + 2 * (6 * x + 2 * (sample % 3) + 1);
      CHECK(picture.at(x, y).r == static_cast<float>(covered / 9.0));
    }
}

TEST_CASE("sampling: every way of taking several samples beats one, along edges", "[ray_tracer][sampling][C45][B69][B70][B73]") {
  // A half plane; the true coverage by so many samples that it errs by less than 1e-3.
  const auto light = [](const glm::dvec2& at, int) { return glm::dvec3(at.y > 3.3 + 0.37 * at.x ? 1.0 : 0.1); };
  Workers one(1);
  const auto picture_of = [&](const Sampling& sampling) { return sample_picture(light, 24, 18, sampling, one); };
  const Image<Rgba32F> truth = picture_of({.per_pixel = 1024}).light;
  const auto error_of = [&](const Image<Rgba32F>& picture) {
    double sum = 0;
    for (int y = 0; y < 18; ++y)
      for (int x = 0; x < 24; ++x) sum += std::pow(picture.at(x, y).r - truth.at(x, y).r, 2);
    return std::sqrt(sum / (24 * 18));
  };
  const double single = error_of(picture_of({}).light);
  const SampledPicture uniform = picture_of({.per_pixel = 16}), adaptive = picture_of({.per_pixel = 16, .adaptive = true});
  CHECK(error_of(uniform.light) < single / 4);
  CHECK(error_of(adaptive.light) < single / 4);
  CHECK(error_of(picture_of({.pattern = Sampling::Pattern::jittered, .per_pixel = 16}).light) < single / 4);
  CHECK(uniform.questions == 24 * 18 * 16);
  CHECK(adaptive.questions < uniform.questions / 5);
}

TEST_CASE("sampling: the same bits for any number of workers", "[ray_tracer][sampling][B70][B71][B73]") {
  const auto light = [](const glm::dvec2& at, int) {
    const glm::dvec2 from_centre = at - glm::dvec2(40, 30);
    return 0.5 + 0.5 * glm::cos(0.05 * glm::dot(from_centre, from_centre) * glm::dvec3(1, 1.1, 0.9));
  };
  for (const bool adaptive : {false, true})
    for (const Sampling::Pattern pattern : {Sampling::Pattern::uniform, Sampling::Pattern::jittered}) {
      const Sampling sampling{.pattern = pattern, .per_pixel = 9, .adaptive = adaptive, .filter = Sampling::Filter::gaussian, .filter_radius = 1.5};
      Workers one(1), three(3), eight(8);
      const SampledPicture alone = sample_picture(light, 97, 65, sampling, one);
      for (Workers* many : {&three, &eight}) {
        const SampledPicture shared = sample_picture(light, 97, 65, sampling, *many);
        CHECK(shared.light == alone.light);
        CHECK(shared.questions == alone.questions);
      }
    }
}

TEST_CASE("sampling: a picture made in bands is the one made at once", "[ray_tracer][sampling][B71]") {
  // So wide that a band is two rows high; where its columns repeat, it must equal a narrow picture, but for the borders.
  constexpr int kPeriod = 8, kWide = 4096, kHeight = 5;
  const Sampling sampling{.per_pixel = 256, .filter = Sampling::Filter::gaussian};
  const auto light = [](const glm::dvec2& at, int) { return glm::dvec3(0.5 + 0.5 * std::cos(kTurn * std::fmod(at.x, kPeriod) / kPeriod) * std::cos(at.y)); };
  Workers workers;
  const Image<Rgba32F> wide = sample_picture(light, kWide, kHeight, sampling, workers).light;
  const Image<Rgba32F> narrow = sample_picture(light, 3 * kPeriod, kHeight, sampling, workers).light;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kPeriod; ++x) {
      REQUIRE(wide.at(200 * kPeriod + x, y).r == Approx(narrow.at(kPeriod + x, y).r).margin(1e-6));
      REQUIRE(wide.at(x, y) == narrow.at(x, y));
    }
}

TEST_CASE("sampling: progress grows to 1, and time runs out", "[ray_tracer][sampling]") {
  Workers workers(3);
  std::vector<double> done, left;
  const auto progress = [&](double part, double seconds) {
    done.push_back(part);
    left.push_back(seconds);
  };
  sample_picture([](const glm::dvec2&, int) { return glm::dvec3(1); }, 100, 70, {}, workers, progress);
  REQUIRE(done.size() == 4 * 3);
  CHECK(std::is_sorted(done.begin(), done.end()));
  CHECK(done.back() == Approx(1));
  CHECK(left.back() == Approx(0).margin(1e-9));
  for (const double seconds : left) CHECK((std::isfinite(seconds) && seconds >= -1e-9));
}
