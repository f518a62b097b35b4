#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "tests/pipeline/technique_program_kernels.hpp"
#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/render.hpp"

namespace tuberia {
namespace {

using test::Shown;
using test::TechniqueUniforms;
using enum Pattern::Kind;

constexpr int kSide = 64;

/// The whole picture, u to the right and v down from 0 to 1, plus an offset.
test::Mesh screen(glm::vec2 offset = {0, 0}) {
  test::Mesh mesh = test::rectangle({-1, 1, 0}, {2, 0, 0}, {0, -2, 0}, {0, 0, 1});
  for (glm::vec2& uv : mesh.texcoords) uv += offset;
  return mesh;
}

Image<Rgba32F> drawn(const Pattern& pattern, const test::Mesh& mesh, InstructionSet set = supported_instruction_sets().front(), Precision precision = Precision::exact) {
  const test::Canvas canvas{.width = kSide, .height = kSide, .colour = ColourFormat::rgba32f, .options = {.threads = 1, .instruction_set = set, .precision = precision}};
  return test::render(mesh, test::technique({.shown = Shown::pattern, .pattern = pattern}), {}, canvas).linear;
}

Pattern some_pattern(Pattern::Kind kind, float scale) {
  glm::mat4 block = rotation({0.6, 0, 0.8}, 0.7);
  block[3] = {0.3f, -0.2f, 0.6f, 1};
  return {.kind = kind, .first = {0.9f, 0.7f, 0.2f}, .second = {0.1f, 0.3f, 0.6f}, .scale = scale, .turbulence = 0.8f, .seed = 5, .pattern_from_world = block};
}

/// What the definition says of pixel (x, y) of `screen`.
glm::dvec3 defined(const Pattern& pattern, int x, int y, glm::dvec2 offset) {
  const double step = 1.0 / kSide;
  const auto band = [&](int i, int j) {
    const glm::dvec4 world{-1 + (i + 0.5) * 2 * step, 1 - (j + 0.5) * 2 * step, 0, 1};
    const glm::dvec3 p = glm::dvec3(glm::dmat4(pattern.pattern_from_world) * world) * static_cast<double>(pattern.scale);
    return pattern.kind == wood ? std::sqrt(p.x * p.x + p.z * p.z) : p.x;
  };
  const int left = x / 2 * 2, upper = y / 2 * 2;
  const double width = std::max(std::abs(band(left + 1, y) - band(left, y)), std::abs(band(x, upper + 1) - band(x, upper)));
  return pattern_colour(pattern, {.texcoord = glm::dvec2((x + 0.5) * step, (y + 0.5) * step) + offset,
                                  .world = {-1 + (x + 0.5) * 2 * step, 1 - (y + 0.5) * 2 * step, 0},
                                  .texcoord_width = glm::dvec2(step), .band_width = width});
}

double difference(const Rgba32F& a, const glm::dvec3& b) {
  return std::max({std::abs(static_cast<double>(a.r) - b.x), std::abs(static_cast<double>(a.g) - b.y), std::abs(static_cast<double>(a.b) - b.z)});
}

}  // namespace

TEST_CASE("patterns: programs draw what the definition in double says", "[pipeline][patterns][B32]") {
  test::for_every_machine([](InstructionSet set, Precision precision) {
    for (const Pattern::Kind kind : {none, checker, random_squares, wood, marble})
      for (const float scale : {0.7f, 8.0f, 30.0f}) {
        const Pattern pattern = some_pattern(kind, scale);
        const glm::vec2 offset{-0.4f, 0.3f};
        const Image<Rgba32F> picture = drawn(pattern, screen(offset), set, precision);
        double most = 0;
        for (int y = 0; y < kSide; ++y)
          for (int x = 0; x < kSide; ++x) most = std::max(most, difference(picture.at(x, y), defined(pattern, x, y, offset)));
        INFO("kind " << static_cast<int>(kind) << ", scale " << scale);
        CHECK(most <= (precision == Precision::exact ? 5e-5 : 1e-4));
      }
  });
}

TEST_CASE("patterns: exact ones have the same bits on every instruction set", "[pipeline][patterns][exact]") {
  for (const Pattern::Kind kind : {checker, random_squares, wood, marble}) {
    const Image<Rgba32F> first = drawn(some_pattern(kind, 12), screen());
    test::for_every_instruction_set([&](InstructionSet set) { CHECK(drawn(some_pattern(kind, 12), screen(), set) == first); });
  }
}

TEST_CASE("patterns: a checker far away is the mean of its colours, not a moire", "[pipeline][patterns]") {
  const Pattern pattern{.kind = checker, .scale = 5000};
  const Image<Rgba32F> far_checker = drawn(pattern, screen());
  for (const Rgba32F& pixel : far_checker.pixels()) CHECK(pixel.g == Approx(0.5).margin(0.01));
  // Random ones as well: some 2000 squares a pixel.
  const Pattern squares{.kind = random_squares, .scale = 3000};
  const Image<Rgba32F> far_squares = drawn(squares, screen());
  for (const Rgba32F& pixel : far_squares.pixels()) CHECK(pixel.r == Approx(0.5).margin(0.01));
}

TEST_CASE("patterns: random squares use their whole range of colours, by the seed", "[pipeline][patterns]") {
  Pattern pattern{.kind = random_squares, .first = {0, 0.5f, 1}, .second = {1, 1, 1}, .scale = 16};
  const Image<Rgba32F> picture = drawn(pattern, screen());
  double mean = 0;
  float least = 1, most = 0;
  for (int j = 0; j < 16; ++j)
    for (int i = 0; i < 16; ++i) {
      const Rgba32F& inside = picture.at(4 * i + 1, 4 * j + 1);
      CHECK(inside == picture.at(4 * i + 2, 4 * j + 2));
      CHECK((inside.g >= 0.5f && inside.b == 1));
      least = std::min(least, inside.r), most = std::max(most, inside.r), mean += static_cast<double>(inside.r) / 256;
    }
  CHECK((least < 0.1f && most > 0.9f));
  CHECK(mean == Approx(0.5).margin(0.08));  // four standard deviations
  pattern.seed = 2;
  CHECK_FALSE(drawn(pattern, screen()) == picture);
}

TEST_CASE("patterns: every coordinate has a colour between the two", "[pipeline][patterns]") {
  const float endless = std::numeric_limits<float>::infinity();
  for (const Pattern::Kind kind : {checker, random_squares, wood, marble})
    for (const float odd : {endless, -endless, std::numeric_limits<float>::quiet_NaN(), 3e38f, 5e6f}) {
      Pattern pattern = some_pattern(kind, 8);
      pattern.pattern_from_world = glm::mat4(odd);
      pattern.pattern_from_world[3] = {odd, 1, 1, 1};
      test::Mesh mesh = screen();
      for (glm::vec2& uv : mesh.texcoords) uv.x = odd;
      const Image<Rgba32F> picture = drawn(pattern, mesh);
      for (const Rgba32F& pixel : picture.pixels()) {
        if (!(pixel.r >= 0.0999f && pixel.r <= 0.9001f && pixel.b >= 0.1999f && pixel.b <= 0.6001f))
          FAIL("kind " << static_cast<int>(kind) << ", coordinate " << odd << ": " << pixel.r << ", " << pixel.g << ", " << pixel.b);
      }
    }
}

}  // namespace tuberia
