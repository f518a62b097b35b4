#include "pipeline/clipping.hpp"

#include <catch2/catch.hpp>

#include "tests/support/clipping.hpp"
#include "tests/support/random.hpp"

namespace tuberia {

using test::ClipCorners;
using test::kAllPlanes;
using test::kTightGl;

TEST_CASE("clipping: each plane's bit cuts by that plane alone", "[pipeline]") {
  // One vertex outside of one plane: the cuts lie on it, halfway.
  struct Plane {
    std::uint32_t bit;
    std::size_t axis;
    double side;
  };
  for (const Plane& plane : {Plane{outcode::left, 0, -1}, {outcode::right, 0, 1}, {outcode::bottom, 1, -1},
                             {outcode::top, 1, 1}, {outcode::near, 2, -1}, {outcode::far, 2, 1}}) {
    INFO("outcode bit " << plane.bit);
    ClipCorners triangle{{{0, 0, 0, 1}, {0, 0, 0, 1}, {0, 0, 0, 1}}};
    triangle[1][(plane.axis + 1) % 3] = 0.5;
    triangle[2][plane.axis] = 2 * plane.side;
    const ClippedPolygon polygon = clip_triangle(triangle, plane.bit, kTightGl);
    REQUIRE(polygon.count == 4);
    for (const std::size_t i : {2u, 3u}) CHECK(polygon.corner[i].position[plane.axis] == plane.side);
    // Without its bit it is left alone.
    CHECK(clip_triangle(triangle, kAllPlanes & ~plane.bit, kTightGl).count == 3);
  }
}

TEST_CASE("clipping: a vertex very far away does not move the cut near the other one", "[pipeline]") {
  // Between w = 1e20 and w = 1 the near plane passes close by the second vertex.
  const double z = static_cast<double>(-1.1f);
  const ClipCorners triangle{{{0, 0, 0, 1e20}, {1, 1, z, 1}, {-1, 1, z, 1}}};
  const ClippedPolygon rest = clip_triangle(triangle, outcode::near, kTightGl);
  REQUIRE(rest.count == 3);
  const auto points = test::ndc_of(rest);
  CHECK(points[1].x == Approx(-1 / z).epsilon(1e-12));
  CHECK(points[1].y == Approx(-1 / z).epsilon(1e-12));
  CHECK(points[2].x == Approx(1 / z).epsilon(1e-12));
}

TEST_CASE("clipping: a cut that all but meets a vertex is still a new vertex", "[pipeline]") {
  // Seen from w = 1e20 the cut lies at the second vertex, but for one part in 1e21: which is w = 1.1.
  const ClipLimits limits = clip_limits({0, 0, 64, 64}, ClipVolume::minus_w_to_w);
  VertexBatch vertices;
  vertices.source = {0, 1, 2};
  vertices.clip_x = {0, 1, -1}, vertices.clip_y = {0, 1, 1}, vertices.clip_z = {0, -1.1f, -1.1f};
  vertices.clip_w = {1e20f, 1, 1};
  vertices.outcode = {0, outcode::near, outcode::near};
  TriangleBatch triangles;
  triangles.add(0, 1, 2, 0, 7);
  CHECK(Clipping(limits)(vertices, triangles) == 1);
  REQUIRE(triangles.count == 1);
  CHECK(vertices.clipped.size() == 2);
  for (const std::uint32_t slot : {triangles.v0[0], triangles.v1[0], triangles.v2[0]})
    CHECK(vertices.clip_z[slot] >= -vertices.clip_w[slot]);
  CHECK(triangles.primitive[0] == 7);
}

TEST_CASE("cutting: a polygon alone is cut as the triangles of the pipeline are", "[pipeline][exact]") {
  test::Random random(0x90);
  ClipLimits limits;
  limits.user_plane_count = 1;
  limits.user_planes[0][0] = 1, limits.user_planes[0][3] = 0.25;
  int cut = 0;
  for (int i = 0; i < 2000; ++i) {
    std::array<std::array<double, 4>, 3> triangle;
    std::vector<glm::dvec4> corners;
    for (auto& corner : triangle) {
      for (double& c : corner) c = static_cast<double>(random.between(-3, 3));
      corners.push_back({corner[0], corner[1], corner[2], corner[3]});
    }
    const ClippedPolygon expected = clip_triangle(triangle, ~0u, limits);
    const std::vector<glm::dvec4> polygon = clip_polygon(corners, limits);
    REQUIRE(polygon.size() == static_cast<std::size_t>(expected.count));
    for (std::size_t k = 0; k < polygon.size(); ++k)
      for (int c = 0; c < 4; ++c) REQUIRE(polygon[k][c] == expected.corner[k].position[c]);
    cut += expected.count > 3;
  }
  CHECK(cut > 300);
}

TEST_CASE("cutting: a hundred corners around the volume leave its square", "[pipeline]") {
  std::vector<glm::dvec4> circle;
  for (int i = 0; i < 100; ++i) circle.push_back({2 * std::cos(0.0628318530717958 * i), 2 * std::sin(0.0628318530717958 * i), 0, 1});
  const std::vector<glm::dvec4> square = clip_polygon(circle, {});
  double area = 0;
  for (std::size_t i = 0; i < square.size(); ++i) {
    const glm::dvec4 &a = square[i], &b = square[(i + 1) % square.size()];
    area += 0.5 * (a.x * b.y - a.y * b.x);
  }
  CHECK(area == Approx(4).epsilon(1e-12));
  CHECK(clip_polygon(std::vector<glm::dvec4>{{5, 0, 0, 1}, {6, 0, 0, 1}, {5, 1, 0, 1}}, {}).empty());
}

}  // namespace tuberia
