#include <catch2/catch.hpp>

#include <memory>

#include "bench/curves/memory.hpp"
#include "bench/curves/repeated_indices.hpp"
#include "pipeline/pipeline.hpp"
#include "pipeline/programs/programs.hpp"

namespace tuberia::bench {
namespace {

constexpr std::size_t kPeriod = 3 * 1024;  // indices: three pages

RepeatedIndices repeated_quad(std::size_t triangles) {
  std::vector<std::uint32_t> period;
  while (period.size() < kPeriod) period.insert(period.end(), {0, 1, 2, 0, 2, 3});
  auto indices = RepeatedIndices::create(period, 3 * triangles);
  REQUIRE(indices.ok());
  return *std::move(indices);
}

/// Heap that a new pipeline needs at most for one draw of so many triangles of a pixel or two.
std::int64_t heap_of_a_draw(std::size_t triangles) {
  const std::vector<glm::vec3> corners{{0, 0, 0}, {0.02f, 0, 0}, {0.02f, 0.02f, 0}, {0, 0.02f, 0}};
  const std::vector<glm::vec4> colours(4, glm::vec4(1));
  const RepeatedIndices indices = repeated_quad(triangles);
  DrawCall draw;
  draw.mesh.positions = corners;
  draw.mesh.colours = colours;
  draw.mesh.indices = indices.indices();
  draw.program = gouraud();
  RenderTarget target = *RenderTarget::create(128, 128);
  const std::int64_t before = heap_bytes();
  restart_heap_peak();
  Pipeline pipeline({.threads = 1});
  const auto drawn = pipeline.draw(target, draw);
  REQUIRE(drawn.ok());
  REQUIRE(drawn->triangles_in == static_cast<std::int64_t>(triangles));
  return heap_peak_bytes() - before;
}

}  // namespace

TEST_CASE("memory: what is taken and given back shows in use and at the peak", "[bench]") {
  const std::int64_t before = heap_bytes();
  restart_heap_peak();
  auto megabyte = std::make_unique<std::vector<char>>(1 << 20);
  CHECK(heap_bytes() - before >= 1 << 20);
  megabyte.reset();
  CHECK(heap_bytes() == before);
  CHECK(heap_peak_bytes() - before >= 1 << 20);
  restart_heap_peak();
  CHECK(heap_peak_bytes() == before);
}

TEST_CASE("memory: repeated indices read as their period, over and over, up to any length", "[bench]") {
  std::vector<std::uint32_t> period(kPeriod);
  for (std::size_t i = 0; i < kPeriod; ++i) period[i] = static_cast<std::uint32_t>(i * 7);
  const auto indices = RepeatedIndices::create(period, 5 * kPeriod - 3);
  REQUIRE(indices.ok());
  REQUIRE(indices->indices().size() == 5 * kPeriod - 3);
  bool equal = true;
  for (std::size_t i = 0; i < indices->indices().size(); ++i)
    equal = equal && indices->indices()[i] == period[i % kPeriod];
  CHECK(equal);
}

TEST_CASE("memory: a draw needs no more for sixteen times the triangles", "[bench]") {
  const std::int64_t some = heap_of_a_draw(500'000), many = heap_of_a_draw(8'000'000);
  CHECK(some > 0);
  CHECK(many <= some + some / 50);
  CHECK(many < 256 << 20);
}

}  // namespace tuberia::bench
