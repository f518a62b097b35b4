#include "pipeline/primitive_assembly.hpp"

#include <catch2/catch.hpp>

#include "tests/support/render.hpp"

namespace tuberia {

namespace {

using Corners = std::vector<std::array<std::uint32_t, 3>>;

Corners assembled(Topology topology, std::vector<std::uint32_t> slots, PrimitiveRange range, TriangleBatch& batch) {
  PrimitiveAssembly({topology})(slots, range, batch);
  Corners corners;
  for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) corners.push_back({batch.v0[i], batch.v1[i], batch.v2[i]});
  return corners;
}

/// Points on a circle, counter-clockwise, z = 0.
test::Mesh ring(std::vector<int> order) {
  test::Mesh mesh;
  const glm::vec3 hexagon[6] = {{0.8f, 0, 0}, {0.4f, 0.7f, 0}, {-0.4f, 0.7f, 0}, {-0.8f, 0, 0}, {-0.4f, -0.7f, 0}, {0.4f, -0.7f, 0}};
  for (const int i : order) mesh.positions.push_back(hexagon[i]);
  return mesh;
}

std::int64_t pixels(Topology topology, const test::Mesh& mesh, CullFace cull) {
  PipelineState state;
  state.assembly.topology = topology;
  state.culling.cull = cull;
  state.depth = kDepthOff;
  return test::pixels_drawn(test::render(mesh, gouraud(), state).colour);
}

}  // namespace

TEST_CASE("assembly: a list takes three vertices a triangle", "[pipeline]") {
  TriangleBatch batch;
  CHECK(assembled(Topology::triangles, {9, 8, 7, 6, 5, 4}, {10, 2}, batch) == Corners{{9, 8, 7}, {6, 5, 4}});
  CHECK(batch.provoking[1] == 6);
  CHECK(batch.primitive[0] == 10);
  CHECK(batch.primitive[1] == 11);
}

TEST_CASE("assembly: a strip turns every other triangle to keep its winding", "[pipeline]") {
  TriangleBatch batch;
  CHECK(assembled(Topology::triangle_strip, {0, 1, 2, 3, 4}, {0, 3}, batch) == Corners{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}});
  CHECK((batch.provoking[0] == 0 && batch.provoking[1] == 1 && batch.provoking[2] == 2));
  // A run that begins with an odd triangle goes on as if there had been no cut.
  CHECK(assembled(Topology::triangle_strip, {1, 2, 3, 4}, {1, 2}, batch) == Corners{{1, 3, 2}, {2, 3, 4}});
}

TEST_CASE("assembly: a fan's triangles share its first vertex", "[pipeline]") {
  TriangleBatch batch;
  CHECK(assembled(Topology::triangle_fan, {0, 1, 2, 3}, {0, 2}, batch) == Corners{{1, 2, 0}, {2, 3, 0}});
  CHECK((batch.provoking[0] == 1 && batch.provoking[1] == 2));
}

TEST_CASE("assembly: all triangles of a list, strip or fan face the same way", "[pipeline]") {
  const test::Mesh fan = ring({0, 1, 2, 3, 4, 5}), strip = ring({1, 2, 0, 3, 5, 4});
  test::Mesh list = ring({0, 1, 2, 3, 4, 5});
  list.indices = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5};
  const std::int64_t hexagon = pixels(Topology::triangles, list, CullFace::none);
  CHECK(hexagon > 1500);
  CHECK(pixels(Topology::triangles, list, CullFace::back) == hexagon);
  CHECK(pixels(Topology::triangle_fan, fan, CullFace::back) == hexagon);
  CHECK(pixels(Topology::triangle_strip, strip, CullFace::back) == hexagon);
  for (const auto& [topology, mesh] : {std::pair{Topology::triangles, list}, {Topology::triangle_fan, fan}, {Topology::triangle_strip, strip}})
    CHECK(pixels(topology, mesh, CullFace::front) == 0);
}

TEST_CASE("assembly: long strips and fans do not notice where the chunks end", "[pipeline]") {
  // A fan of one triangle a pixel row and more than two chunks; a strip along a zigzag.
  constexpr int kTriangles = 5000;
  test::Mesh fan, strip;
  fan.positions.push_back({-1, -1, 0});
  for (int i = 0; i <= kTriangles; ++i) fan.positions.push_back({1, static_cast<float>(2 * i) / kTriangles - 1, 0});
  for (int i = 0; i < kTriangles + 2; ++i)
    strip.positions.push_back({static_cast<float>(i) / (kTriangles + 1) * 2 - 1, i % 2 == 0 ? 1.0f : -1.0f, 0});
  CHECK(pixels(Topology::triangle_fan, fan, CullFace::back) == pixels(Topology::triangle_fan, fan, CullFace::none));
  CHECK(pixels(Topology::triangle_fan, fan, CullFace::back) > 1900);
  CHECK(pixels(Topology::triangle_strip, strip, CullFace::back) == 64 * 64);
  CHECK(pixels(Topology::triangle_strip, strip, CullFace::front) == 0);
}

TEST_CASE("assembly: flat shading takes the first vertex", "[pipeline]") {
  test::Mesh mesh = ring({0, 1, 2, 3, 4, 5});
  mesh.colours = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 0, 1}, {0, 1, 1, 1}, {1, 0, 1, 1}};
  const auto first_colour = [&](const FragmentProgram& program, bool flat_shading, std::vector<std::uint32_t> indices) {
    PipelineState state;
    state.rasterization.flat_shading = flat_shading;
    mesh.indices = std::move(indices);
    const Image<Rgba8> image = test::render(mesh, program, state).colour;
    Rgba8 found{0, 0, 0, 0};
    for (const Rgba8& p : image.pixels())
      if (p != Rgba8{0, 0, 0, 0}) {
        if (found != Rgba8{0, 0, 0, 0}) CHECK(p == found);
        found = p;
      }
    return found;
  };
  // Both ways round, since culling turns one of them.
  CHECK(first_colour(flat(), false, {0, 2, 4}) == Rgba8{255, 0, 0, 255});
  CHECK(first_colour(flat(), false, {2, 0, 4}) == Rgba8{0, 0, 255, 255});
  CHECK(first_colour(gouraud(), true, {4, 2, 0}) == Rgba8{0, 255, 255, 255});
  CHECK(first_colour(gouraud(), true, {2, 4, 0}) == Rgba8{0, 0, 255, 255});
}

}  // namespace tuberia
