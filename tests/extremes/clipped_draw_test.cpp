// What remains of clipped triangles on the screen: the cases of the rules, with their volume 0 <= z <= w.

#include <catch2/catch.hpp>

#include "tests/support/render.hpp"

namespace tuberia {

using test::Canvas;
using test::ClipTriangle;
using test::Studio;

namespace {

/// How often each pixel is covered: every fragment adds 1 to the red of a float target.
Image<Rgba32F> overdraw_of(std::initializer_list<ClipTriangle> triangles, int width, int height,
                           ClipVolume volume = ClipVolume::zero_to_w) {
  Studio studio({.width = width, .height = height, .colour = ColourFormat::rgba32f});
  test::Mesh mesh = test::unit_vectors();
  mesh.colours.assign(3, glm::vec4(1, 0, 0, 1));
  PipelineState state;
  state.clipping.volume = volume;
  state.depth = kDepthOff;
  state.blend.mode = BlendMode::additive;
  for (const ClipTriangle& t : triangles) {
    state.transform.clip_from_world = test::clip_from_unit_vectors(t);
    studio.draw(mesh.view(), gouraud(), state);
  }
  return studio.target().linear_image();
}

std::int64_t pixels_covered(const Image<Rgba32F>& overdraw) {
  return std::count_if(overdraw.pixels().begin(), overdraw.pixels().end(), [](const Rgba32F& p) { return p.r > 0; });
}
std::int64_t pixels_covered(const ClipTriangle& triangle, int width = 64, int height = 64) {
  return pixels_covered(overdraw_of({triangle}, width, height));
}
float most_often(const Image<Rgba32F>& overdraw) {
  float most = 0;
  for (const Rgba32F& p : overdraw.pixels()) most = std::max(most, p.r);
  return most;
}

ClipTriangle cover_all(float scale) {
  return {{-10 * scale, -10 * scale, .5f, 1}, {30 * scale, -10 * scale, .5f, 1}, {-10 * scale, 30 * scale, .5f, 1}};
}

}  // namespace

TEST_CASE("clipped draw: a vertex behind the eye", "[extremes][C1][case-18]") {
  const std::int64_t pixels = pixels_covered({{0, .5, .25, 1}, {.5, -.5, .25, 1}, {0, 0, -2, -1}});
  CHECK(pixels >= 33);
  CHECK(pixels <= 35);
}

TEST_CASE("clipped draw: a triangle that hides the screen does so however large it is", "[extremes][C6][case-19]") {
  for (const auto& [width, height] : {std::pair{64, 64}, {61, 47}, {200, 130}})
    for (const float scale : {1.0f, 1e6f, 1e9f, 1e15f, 1e30f}) {
      INFO("scale " << scale << ", " << width << "x" << height);
      const Image<Rgba32F> overdraw = overdraw_of({cover_all(scale)}, width, height);
      CHECK(pixels_covered(overdraw) == std::int64_t{width} * height);
      CHECK(most_often(overdraw) == 1);
    }
  CHECK(pixels_covered({{-2e37f, -2e37f, .5f, 1}, {2e37f, -2e37f, .5f, 1}, {0, 2e37f, .5f, 1}}) == 4096);
}

TEST_CASE("clipped draw: attributes survive the size of their triangle", "[extremes][C6][case-19]") {
  for (const float scale : {1.0f, 1e6f, 1e9f, 1e15f, 1e30f}) {
    INFO("scale " << scale);
    test::Mesh mesh = test::unit_vectors();
    mesh.colours = {{-10 * scale, 0, 0, 1}, {30 * scale, 0, 0, 1}, {-10 * scale, 0, 0, 1}};
    PipelineState state;
    state.transform.clip_from_world = test::clip_from_unit_vectors(cover_all(scale));
    const Image<Rgba32F> image = test::render(mesh, gouraud(), state, {.colour = ColourFormat::rgba32f}).linear;
    const double allowed = scale == 1 ? 1e-6 : 40.0 * static_cast<double>(scale) * 0x1p-22;
    double worst = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) worst = std::max(worst, std::abs(static_cast<double>(image.at(x, y).r) - ((x + 0.5) / 32 - 1)));
    CHECK(worst <= allowed);
  }
}

TEST_CASE("clipped draw: a slanted plane shows as a hexagon", "[extremes][C4][case-20]") {
  CHECK(pixels_covered({{12, -6, -2.5, 1}, {-6, 12, -2.5, 1}, {-6, -6, 6.5, 1}}) == 3072);
}

TEST_CASE("clipped draw: touching the screen from outside draws nothing", "[extremes][C6][case-21]") {
  CHECK(pixels_covered({{1, 0, .5, 1}, {2, 1, .5, 1}, {2, -1, .5, 1}}) == 0);
}

TEST_CASE("clipped draw: vertices with w = 0", "[extremes][C1][case-22]") {
  CHECK(pixels_covered({{0, 0, 0, 0}, {.5, 0, .25, 1}, {0, .5, .25, 1}}) == 0);
  CHECK(pixels_covered({{0, 0, 0, 0}, {.5, 0, .25, 1}, {0, -.5, .25, 1}}) == 0);
  CHECK(pixels_covered({{1, 0, 0, 0}, {0, -.5, .25, 1}, {0, .5, .25, 1}}) == 1024);
  // As good as at infinity, on either side of it.
  CHECK(pixels_covered({{1, 0, 0, 1e-30f}, {0, -.5, .25, 1}, {0, .5, .25, 1}}) == 1024);
  CHECK(pixels_covered({{1, 0, 0, -1e-30f}, {0, -.5, .25, 1}, {0, .5, .25, 1}}) == 1024);
}

TEST_CASE("clipped draw: an edge that ends behind the eye is shared without overlap", "[extremes][C2][case-23]") {
  const glm::vec4 a{.25, -.125, -.75, -.5}, b{-.75, .5, .5, 1}, c{1.5, .75, .9, 1.25}, d{-2, -1.5, .25, .5};
  const std::int64_t abc = pixels_covered({a, b, c}, 64, 48), bad = pixels_covered({b, a, d}, 64, 48);
  CHECK(abc >= 223);
  CHECK(abc <= 224);
  CHECK(bad == 37);
  const Image<Rgba32F> both = overdraw_of({{a, b, c}, {b, a, d}}, 64, 48);
  CHECK(most_often(both) == 1);
}

TEST_CASE("clipped draw: a homogeneous scale changes no pixel", "[extremes][C3][case-24]") {
  const ClipTriangle t{{-.5, -.75, .1, 1}, {1.5, .5, .5, 1}, {-2, 1.5, .75, 2}};
  const Image<Rgba32F> once = overdraw_of({t}, 64, 64);
  const std::int64_t pixels = pixels_covered(once);
  CHECK(pixels >= 1756);
  CHECK(pixels <= 1772);
  for (const float scale : {0x1p-20f, 0x1p20f, 0x1p-100f, 0x1p100f})
    CHECK(overdraw_of({{t.a * scale, t.b * scale, t.c * scale}}, 64, 64) == once);
}

TEST_CASE("clipped draw: w may differ by ten millions in one triangle", "[extremes][C1][case-25]") {
  // The plane of the screen's upper half, seen along a floor that reaches nearly to the horizon.
  const Image<Rgba32F> floor = overdraw_of({{{-1, -1, .5, 1}, {1, -1, .5, 1}, {0, 0, 5e6f, 1e7f}}}, 64, 64);
  CHECK(pixels_covered(floor) == pixels_covered({{-1, -1, .5, 1}, {1, -1, .5, 1}, {0, 0, .5, 1}}));
  CHECK(most_often(floor) == 1);
  CHECK(pixels_covered({{0, 0, -.5, -1}, {.5, 0, -.5, -2}, {0, .5, -.2f, -.5}}) == 0);
}

TEST_CASE("clipped draw: the notes' volume reaches from -w to w", "[extremes][C4]") {
  const auto quarter = [](float z) { return ClipTriangle{{-1, -1, z, 1}, {1, -1, z, 1}, {-1, 1, z, 1}}; };
  const auto pixels = [&](float z, ClipVolume volume) { return pixels_covered(overdraw_of({quarter(z)}, 32, 32, volume)); };
  const float before = std::nextafter(-1.0f, -2.0f), beyond = std::nextafter(1.0f, 2.0f);
  CHECK(pixels(-1, ClipVolume::minus_w_to_w) > 0);
  CHECK(pixels(1, ClipVolume::minus_w_to_w) > 0);
  CHECK(pixels(before, ClipVolume::minus_w_to_w) == 0);
  CHECK(pixels(beyond, ClipVolume::minus_w_to_w) == 0);
  CHECK(pixels(0, ClipVolume::zero_to_w) > 0);
  CHECK(pixels(-1e-30f, ClipVolume::zero_to_w) == 0);
}

}  // namespace tuberia
