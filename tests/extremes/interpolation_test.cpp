// Attributes between the vertices: rules P1 to P4, cases 26 to 29.

#include "math/interpolation.hpp"

#include <catch2/catch.hpp>

#include "tests/support/every_instruction_set.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/triangles.hpp"

namespace tuberia {

using test::for_every_instruction_set;

namespace {

/// A vertex by its place on a 64x64 target, its w and the value it carries.
struct Corner {
  float x_pixels, y_pixels, w, value;
};

/// The values over the target, 0 where nothing was drawn.
Image<Rgba32F> values(const std::array<Corner, 3>& corners, const PipelineOptions& options, int size = 64) {
  test::Mesh mesh = test::unit_vectors();
  glm::vec4 clip[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner& c = corners[i];
    const float half = 0.5f * static_cast<float>(size);
    clip[i] = {(c.x_pixels / half - 1) * c.w, (1 - c.y_pixels / half) * c.w, 0, c.w};
    mesh.colours.push_back({c.value, 0, 0, 1});
  }
  PipelineState state;
  state.transform.clip_from_world = test::clip_from_unit_vectors({clip[0], clip[1], clip[2]});
  return test::render(mesh, gouraud(), state, {.width = size, .height = size, .colour = ColourFormat::rgba32f, .options = options}).linear;
}

double value_at(int x, int y, const std::array<Corner, 3>& corners, InstructionSet set, Precision precision = Precision::exact) {
  const Rgba32F found = values(corners, {.threads = 1, .instruction_set = set, .precision = precision}).at(x, y);
  CHECK(found.a == 1);
  return static_cast<double>(found.r);
}

/// The middle of the edge from (11, 31) to (31, 11), which is a left one, is the centre of pixel (20, 20).
std::array<Corner, 3> with_edge(Corner from, Corner to) {
  from.x_pixels = 10.5f, from.y_pixels = 30.5f;
  to.x_pixels = 30.5f, to.y_pixels = 10.5f;
  return {from, to, Corner{40.5f, 40.5f, from.w, 0}};
}

double middle(float value0, float w0, float value1, float w1, InstructionSet set, Precision precision = Precision::exact) {
  return value_at(20, 20, with_edge({0, 0, w0, value0}, {0, 0, w1, value1}), set, precision);
}

}  // namespace

// notes 15.4 and 15.7
TEST_CASE("interpolation: a projected midpoint belongs mostly to the nearer vertex", "[extremes][P1]") {
  for_every_instruction_set([](InstructionSet set) {
    for (const Precision precision : {Precision::exact, Precision::fast}) {
      CHECK(middle(0, 1, 1, 3, set, precision) == Approx(0.25).epsilon(1e-6));
      CHECK(middle(0, 2, 1, 2, set, precision) == Approx(0.5).epsilon(1e-6));
    }
  });
}

TEST_CASE("interpolation: extreme ratios of w keep their digits", "[extremes][P2][case-26]") {
  for_every_instruction_set([](InstructionSet set) {
    CHECK(middle(0, 1, 1, 1000, set) == Approx(9.99000999000999e-4).epsilon(2e-6));
    CHECK(middle(0, 1, 1, 1e7f, set) == Approx(9.9999990000001e-8).epsilon(2e-6));
    // The other way round, 1 at the near vertex and 0 at the far one, it is a small difference of large
    // numbers: digits end at 2e-6 of the range.
    CHECK(middle(1, 1000, 0, 1, set) == Approx(9.99000999000999e-4).margin(2e-6));
  });
}

TEST_CASE("interpolation: points inside are weighted by 1/w", "[extremes][P1][case-27]") {
  for_every_instruction_set([](InstructionSet set) {
    CHECK(value_at(21, 21, {Corner{10.5f, 10.5f, 1, 0}, {40.5f, 13.5f, 10, 1}, {13.5f, 40.5f, 100, 2}}, set) ==
          Approx(0.108108108108108108).epsilon(2e-6));
    CHECK(value_at(20, 27, {Corner{10.5f, 10.5f, 1e-3f, 10}, {42.5f, 14.5f, 1, 20}, {14.5f, 42.5f, 1e3f, 30}}, set) ==
          Approx(10.01002994999010991).margin(2e-6 * 20));
  });
}

TEST_CASE("interpolation: the floor below the eye is where geometry says", "[extremes][P2][case-28]") {
  // A floor at y = 0 from behind the eye to the horizon, seen from one unit above it.
  test::Mesh floor = test::rectangle({-300, -1, 10}, {600, 0, 0}, {0, 0, -1000010}, {0, 1, 0});
  for (std::size_t i = 0; i < 4; ++i) floor.colours[i] = {floor.positions[i].x, floor.positions[i].z, 0, 1};
  PipelineState state;
  state.transform.clip_from_world = *perspective(1.5707963267948966, 1, 0.1, 1e7, ClipVolume::minus_w_to_w);
  struct Known {
    int x, y;
    double u, v;
  };
  for_every_instruction_set([&](InstructionSet set) {
    const test::Canvas canvas{.width = 256, .height = 256, .colour = ColourFormat::rgba32f, .options = {.threads = 1, .instruction_set = set}};
    const Image<Rgba32F> image = test::render(floor, gouraud(), state, canvas).linear;
    for (const Known& k : {Known{0, 255, -1, -1.00392156862745}, {64, 129, -42.3333333, -85.3333333}, {10, 140, -9.4, -10.24},
                           {255, 192, 1.97674418604651, -1.98449612403101}, {200, 128, 145, -256}}) {
      INFO("pixel " << k.x << ", " << k.y);
      // By v = -1 / t, u = s / t with t = (y - 127.5) / 128: one step changes u and v by this much.
      const double t = (k.y + 0.5 - 128) / 128, step = (1 / t + std::abs(k.u) / t + 1 / (t * t)) / 128;
      const Rgba32F found = image.at(k.x, k.y);
      CHECK(std::abs(static_cast<double>(found.r) - k.u) <= step / 256 + 1e-5 * std::abs(k.u));
      CHECK(std::abs(static_cast<double>(found.g) - k.v) <= step / 256 + 1e-5 * std::abs(k.v));
    }
    CHECK(image.at(128, 127).a == 0);
  });
}

TEST_CASE("interpolation: a constant stays constant", "[extremes][P3][case-29]") {
  for_every_instruction_set([](InstructionSet set) {
    for (const Precision precision : {Precision::exact, Precision::fast}) {
      const auto image = values({Corner{-20.3f, 3, 1e-6f, 1}, {70, 20, 1, 1}, {20, 90.1f, 1e6f, 1}}, {.threads = 1, .instruction_set = set, .precision = precision});
      for (const Rgba32F& p : image.pixels())
        if (p.a != 0) CHECK(p.r == 1);
    }
  });
}

// The rule asks for one unit in the last place. Ours adds two products to the first vertex's value and may
// round twice: 2^-22 of the range. A clamp to the vertices' range would cost an operation a fragment.
TEST_CASE("interpolation: no value leaves the range of its vertices by more than two roundings", "[extremes][P3]") {
  test::Random random(71);
  for (int i = 0; i < 300; ++i) {
    std::array<Corner, 3> corners;
    for (Corner& c : corners) c = {random.between(-100, 164), random.between(-100, 164), std::exp2(random.between(-10, 10)), 0};
    corners[static_cast<std::size_t>(i % 3)].value = 1;
    INFO("seed 71, triangle " << i);
    const Image<Rgba32F> image = values(corners, {.threads = 1});
    float low = 0, high = 0;
    for (const Rgba32F& p : image.pixels()) low = std::min(low, p.r), high = std::max(high, p.r);
    CHECK(low >= -0x1p-22f);
    CHECK(high <= 1 + 0x1p-22f);
  }
}

TEST_CASE("interpolation: it agrees with the definition for triangles of all sizes", "[extremes][P1][P2]") {
  test::Random random(72);
  double worst = 0;
  for (int i = 0; i < 200; ++i) {
    std::array<Corner, 3> corners;
    // On whole pixels, so that the snap moves nothing.
    for (Corner& c : corners) c = {static_cast<float>(random.below(200) - 64), static_cast<float>(random.below(200) - 64), random.between(1, 8), random.between(-1, 1)};
    const auto cross = [&](std::size_t a, std::size_t b, double x, double y) {
      const double ax = corners[a].x_pixels, ay = corners[a].y_pixels, bx = corners[b].x_pixels, by = corners[b].y_pixels;
      return (ax - x) * (by - y) - (ay - y) * (bx - x);
    };
    const double area = cross(0, 1, static_cast<double>(corners[2].x_pixels), static_cast<double>(corners[2].y_pixels));
    if (std::abs(area) < 100) continue;
    const Image<Rgba32F> image = values(corners, {.threads = 1});
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        if (image.at(x, y).a == 0) continue;
        const double px = x + 0.5, py = y + 0.5, wc = cross(0, 1, px, py) / area, wa = cross(1, 2, px, py) / area;
        std::array<double, 3> value, w;
        for (std::size_t k = 0; k < 3; ++k) value[k] = static_cast<double>(corners[k].value), w[k] = static_cast<double>(corners[k].w);
        const double expected = perspective_correct({wa, 1 - wa - wc, wc}, value, w);
        worst = std::max(worst, std::abs(static_cast<double>(image.at(x, y).r) - expected));
      }
  }
  INFO("seed 72, worst " << worst);
  CHECK(worst <= 2e-6 * 2);
}

// notes 15.7
TEST_CASE("interpolation: a ramp of a thousand pixels does not drift", "[extremes][P2]") {
  test::Mesh mesh = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1});
  mesh.colours = {{0, 0, 0, 1}, {1, 0, 0, 1}, {1, 0, 0, 1}, {0, 0, 0, 1}};
  for_every_instruction_set([&](InstructionSet set) {
    const auto image = test::render(mesh, gouraud(), {}, {.width = 1000, .height = 3, .colour = ColourFormat::rgba32f, .options = {.threads = 1, .instruction_set = set}}).linear;
    for (int x = 0; x < 1000; ++x) CHECK(std::abs(static_cast<double>(image.at(x, 1).r) - (x + 0.5) / 1000) <= 1e-6);
    CHECK(image.at(250, 1).r == Approx(0.2505).epsilon(1e-6));
  });
}

// [P4] A plane anchored at (0, 0) would be off by 1.8e-5 there.
TEST_CASE("interpolation: eight thousand pixels away it has the bits that it has at the origin", "[extremes][P4]") {
  test::Random random(73);
  for (int i = 0; i < 40; ++i) {
    std::vector<ScreenVertex> corners;
    std::vector<glm::vec4> colours;
    for (int k = 0; k < 3; ++k) {
      corners.push_back({.x = static_cast<std::int32_t>(random.below(512)), .y = static_cast<std::int32_t>(random.below(512)), .depth = random.between(0, 1), .w = random.between(1, 4)});
      colours.push_back({random.between(0, 1), random.between(0, 1), random.between(0, 1), 1});
    }
    // A strip to the right and one downwards hold both places; (8000, 8000) would take a gigabyte.
    for (const auto& [x, y] : {std::pair{8000, 0}, {0, 8000}}) {
      test::Studio studio({.width = x + 2, .height = y + 2, .colour = ColourFormat::rgba32f, .depth = DepthFormat::d32f, .options = {.threads = 1}});
      studio.draw({.screen_positions = corners, .colours = colours}, gouraud());
      std::vector<ScreenVertex> moved = corners;
      for (ScreenVertex& v : moved) v.x += x * 256, v.y += y * 256;
      studio.draw({.screen_positions = moved, .colours = colours}, gouraud());
      const Image<Rgba32F> image = studio.target().linear_image();
      const Image<std::int32_t> depths = studio.target().depth_codes();
      INFO("seed 73, triangle " << i);
      for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column) {
          CHECK(image.at(column, row) == image.at(x + column, y + row));
          CHECK(depths.at(column, row) == depths.at(x + column, y + row));
        }
    }
  }
}

namespace {

/// The largest error of an attribute from 0 to 1 over triangles with w = 1, each drawn alone.
double worst_attribute(const std::vector<test::Triangle>& triangles, int size) {
  double worst = 0;
  for (const test::Triangle& t : triangles) {
    const auto area = static_cast<double>(twice_area(t[0], t[1], t[2]));
    if (area == 0) continue;
    const std::vector<glm::vec4> colours{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}};
    test::Studio studio({.width = size, .height = size, .colour = ColourFormat::rgba32f, .options = {.threads = 1}});
    const std::vector<ScreenVertex> corners{{.x = t[0].x, .y = t[0].y}, {.x = t[1].x, .y = t[1].y}, {.x = t[2].x, .y = t[2].y}};
    studio.draw({.screen_positions = corners, .colours = colours}, gouraud());
    const Image<Rgba32F> image = studio.target().linear_image();
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        if (image.at(x, y).a == 0) continue;
        const SnappedPoint centre{x * 256 + 128, y * 256 + 128};
        const double right[2] = {static_cast<double>(twice_area(t[0], centre, t[2])) / area, static_cast<double>(twice_area(t[0], t[1], centre)) / area};
        worst = std::max({worst, std::abs(static_cast<double>(image.at(x, y).r) - right[0]), std::abs(static_cast<double>(image.at(x, y).g) - right[1])});
      }
  }
  return worst;
}

}  // namespace

TEST_CASE("interpolation: thin triangles up to 1984 pixels long are as good as any", "[extremes][P2]") {
  CHECK(worst_attribute(test::slivers(74, 600, 250000), 128) <= 2e-6);
}

TEST_CASE("interpolation: limit: thin triangles longer than 1984 pixels err by up to 2.2e-3 of the range", "[extremes][P2]") {
  // There an attribute runs through its range within less than a pixel, and the snap of the corners has
  // moved it by far more; those that are not thin keep the bound of all others.
  const double thin = worst_attribute(test::slivers(75, 600, 2000000), 128);
  INFO("worst " << thin);
  CHECK(thin <= 2.2e-3);
  std::vector<test::Triangle> stout = test::random_triangles(76, 40, -2000000, 2000000);
  std::erase_if(stout, [](const test::Triangle& t) { return std::abs(twice_area(t[0], t[1], t[2])) < 1000000000000; });
  CHECK(worst_attribute(stout, 128) <= 2e-6);
}

}  // namespace tuberia
