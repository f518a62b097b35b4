// The oracle itself against cases whose answers are known without it.       [rules 3] in docs/sources.md

#include <catch2/catch.hpp>

#include <bit>
#include <cmath>
#include <vector>

#include "reference/oracle/clipping.hpp"
#include "reference/oracle/coverage.hpp"
#include "reference/oracle/diamond.hpp"
#include "reference/oracle/oracle.hpp"
#include "reference/oracle/screen.hpp"
#include "tests/support/random.hpp"

namespace tuberia::oracle {
namespace {

struct Units {
  std::int32_t x, y;
};

Draw closed_form_draw(Topology topology, const std::vector<Units>& units) {
  Draw draw;
  draw.topology = topology;
  draw.space = PositionSpace::screen;
  draw.depth_test = Compare::always;
  for (const Units& u : units) {
    InputVertex v;
    v.screen_x = u.x;
    v.screen_y = u.y;
    v.position.w = 1;
    draw.vertices.push_back(v);
  }
  return draw;
}

std::int64_t fragments_of(const Draw& draw, int width, int height) {
  Target target(width, height, 1, ColourFormat::rgba8, DepthFormat::d24);
  target.clear(glm::vec4(0), 1, 0);
  return oracle::draw(target, draw).fragments;
}

std::int64_t covered(const std::vector<Units>& triangle, int width = 8, int height = 8) {
  return fragments_of(closed_form_draw(Topology::triangles, triangle), width, height);
}

Draw clip_draw(const std::vector<glm::vec4>& positions) {
  Draw draw;
  draw.volume = ClipVolume::zero_to_w;
  draw.depth_test = Compare::always;
  for (const glm::vec4& position : positions) {
    draw.vertices.emplace_back();
    draw.vertices.back().position = position;
  }
  return draw;
}

std::vector<Corner> clipped_by_volume(const std::vector<glm::vec4>& positions) {
  const Draw draw = clip_draw(positions);
  bool was_cut = false;
  return clipped(transformed(draw), clip_planes(draw, {0, 0, 64, 64}), was_cut);
}

double ndc_area(const std::vector<Corner>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& a = corners[i];
    const Corner& b = corners[(i + 1) % corners.size()];
    sum += a.x / a.w * b.y / b.w - b.x / b.w * a.y / a.w;
  }
  return std::abs(sum) / 2;
}

TEST_CASE("oracle: a diagonal through centres splits a square without loss", "[reference][exact]") {
  CHECK(covered({{0, 0}, {2048, 0}, {2048, 2048}}) == 36);
  CHECK(covered({{0, 0}, {2048, 2048}, {0, 2048}}) == 28);
}

TEST_CASE("oracle: the top-left rule at single centres", "[reference][exact]") {
  CHECK(covered({{128, 128}, {384, 128}, {128, 384}}) == 1);
  CHECK(covered({{384, 384}, {128, 384}, {384, 128}}) == 0);
  CHECK(covered({{0, 0}, {127, 0}, {0, 127}}) == 0);
  CHECK(covered({{127, 127}, {130, 128}, {127, 129}}) == 1);
}

TEST_CASE("oracle: slivers", "[reference][exact]") {
  CHECK(covered({{128, 128}, {256128, 129}, {256128, 128}}, 1024, 4) == 1000);
  CHECK(covered({{128, 127}, {256128, 128}, {128, 128}}, 1024, 4) == 0);
  CHECK(covered({{128, 127}, {256128, 128}, {128, 129}}, 1024, 4) == 1000);
  CHECK(covered({{0, 0}, {262144, 262144}, {262144, 262145}}, 1024, 1024) == 0);
  CHECK(covered({{0, 0}, {262144, 262143}, {262144, 262144}}, 1024, 1024) == 1024);
  CHECK(covered({{0, 0}, {262144, 262145}, {262144, 262143}}, 1024, 1024) == 1024);
}

TEST_CASE("oracle: areas of one unit in the whole guard band", "[reference][exact]") {
  const auto area = [](Units a, Units b, Units c) {
    const auto at = [](Units u) { return ScreenVertex{u.x, u.y, 0, 1, {}, {}}; };
    return doubled_area(at(a), at(b), at(c));
  };
  CHECK(area({-8388608, -8388608}, {8388607, 8388606}, {-8388607, -8388607}) == 1);
  CHECK(area({-8388608, -8388608}, {8388607, 8388606}, {8388606, 8388605}) == -1);
}

TEST_CASE("oracle: 20,000 small random triangles have the published coverage", "[reference][exact]") {
  test::Random random(3);
  std::int64_t count = 0;
  std::uint64_t hash = 0;
  std::vector<Units> all;
  for (int i = 0; i < 20000; ++i) {
    const auto cx = random.below(128 * 256), cy = random.below(128 * 256);
    std::vector<Units> triangle;
    for (int k = 0; k < 3; ++k) {
      const auto x = cx + random.below(601) - 300;
      const auto y = cy + random.below(601) - 300;
      triangle.push_back({static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)});
    }
    const Draw draw = closed_form_draw(Topology::triangles, triangle);
    const GeometryResult screen = geometry(draw, {0, 0, 128, 128}, DepthFormat::d24);
    if (screen.primitives.empty()) continue;
    const Shape shape(screen.primitives[0], draw, 1);
    // These triangles are at most three pixels wide.
    const int left = static_cast<int>(cx / 256) - 2, top = static_cast<int>(cy / 256) - 2;
    for (int y = std::max(top, 0); y < std::min(top + 5, 128); ++y)
      for (int x = std::max(left, 0); x < std::min(left + 5, 128); ++x)
        if (shape.covers(x, y, 0)) {
          ++count;
          hash += static_cast<std::uint64_t>(i + 1) * static_cast<std::uint64_t>(y * 128 + x + 1);
        }
  }
  CHECK(count == 8407);
  CHECK(hash == 0x9d80d3a256);
}

TEST_CASE("oracle: a triangle cut by the far plane", "[reference]") {
  const std::vector<Corner> corners = clipped_by_volume({{-.5f, -.5f, .5f, 1}, {.5f, -.5f, .5f, 1}, {0, .5f, -.5f, 1}});
  REQUIRE(corners.size() == 4);
  CHECK(ndc_area(corners) == Approx(3.0 / 8));
}

TEST_CASE("oracle: a vertex behind the eye", "[reference]") {
  const std::vector<Corner> corners = clipped_by_volume({{0, .5f, .25f, 1}, {.5f, -.5f, .25f, 1}, {0, 0, -2, -1}});
  REQUIRE(corners.size() == 4);
  CHECK(ndc_area(corners) == Approx(15.0 / 392));
}

TEST_CASE("oracle: what covers the screen covers it at any size", "[reference][exact]") {
  for (const float scale : {1.0f, 1e6f, 1e9f, 1e15f, 1e30f})
    CHECK(fragments_of(clip_draw({{-10 * scale, -10 * scale, .5f, 1}, {30 * scale, -10 * scale, .5f, 1}, {-10 * scale, 30 * scale, .5f, 1}}), 64, 64) == 4096);
  CHECK(fragments_of(clip_draw({{-2e37f, -2e37f, .5f, 1}, {2e37f, -2e37f, .5f, 1}, {0, 2e37f, .5f, 1}}), 64, 64) == 4096);
}

TEST_CASE("oracle: six corners, touching corners, and vertices at infinity", "[reference][exact]") {
  const std::vector<glm::vec4> hexagon{{12, -6, -2.5f, 1}, {-6, 12, -2.5f, 1}, {-6, -6, 6.5f, 1}};
  CHECK(fragments_of(clip_draw(hexagon), 64, 64) == 3072);
  CHECK(fragments_of(clip_draw({{1, 0, .5f, 1}, {2, 1, .5f, 1}, {2, -1, .5f, 1}}), 64, 64) == 0);
  const std::vector<Corner> touching = clipped_by_volume({{1, 0, .5f, 1}, {-1, 1, .5f, 1}, {-1, -1, .5f, 1}});
  CHECK(touching.size() == 3);
  CHECK(ndc_area(touching) == 2);
  CHECK(fragments_of(clip_draw({{0, 0, 0, 0}, {.5f, 0, .25f, 1}, {0, .5f, .25f, 1}}), 64, 64) == 0);
  CHECK(fragments_of(clip_draw({{1, 0, 0, 0}, {0, -.5f, .25f, 1}, {0, .5f, .25f, 1}}), 64, 64) == 1024);
}

TEST_CASE("oracle: alpha 128 over and over", "[reference]") {
  const auto layered = [](const std::vector<glm::vec4>& colours) {
    Target target(1, 1, 1, ColourFormat::rgba8, DepthFormat::d24);
    target.clear(glm::vec4(1), 1, 0);
    for (const glm::vec4& colour : colours) {
      Draw draw = closed_form_draw(Topology::points, {{128, 128}});
      draw.vertices[0].colour = colour;
      draw.blend.mode = BlendMode::source_over;
      oracle::draw(target, draw);
    }
    const Sample& pixel = target.at(0, 0, 0);
    return std::vector<double>{pixel.colour[0].low, pixel.colour[1].low, pixel.colour[2].low};
  };
  const float a = 128.0f / 255;
  const glm::vec4 red{1, 0, 0, a}, green{0, 1, 0, a}, blue{0, 0, 1, a};
  CHECK(layered({red}) == std::vector<double>{255, 127, 127});
  CHECK(layered({blue, green, red}) == std::vector<double>{159, 95, 63});
  CHECK(layered({red, green, blue}) == std::vector<double>{63, 95, 159});
  CHECK(layered(std::vector<glm::vec4>(100, {0, 0, 0, 1.0f / 255}))[0] == 155);
}

TEST_CASE("oracle: codes of depths and colours at their ties", "[reference][exact]") {
  CHECK(depth_code(0.5f, DepthFormat::d24) == 8388608);
  CHECK(depth_code(0.5f, DepthFormat::d16) == 32768);
  CHECK(depth_code(-0.0f, DepthFormat::d32f) == 0);
  CHECK(depth_code(1.0f, DepthFormat::d32f) == 0x3f800000);
  CHECK(stored(0.5, 0, ColourFormat::rgba8) == Interval(128.0));
  CHECK(stored(65519.99, 0, ColourFormat::rgba16f) == Interval(65504.0));
  CHECK(std::isinf(stored(65520.0, 0, ColourFormat::rgba16f).low));
  CHECK(stored(1.0 + 0x1p-11, 0, ColourFormat::rgba16f) == Interval(1.0));
  CHECK(stored(0x1p-25, 0, ColourFormat::rgba16f) == Interval(0.0));
}

TEST_CASE("oracle: a slope of exactly the polygon offset's figures", "[reference]") {
  // z = 0.25 + 0.001 x + 0.002 y at pixels (0,0), (256,0), (0,250): factor 1.5, units 4.
  Draw draw = closed_form_draw(Topology::triangles, {{0, 0}, {65536, 0}, {0, 64000}});
  const float depths[3] = {0.25f, 0.506f, 0.75f};
  for (std::size_t i = 0; i < 3; ++i) draw.vertices[i].screen_depth = depths[i];
  draw.polygon_offset = {.factor = 1.5f, .units = 4};
  const auto bias = [&](DepthFormat format) { return geometry(draw, {0, 0, 64, 64}, format).primitives.at(0).bias; };
  CHECK(bias(DepthFormat::d24) == Approx(.0030002384185791016).epsilon(1e-6));
  CHECK(bias(DepthFormat::d16) == Approx(.00306103515625).epsilon(1e-6));
  CHECK(bias(DepthFormat::d32f) == Approx(.0030002384185791016).epsilon(1e-6));
}

TEST_CASE("oracle: lines leave diamonds", "[reference][exact]") {
  const auto line = [](Units a, Units b) { return fragments_of(closed_form_draw(Topology::lines, {a, b}), 16, 16); };
  CHECK(line({128, 128}, {128 + 5 * 256, 128}) == 5);      // from centre to centre: not the last pixel
  CHECK(line({128 + 5 * 256, 128}, {128, 128}) == 5);
  CHECK(line({128, 128}, {128, 128}) == 0);
  CHECK(line({128, 128}, {140, 130}) == 0);                // within one diamond
  CHECK(line({0, 0}, {16 * 256, 16 * 256}) == 16);
  // Whoever draws on from where the last line ended draws every pixel once.
  CHECK(fragments_of(closed_form_draw(Topology::line_loop, {{300, 300}, {3000, 500}, {2000, 3000}}), 16, 16) ==
        line({300, 300}, {3000, 500}) + line({3000, 500}, {2000, 3000}) + line({2000, 3000}, {300, 300}));
}

TEST_CASE("oracle: a multisampled pixel resolves to the mean of its codes", "[reference][exact]") {
  Target target(1, 1, 4, ColourFormat::rgba8, DepthFormat::d24);
  target.clear(glm::vec4(0), 1, 0);
  Draw draw = closed_form_draw(Topology::triangles, {{0, 0}, {256, 0}, {0, 256}});
  oracle::draw(target, draw);
  int samples = 0;
  for (int s = 0; s < 4; ++s) samples += target.at(0, 0, s).colour[0].low == 255 ? 1 : 0;
  CHECK(samples == 2);  // (-2,-6) and (-6,2) of (-2,-6) (6,-2) (-6,2) (2,6); (6,-2) lies beyond the diagonal
  CHECK(target.resolved(0, 0).colour[0] == Interval(128.0));
}

}  // namespace
}  // namespace tuberia::oracle
