#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <set>
#include <utility>

#include "reference/ray_tracer/sampling.hpp"

using namespace tuberia;
using namespace tuberia::tracer;
using description::Sampling;

namespace {

constexpr Sampling kTwoDivisions{.per_pixel = 16, .adaptive = true};

struct Asked {
  Image<Rgba32F> light;
  std::int64_t questions = 0;
  std::set<std::pair<double, double>> points;
};

Asked asked(const Sampling& sampling, int width, int height, const std::function<glm::dvec3(double x, double y)>& light) {
  Asked result;
  Workers one(1);
  const auto remember = [&](const glm::dvec2& at, int) {
    result.points.emplace(at.x, at.y);
    return light(at.x, at.y);
  };
  SampledPicture picture = sample_picture(remember, width, height, sampling, one);
  result.light = std::move(picture.light);
  result.questions = picture.questions;
  return result;
}

/// Figure 48's kind of picture: an edge across 3 x 2 pixels, grey above and white below.
glm::dvec3 edge_of_figure_48(double x, double y) { return y < (1 + x) / 2 + 1 / 64.0 ? glm::dvec3(0.25) : glm::dvec3(1); }

}  // namespace

TEST_CASE("adaptive sampling: contrast of corners", "[ray_tracer][sampling][B73]") {
  const auto contrast = [](const glm::dvec3& a, const glm::dvec3& b) { return contrast_of(std::array{a, b, a, a}); };
  const glm::dvec3 third = contrast(glm::dvec3(1), glm::dvec3(0.5));
  CHECK(third.r == Approx(0.33333).margin(1e-4));
  const Sampling limits;
  CHECK((third.r > limits.contrast.r && third.g > limits.contrast.g && third.b <= limits.contrast.b));  // splits for red and green only
  CHECK(contrast(glm::dvec3(0), glm::dvec3(0)) == glm::dvec3(0));
  CHECK(contrast({1, 0, 0.2}, {0, 0, 0.2}) == glm::dvec3(1, 0, 0));
}

TEST_CASE("adaptive sampling: each channel has its own limit", "[ray_tracer][sampling][B73]") {
  // A contrast of .22 is too much for green alone, of .35 for red, too, and .45 for all.
  for (int channel = 0; channel < 3; ++channel)
    for (const double contrast : {0.15, 0.22, 0.35, 0.45}) {
      const auto light = [&](double x, double) {
        glm::dvec3 colour(1);
        if (x > 1.5) colour[channel] = (1 - contrast) / (1 + contrast);
        return colour;
      };
      const bool splits = asked(kTwoDivisions, 3, 2, light).questions > 4 * 3;
      CHECK(splits == (contrast > std::array{0.25, 0.20, 0.40}[static_cast<std::size_t>(channel)]));
    }
}

TEST_CASE("adaptive sampling: 117 rays for all of figure 48's grid, 62 along an edge", "[ray_tracer][sampling][B73][C45]") {
  Sampling everything = kTwoDivisions;
  everything.contrast = glm::dvec3(-1);
  const Asked full = asked(everything, 3, 2, edge_of_figure_48), adaptive = asked(kTwoDivisions, 3, 2, edge_of_figure_48);
  CHECK(full.questions == 13 * 9);
  CHECK(adaptive.questions == 62);
  CHECK(adaptive.light == full.light);  // nothing was lost
  CHECK(asked(kTwoDivisions, 3, 2, [](double, double) { return glm::dvec3(0.4); }).questions == 4 * 3);

  // No corner is asked for twice, whichever edge it is.
  for (int slope = -16; slope <= 16; ++slope)
    for (int height = 0; height <= 16; ++height) {
      const auto edge = [&](double x, double y) { return glm::dvec3(y < height / 8.0 + slope / 8.0 * x ? 0.0 : 1.0); };
      const Asked some = asked(kTwoDivisions, 3, 2, edge);
      REQUIRE(some.questions <= 117);
      REQUIRE(some.questions == static_cast<std::int64_t>(some.points.size()));
    }
}

namespace {

/// The notes' recursion word by word [B 5.8.2]: the colour of an area.
glm::dvec3 colour_by_the_notes(const std::function<glm::dvec3(double, double)>& light, const glm::dvec3& limits, double x, double y, double size, int level) {
  const std::array corners{light(x, y), light(x + size, y), light(x, y + size), light(x + size, y + size)};
  bool splits = false;
  for (int c = 0; c < 3; ++c) {
    const auto [least, most] = std::minmax({corners[0][c], corners[1][c], corners[2][c], corners[3][c]});
    splits = splits || (most + least > 0 && (most - least) / (most + least) > limits[c]);
  }
  if (!splits || level == 0) return 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  const double half = size / 2;
  glm::dvec3 sum(0);
  for (const glm::dvec2 at : {glm::dvec2(0, 0), glm::dvec2(half, 0), glm::dvec2(0, half), glm::dvec2(half, half)})
    sum += 0.25 * colour_by_the_notes(light, limits, x + at.x, y + at.y, half, level - 1);
  return sum;
}

}  // namespace

TEST_CASE("adaptive sampling: pixels are what the notes' recursion gives", "[ray_tracer][sampling][B73]") {
  const auto light = [](double x, double y) {
    const double wave = 0.5 + 0.5 * std::sin(0.3 * x * x + 0.2 * y);
    return x * 0.7 + y < 21 ? glm::dvec3(wave, 0.3, 0.8) : glm::dvec3(0.2, wave, 0.1 * y);
  };
  for (const auto& [per_pixel, divisions] : {std::pair(1, 0), std::pair(4, 1), std::pair(9, 2), std::pair(16, 2), std::pair(64, 3)}) {
    // Larger than a tile, so that corners on borders are among them.
    const Asked picture = asked({.per_pixel = per_pixel, .adaptive = true}, 40, 35, light);
    for (int y = 0; y < 35; ++y)
      for (int x = 0; x < 40; ++x) {
        const glm::dvec3 wanted = colour_by_the_notes(light, Sampling{}.contrast, x, y, 1, divisions);
        const Rgba32F& pixel = picture.light.at(x, y);
        REQUIRE(glm::all(glm::lessThan(glm::abs(glm::dvec3(pixel.r, pixel.g, pixel.b) - wanted), glm::dvec3(1e-6))));
      }
  }
}

TEST_CASE("adaptive sampling: jittered, a pixel with contrast takes all of its samples", "[ray_tracer][sampling][B73][B70]") {
  const Sampling sampling{.pattern = Sampling::Pattern::jittered, .per_pixel = 16, .adaptive = true};
  const auto light = [](double x, double) { return glm::dvec3(x < 1.3 ? 0.1 : 0.9); };
  const Asked picture = asked(sampling, 4, 1, light);
  CHECK(picture.questions == 5 * 2 + 16);
  CHECK(picture.light.at(0, 0).r == Approx(0.1));
  CHECK(picture.light.at(2, 0).r == Approx(0.9));
  const SamplePattern pattern(sampling);
  double sum = 0;
  for (int cell = 0; cell < 16; ++cell) sum += light(pattern.position({4 + cell % 4, cell / 4}).x, 0).r;
  CHECK(picture.light.at(1, 0).r == Approx(sum / 16));
}

TEST_CASE("adaptive sampling: light that is no number is looked at closely, and ends", "[ray_tracer][sampling][B73]") {
  const Asked picture = asked(kTwoDivisions, 3, 2, [](double, double) { return glm::dvec3(std::nan("")); });
  CHECK(picture.questions == 117);
  const Asked endless = asked(kTwoDivisions, 3, 2, [](double x, double) { return glm::dvec3(x < 1 ? 1 : INFINITY); });
  CHECK(endless.questions <= 117);
}
