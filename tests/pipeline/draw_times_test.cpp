#include "pipeline/draw_times.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

#include "pipeline/pipeline.hpp"
#include "pipeline/programs/programs.hpp"
#include "tests/support/meshes.hpp"

namespace tuberia {
namespace {

/// As many triangles in one place, by default more than a chunk; for a target of six tiles.
DrawCall many_triangles(const test::Mesh& mesh, std::vector<std::uint32_t>& indices, int triangles = 3000) {
  for (int i = 0; i < triangles; ++i) indices.insert(indices.end(), {0, 1, 2});
  DrawCall draw{.mesh = mesh.view(), .program = gouraud(), .state = {}};
  draw.mesh.indices = indices;
  return draw;
}

}  // namespace

TEST_CASE("draw times: a timed draw leaves the same pixels and counts as an untimed one", "[pipeline]") {
  const test::Mesh mesh = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, 1, glm::vec4(1, 0.5f, 0.25f, 1));
  std::vector<std::uint32_t> indices;
  const DrawCall draw = many_triangles(mesh, indices);
  RenderTarget timed = *RenderTarget::create(150, 100), untimed = *RenderTarget::create(150, 100);
  Pipeline pipeline({.threads = 2});
  DrawTimes times;
  const auto with = pipeline.draw(timed, draw, times), without = pipeline.draw(untimed, draw);
  REQUIRE(with.ok());
  REQUIRE(without.ok());
  CHECK(with->triangles_drawn == without->triangles_drawn);
  const Image<Rgba8> timed_picture = timed.colour_image(), untimed_picture = untimed.colour_image();
  CHECK(std::equal(timed_picture.pixels().begin(), timed_picture.pixels().end(), untimed_picture.pixels().begin()));
}

TEST_CASE("draw times: every chunk and every tile is timed, and no time is counted twice", "[pipeline]") {
  const test::Mesh mesh = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, 1, glm::vec4(1));
  std::vector<std::uint32_t> indices;
  const DrawCall draw = many_triangles(mesh, indices);
  RenderTarget target = *RenderTarget::create(150, 100);
  Pipeline pipeline({.threads = 1});
  DrawTimes times;
  const auto begin = std::chrono::steady_clock::now();
  REQUIRE(pipeline.draw(target, draw, times).ok());
  const Nanoseconds elapsed =
      std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now() - begin).count();

  Nanoseconds sum = times.validation;
  REQUIRE(times.batches.size() == 1);
  CHECK(times.batches[0].chunks.size() == 2);
  CHECK(times.batches[0].tiles.size() == 6);
  for (const ChunkTimes& chunk : times.batches[0].chunks) {
    CHECK(chunk.total() > 0);
    sum += chunk.total();
  }
  for (const TileTimes& tile : times.batches[0].tiles) {
    CHECK(tile.total > 0);
    sum += tile.total;
  }
  CHECK(sum <= elapsed);
}

TEST_CASE("draw times: with several threads, every chunk and tile of every batch is timed", "[pipeline]") {
  const test::Mesh mesh = test::rectangle({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 1}, 1, glm::vec4(1));
  std::vector<std::uint32_t> indices;
  const DrawCall draw = many_triangles(mesh, indices, 100000);
  RenderTarget target = *RenderTarget::create(150, 100);
  Pipeline pipeline({.threads = 3});
  DrawTimes times;
  // Two draws: the second one's batches follow those of the first.
  for (int i = 0; i < 2; ++i) REQUIRE(pipeline.draw(target, draw, times).ok());
  REQUIRE(times.batches.size() == 10);  // of 12 chunks of 2048 each, and the last of one
  for (std::size_t b = 0; b < times.batches.size(); ++b) {
    CHECK(times.batches[b].chunks.size() == (b % 5 == 4 ? 1u : 12u));
    for (const ChunkTimes& chunk : times.batches[b].chunks) CHECK(chunk.total() > 0);
    for (const TileTimes& tile : times.batches[b].tiles) CHECK(tile.total > 0);
  }
}

}  // namespace tuberia
