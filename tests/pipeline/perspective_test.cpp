// Perspective that is corrected more rarely than at each pixel: how far it may be from the truth, and
// where it must be the truth.

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia {
namespace {

constexpr PerspectiveCorrection kEverySoManyPixels[] = {PerspectiveCorrection::every_8_pixels, PerspectiveCorrection::every_16_pixels,
                                                        PerspectiveCorrection::every_32_pixels};

struct Quad {
  std::vector<glm::vec4> clip, colours;
  std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3};
  MeshView view() const { return {.clip_positions = clip, .colours = colours, .indices = indices}; }
};

/// 256x16 pixels with w = 1 at the left and w = w_right at the right; red runs from 0 to 256.
Quad receding(float w_right) {
  const auto corner = [](float ndc_x, float ndc_y, float w) { return glm::vec4(ndc_x * w, ndc_y * w, 0, w); };
  return {.clip = {corner(-1, 1, 1), corner(1, 1, w_right), corner(1, -1, w_right), corner(-1, -1, 1)},
          .colours = {{0, 0, 0, 1}, {256, 0, 0, 1}, {256, 0, 0, 1}, {0, 0, 0, 1}}};
}

Image<Rgba32F> rows_of(const Quad& quad, PerspectiveCorrection correction, const PipelineOptions& options, bool is_counted = false) {
  Pipeline pipeline(options);
  RenderTarget target = *RenderTarget::create(256, 16, ColourFormat::rgba32f);
  pipeline.clear(target, {0, 0, 0, 0});
  DrawCall draw{.mesh = quad.view(), .program = gouraud(), .state = {}, .count_fragments = is_counted};
  draw.state.rasterization.perspective = correction;
  REQUIRE(pipeline.draw(target, draw).ok());
  return target.linear_image();
}

/// The texel at a place of the row, in pixels.
double texel_at(double x, double w_right) {
  const double s = x / 256;
  return 256 * (s / w_right) / ((1 - s) + s / w_right);
}

/// The largest difference to what the exact division gives, in texels.
double largest_error(const Image<Rgba32F>& image, double w_right) {
  double largest = 0;
  for (int x = 0; x < 256; ++x) {
    for (int y = 0; y < 16; ++y) largest = std::max(largest, std::abs(static_cast<double>(image.at(x, y).r) - texel_at(x + 0.5, w_right)));
  }
  return largest;
}

/// The largest distance of straight lines between the centres of every so many pixels from the truth.
double error_of_chords(int length, double w_right) {
  double largest = 0;
  for (int x = 0; x < 256; ++x) {
    const double start = x / length * length + 0.5, share = static_cast<double>(x % length) / length;
    const double straight = (1 - share) * texel_at(start, w_right) + share * texel_at(start + length, w_right);
    largest = std::max(largest, std::abs(straight - texel_at(x + 0.5, w_right)));
  }
  return largest;
}

double largest_error(PerspectiveCorrection correction, float w_right, const PipelineOptions& options) {
  return largest_error(rows_of(receding(w_right), correction, options), static_cast<double>(w_right));
}

}  // namespace

TEST_CASE("perspective: segments err as the curvature says, and no division as the chord", "[pipeline][trade]") {
  test::for_every_instruction_set([](InstructionSet set) {
    for (const Precision precision : {Precision::exact, Precision::fast}) {
      const PipelineOptions options{.threads = 1, .instruction_set = set, .precision = precision};
      CHECK(largest_error(PerspectiveCorrection::each_pixel, 2, options) < 1e-4);
      CHECK(largest_error(PerspectiveCorrection::every_8_pixels, 2, options) == Approx(0.12).epsilon(0.03));
      CHECK(largest_error(PerspectiveCorrection::every_16_pixels, 2, options) == Approx(0.46).epsilon(0.03));
      CHECK(largest_error(PerspectiveCorrection::every_32_pixels, 2, options) == Approx(1.7).epsilon(0.03));
      CHECK(largest_error(PerspectiveCorrection::none, 2, options) == Approx(43.9).epsilon(0.01));
      for (const PerspectiveCorrection correction : kEverySoManyPixels)
        for (const float w_right : {2.0f, 3.0f, 10.0f})
          CHECK(largest_error(correction, w_right, options) == Approx(error_of_chords(4 << static_cast<int>(correction), static_cast<double>(w_right))).epsilon(1e-3));
    }
  });
}

TEST_CASE("perspective: segments are exact where they begin", "[pipeline][exact]") {
  const auto exact = rows_of(receding(7), PerspectiveCorrection::each_pixel, {.threads = 1});
  for (const PerspectiveCorrection correction : kEverySoManyPixels) {
    const auto found = rows_of(receding(7), correction, {.threads = 1});
    const int length = 4 << static_cast<int>(correction);
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 256; x += length) CHECK(found.at(x, y) == exact.at(x, y));
    CHECK_FALSE(found == exact);
  }
}

TEST_CASE("perspective: segments have the same bits everywhere", "[pipeline][exact]") {
  for (const PerspectiveCorrection correction : kEverySoManyPixels) {
    const auto first = rows_of(receding(100), correction, {.threads = 1, .instruction_set = InstructionSet::baseline});
    test::for_every_instruction_set([&](InstructionSet set) {
      for (const int threads : {1, 3})
        for (const bool is_counted : {false, true})
          CHECK(rows_of(receding(100), correction, {.threads = threads, .instruction_set = set}, is_counted) == first);
    });
  }
}

TEST_CASE("perspective: what is not foreshortened does not change", "[pipeline][exact]") {
  const auto exact = rows_of(receding(1), PerspectiveCorrection::each_pixel, {.threads = 1});
  for (const PerspectiveCorrection correction : kEverySoManyPixels) CHECK(rows_of(receding(1), correction, {.threads = 1}) == exact);
  CHECK(rows_of(receding(1), PerspectiveCorrection::none, {.threads = 1}) == exact);
}

// Segments of rows near the horizon end beyond it, where 1/w is negative: none of that may show. Green is
// w; no end of a segment lies more than twice as far away as the farthest vertex.
TEST_CASE("perspective: a floor stays finite up to its horizon", "[pipeline]") {
  Quad floor{.clip = {{-30, 1, 0, 1}, {30, 1, 0, 1}, {3000, 1, 0, 1000}, {-3000, 1, 0, 1000}}, .colours = {{-30, 1, 0, 1}, {30, 1, 0, 1}, {3000, 1000, 0, 1}, {-3000, 1000, 0, 1}}};
  for (glm::vec4& p : floor.clip) p = {p.x + 0.8f * p.w - p.y, p.y - 0.3f * p.w + 0.02f * p.x, p.z, p.w};  // askew
  test::for_every_instruction_set([&](InstructionSet set) {
    int covered = 0;
    const auto exact = rows_of(floor, PerspectiveCorrection::each_pixel, {.threads = 1, .instruction_set = set});
    for (const PerspectiveCorrection correction : kEverySoManyPixels) {
      const auto found = rows_of(floor, correction, {.threads = 1, .instruction_set = set});
      for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 256; ++x) {
          if (exact.at(x, y).a == 0) continue;
          ++covered;
          CHECK((found.at(x, y).g > 0 && found.at(x, y).g <= 2001));
        }
    }
    CHECK(covered > 1000);
  });
}

}  // namespace tuberia
