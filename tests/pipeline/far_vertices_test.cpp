// Vertices as far away as a float can say, found by comparing with the scalar oracle.

#include <catch2/catch.hpp>

#include "tests/support/render.hpp"

namespace tuberia::test {
namespace {

PipelineState far_vertices_state(const ClipTriangle& triangle) {
  PipelineState state;
  state.transform.clip_from_world = clip_from_unit_vectors(triangle);
  return state;
}

TEST_CASE("pipeline: one vertex 2^127 times as far as another leaves a colour everywhere", "[pipeline]") {
  // The centre of pixel (32, 32) is the far vertex itself, so that only its tiny 1/w is left there.
  const float far_away = 3e38f;
  const ClipTriangle triangle{{far_away / 64, -far_away / 64, 0, far_away}, {-0.25f, -0.5f, 0, 0.25f}, {0.5f, 0.25f, 0, 0.25f}};
  const Picture picture = render(unit_vectors(), gouraud(), far_vertices_state(triangle));
  REQUIRE(pixels_drawn(picture.colour) > 100);
  for (const Rgba8& pixel : picture.colour.pixels()) CHECK((pixel == Rgba8{0, 0, 0, 0} || pixel == Rgba8{255, 255, 255, 255}));
}

TEST_CASE("pipeline: a cut corner whose w vanishes as a float is left out", "[pipeline]") {
  Mesh mesh = unit_vectors();
  PipelineState state = far_vertices_state({{0.5f, 1, 0.5f, 1}, {4e-43f, 0, 0, 0}, {0, 0, 0, 0}});
  mesh.positions.resize(2);
  state.assembly.topology = Topology::lines;
  CHECK(pixels_drawn(render(mesh, gouraud(), state).colour) == 0);
}

}  // namespace
}  // namespace tuberia::test
