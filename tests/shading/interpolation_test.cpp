// What becomes of intensities, normals and texture coordinates between the vertices of shapes.

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/matrix.hpp>
#include <numbers>

#include "math/camera.hpp"
#include "scene/mesh_view.hpp"
#include "scene/shapes/shapes.hpp"
#include "scene/vertex_normals.hpp"
#include "tests/shading/gouraud_scan_line.hpp"
#include "tests/support/render.hpp"

namespace tuberia {
namespace {

/// From above, a parallel view of x and z in [-2, 2] that shows +x to the right and -z above.
glm::mat4 from_above() {
  const Camera camera{.eye = {0, 5, 0}, .point_of_interest = {0, 0, 0}, .up = {0, 0, -1}, .projection = Projection::orthographic,
                      .view = *orthographic_volume(4, 4, 1, 9)};
  return camera_matrices(camera)->clip_from_world;
}

/// A light from the upper left, without ambient and specular.
Lighting slanting_light() {
  Lighting lighting;
  lighting.ambient = glm::vec3(0);
  lighting.diffuse = glm::vec3(1);
  lighting.lights[0].towards = {-0.6f, 0.8f, 0};
  return lighting;
}

/// The red of a row of pixels in the middle.
std::vector<double> middle_row(const Image<Rgba32F>& image, int from, int to) {
  std::vector<double> row;
  for (int x = from; x < to; ++x) row.push_back(static_cast<double>(image.at(x, image.height() / 2).r));
  return row;
}

double variance(const std::vector<double>& values) {
  double mean = 0, sum = 0;
  for (const double value : values) mean += value / static_cast<double>(values.size());
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum / static_cast<double>(values.size());
}

std::vector<double> gouraud_row(const tuberia::Mesh& mesh) {
  const Lighting lighting = slanting_light();
  test::Studio studio({.width = 256, .height = 16, .colour = ColourFormat::rgba32f});
  PipelineState state;
  state.transform.clip_from_world = from_above();
  state.transform.vertex_lighting = lighting;
  studio.draw(mesh_view(mesh), gouraud(), state);
  return middle_row(studio.picture().linear, 64, 192);  // without the strip's ends, whose vertices have one neighbour only
}

}  // namespace

TEST_CASE("gouraud: along an edge and along the line between two edges", "[B24]") {
  CHECK(test::along(0, 1, 0.25) == 0.25);  // notes 15.7
  const test::ScanLine line = test::scan_line({{{0, 0, 1}, {8, 8, 0}, {0, 8, 0.5}}}, 4);
  CHECK(line.left == 0.75);   // half-way between 1 and 0.5
  CHECK(line.right == 0.5);   // half-way between 1 and 0
  CHECK(test::intensity_at(line, 1) == Approx(0.6875));
}

TEST_CASE("gouraud: the pipeline's triangles are the scan lines'", "[B24][B25]") {
  constexpr int kWidth = 1024, kHeight = 64;
  const std::array<test::ShadedCorner, 3> triangles[] = {{{{3.25, 60.5, 0.1}, {1020.75, 40.25, 0.9}, {200.5, 2.125, 0.4}}},
                                                         {{{5, 1, 1}, {1010, 3, 0}, {30, 63, 0.25}}},
                                                         {{{500, 0.5, 0}, {520, 63, 1}, {480, 62, 0.5}}}};
  for (const auto& triangle : triangles) {
    test::Mesh mesh;
    for (const auto& [x, y, intensity] : triangle) {
      mesh.positions.push_back(glm::vec3(2 * x / kWidth - 1, 1 - 2 * y / kHeight, 0));
      mesh.colours.push_back(glm::vec4(glm::vec3(static_cast<float>(intensity)), 1));
    }
    const test::Picture picture = test::render(mesh, gouraud(), {}, {.width = kWidth, .height = kHeight, .colour = ColourFormat::rgba32f});
    int compared = 0;
    for (int y = 0; y < kHeight; ++y) {
      std::vector<int> covered;
      for (int x = 0; x < kWidth; ++x)
        if (picture.linear.at(x, y).a > 0) covered.push_back(x);
      if (covered.empty()) continue;
      const test::ScanLine line = test::scan_line(triangle, y + 0.5);
      const auto steps = test::incremental(line, covered.front() + 0.5, static_cast<int>(covered.size()));
      for (std::size_t i = 0; i < covered.size(); ++i) {
        const double direct = test::intensity_at(line, covered[i] + 0.5);
        REQUIRE(steps[i] == Approx(direct).margin(1e-6));
        REQUIRE(static_cast<double>(picture.linear.at(covered[i], y).r) == Approx(direct).margin(2e-6));
        ++compared;
      }
    }
    CHECK(compared > 500);
  }
}

TEST_CASE("gouraud: a thousand increments stay within 1e-6 of the direct form", "[B25]") {
  const test::ScanLine line{.left_x = 0.3, .right_x = 1005.8, .left = 0.17, .right = 0.93};
  const auto steps = test::incremental(line, 0.5, 1000);
  for (int i = 0; i < 1000; ++i) REQUIRE(steps[static_cast<std::size_t>(i)] == Approx(test::intensity_at(line, i + 0.5)).margin(1e-6));
}

TEST_CASE("gouraud: a zig-zag strip looks flat, and does not with more polygons", "[B27]") {
  const auto averaged = [](int strips) { return *with_vertex_normals(*zigzag_mesh({.flanks = 8, .strips_per_flank = strips})); };
  CHECK(variance(gouraud_row(averaged(1))) < 1e-12);   // [B Figure 19 a]
  const double cut = variance(gouraud_row(averaged(3)));
  CHECK(cut > 1e-3);                                   // b
  const double flanks = variance(gouraud_row(*zigzag_mesh({.flanks = 8})));  // as it is: two intensities
  CHECK(flanks > cut);
  // Of the flanks themselves: slopes 0.8 a unit, so normals (-+0.8, 1) / sqrt(1.64) under the light (-0.6, 0.8).
  const double bright = (0.48 + 0.8) / std::sqrt(1.64), dark = (-0.48 + 0.8) / std::sqrt(1.64);
  CHECK(flanks == Approx((bright - dark) * (bright - dark) / 4).epsilon(1e-5));
}

TEST_CASE("flat shading: one value a facet", "[B21]") {
  const tuberia::Mesh facets = with_facet_normals(*sphere_mesh({.radius = 1.8, .slices = 8, .stacks = 4}));
  PipelineState state;
  state.transform.clip_from_world = from_above();
  state.transform.vertex_lighting = slanting_light();
  state.rasterization.flat_shading = true;
  test::Studio studio({.width = 64, .height = 64, .colour = ColourFormat::rgba32f});
  studio.draw(mesh_view(facets), gouraud(), state);
  std::vector<float> values;
  const auto picture = studio.picture();
  for (const Rgba32F& pixel : picture.linear.pixels())
    if (pixel.a > 0) values.push_back(pixel.r);
  std::sort(values.begin(), values.end());
  const auto different = std::unique(values.begin(), values.end()) - values.begin();
  CHECK(different > 4);
  CHECK(different <= 24);  // triangles of the upper half
}

TEST_CASE("nets: a curved object's polygons can be seen as a wireframe", "[B20]") {
  const tuberia::Mesh torus = *torus_mesh({.radius = 1.3, .tube_radius = 0.5, .slices = 24, .stacks = 12});
  PipelineState state;
  state.transform.clip_from_world = from_above();
  const auto drawn = [&](PolygonMode mode) {
    state.rasterization.front_mode = state.rasterization.back_mode = mode;
    test::Studio studio({.width = 256, .height = 256});
    studio.draw(mesh_view(torus), flat(), state);
    return studio.picture().colour;
  };
  const auto whole = drawn(PolygonMode::fill), net = drawn(PolygonMode::line);
  CHECK(test::pixels_drawn(net) > 1000);
  CHECK(test::pixels_drawn(net) < test::pixels_drawn(whole) / 2);
  int outside = 0;  // the net lies on the object, but for half the width of its outermost lines
  for (int y = 1; y < 255; ++y)
    for (int x = 1; x < 255; ++x) {
      if (net.at(x, y) == Rgba8{0, 0, 0, 0}) continue;
      bool near = false;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) near |= whole.at(x + dx, y + dy) != Rgba8{0, 0, 0, 0};
      outside += !near;
    }
  CHECK(outside == 0);
}

TEST_CASE("parametric mapping: a torus shows the pattern at its own parameters", "[B36]") {
  constexpr int kTexels = 256;
  Image<Rgba8> parameters(kTexels, kTexels);  // the texel at (u, v) says where it is
  for (int y = 0; y < kTexels; ++y)
    for (int x = 0; x < kTexels; ++x) parameters.at(x, y) = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 0, 255};
  const auto texture = std::make_shared<const Texture>(*Texture::create(parameters, TextureEncoding::linear, false));
  const tuberia::Mesh torus = *torus_mesh({.radius = 1.2, .tube_radius = 0.6, .slices = 256, .stacks = 128});
  const Camera camera{.eye = {1, 3, 3}, .point_of_interest = {0, 0, 0}, .up = {0, 1, 0}, .view = *perspective_volume(0.9, 1, 1, 9)};
  PipelineState state;
  state.transform.clip_from_world = camera_matrices(camera)->clip_from_world;
  test::Studio studio({.width = 160, .height = 160, .depth = DepthFormat::d32f});
  studio.draw(mesh_view(torus), textured({.texture = texture, .sampler = {.texels = TexelFilter::nearest, .mipmaps = MipmapFilter::none}}), state);

  // Where each pixel's depth puts the point, the torus's parameters are known in closed form.
  const auto picture = studio.picture();
  const glm::dmat4 world_from_clip = glm::inverse(glm::dmat4(state.transform.clip_from_world));
  int compared = 0;
  double worst = 0;
  for (int y = 0; y < 160; ++y)
    for (int x = 0; x < 160; ++x) {
      const Rgba8 seen = picture.colour.at(x, y);
      if (seen.a == 0) continue;
      const double depth = static_cast<double>(std::bit_cast<float>(picture.depth.at(x, y)));
      const glm::dvec4 point = world_from_clip * glm::dvec4((x + 0.5) / 80 - 1, 1 - (y + 0.5) / 80, 2 * depth - 1, 1);
      const glm::dvec3 p = glm::dvec3(point) / point.w;
      const double u = std::atan2(-p.z, p.x) / (2 * std::numbers::pi);
      const double v = 0.5 - std::atan2(p.y, std::hypot(p.x, p.z) - 1.2) / (2 * std::numbers::pi);
      const auto error = [](double parameter, int code) { return std::abs(std::remainder(parameter - (code + 0.5) / kTexels, 1.0)); };
      worst = std::max({worst, error(u, seen.r), error(v, seen.g)});
      ++compared;
    }
  CHECK(compared > 5000);
  CHECK(worst < 0.5 / kTexels + 0.001);
}

}  // namespace tuberia
