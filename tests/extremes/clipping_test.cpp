// Clipped polygons in closed forms, and what clipping promises of any triangle: rules C1 to C4 and C6.

#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>

#include "tests/support/clipping.hpp"
#include "tests/support/random.hpp"

namespace tuberia {

using test::ClipCorners;
using test::kAllPlanes;
using test::kTightD3d;
using test::kTightGl;
using test::Random;

namespace {

std::array<double, 4> random_corner(Random& random) {
  // Floats, as vertices are; behind the eye one time in three.
  const auto coordinate = [&] { return static_cast<double>(random.between(-3, 3)); };
  return {coordinate(), coordinate(), coordinate(), static_cast<double>(random.between(-1, 2))};
}

/// Walking round, it never turns left after it has turned right.
void check_convex(const std::vector<test::NdcPoint>& points) {
  double least = 0, most = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const test::NdcPoint &a = points[i], &b = points[(i + 1) % points.size()], &c = points[(i + 2) % points.size()];
    const double turn = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
    least = std::min(least, turn), most = std::max(most, turn);
  }
  CHECK((least > -1e-13 || most < 1e-13));
}

void check_polygon(const ClippedPolygon& polygon, const ClipCorners& triangle, const ClipLimits& limits) {
  CHECK((polygon.count == 0 || (polygon.count >= 3 && polygon.count <= 9)));
  constexpr double kSlack = 1e-14;
  for (int i = 0; i < polygon.count; ++i) {
    const ClippedCorner& c = polygon.corner[static_cast<std::size_t>(i)];
    const double w = c.position[3];
    CHECK(w > 0);
    CHECK(std::abs(c.position[0]) <= w * limits.guard_x + kSlack);
    CHECK(std::abs(c.position[1]) <= w * limits.guard_y + kSlack);
    CHECK(c.position[2] >= w * limits.z_low - kSlack);
    CHECK(c.position[2] <= w + kSlack);
    CHECK(c.weight[0] + c.weight[1] + c.weight[2] == Approx(1).epsilon(1e-14));
    for (std::size_t k = 0; k < 3; ++k) CHECK(c.weight[k] >= 0);
    for (std::size_t axis = 0; axis < 4; ++axis) {
      double sum = 0;
      for (std::size_t k = 0; k < 3; ++k) sum += c.weight[k] * triangle[k][axis];
      CHECK(c.position[axis] == Approx(sum).margin(1e-13));
    }
    // A corner that a cut made lies on its plane, not next to it [C6].
    const bool is_vertex = c.weight[0] == 1 || c.weight[1] == 1 || c.weight[2] == 1;
    const bool is_on_plane = std::abs(c.position[0]) == w * limits.guard_x || std::abs(c.position[1]) == w * limits.guard_y ||
                             c.position[2] == w * limits.z_low || c.position[2] == w;
    CHECK((is_vertex || is_on_plane));
  }
  check_convex(test::ndc_of(polygon));
}

}  // namespace

TEST_CASE("clipping: the near plane cuts a corner off", "[extremes][C4][case-17]") {
  const ClipCorners triangle{{{-.5, -.5, .5, 1}, {.5, -.5, .5, 1}, {0, .5, -.5, 1}}};
  const ClippedPolygon quad = clip_triangle(triangle, outcode::near, kTightD3d);
  REQUIRE(quad.count == 4);
  CHECK(test::ndc_area(quad) == Approx(3.0 / 8).epsilon(1e-15));
  const auto points = test::ndc_of(quad);
  CHECK((points[2].x == 0.25 && points[2].y == 0 && points[3].x == -0.25 && points[3].y == 0));
}

TEST_CASE("clipping: a vertex behind the eye leaves what is before it", "[extremes][C1][case-18]") {
  const ClipCorners triangle{{{0, .5, .25, 1}, {.5, -.5, .25, 1}, {0, 0, -2, -1}}};
  const ClippedPolygon quad = clip_triangle(triangle, kAllPlanes, kTightD3d);
  REQUIRE(quad.count == 4);
  CHECK(test::ndc_area(quad) == Approx(15.0 / 392).epsilon(1e-14));
  const auto points = test::ndc_of(quad);
  CHECK(points[2].x == Approx(4.0 / 7));
  CHECK(points[2].y == Approx(-4.0 / 7));
  CHECK(points[3].x == 0);
  CHECK(points[3].y == Approx(4.0 / 7));
}

TEST_CASE("clipping: a slanted plane through the volume leaves a hexagon", "[extremes][C4][case-20]") {
  const ClipCorners triangle{{{12, -6, -2.5, 1}, {-6, 12, -2.5, 1}, {-6, -6, 6.5, 1}}};
  const ClippedPolygon hexagon = clip_triangle(triangle, kAllPlanes, kTightD3d);
  CHECK(hexagon.count == 6);
  CHECK(test::ndc_area(hexagon) == Approx(3).epsilon(1e-14));
}

// notes 15.5
TEST_CASE("clipping: six planes can leave nine corners, and never more", "[extremes][C4]") {
  const ClipCorners triangle{{{1.8, 0, -1.8, 1}, {-1.8, 1.8, 0, 1}, {0, -1.8, 1.8, 1}}};
  const ClippedPolygon polygon = clip_triangle(triangle, kAllPlanes, kTightGl);
  CHECK(polygon.count == 9);
  check_polygon(polygon, triangle, kTightGl);
}

TEST_CASE("clipping: touching from outside leaves nothing, touching from inside everything", "[extremes][C6][case-21]") {
  const ClipCorners outside{{{1, 0, .5, 1}, {2, 1, .5, 1}, {2, -1, .5, 1}}};
  CHECK(test::ndc_area(clip_triangle(outside, kAllPlanes, kTightD3d)) == 0);
  const ClipCorners inside{{{1, 0, .5, 1}, {-1, 1, .5, 1}, {-1, -1, .5, 1}}};
  const ClippedPolygon whole = clip_triangle(inside, kAllPlanes, kTightD3d);
  CHECK(whole.count == 3);
  CHECK(test::ndc_area(whole) == 2);
}

TEST_CASE("clipping: z exactly 0 and exactly w is inside", "[extremes][C1][case-25]") {
  const ClipCorners near{{{0, 0, 0, 1}, {.5, 0, 0, 2}, {0, .5, 0, .5}}};
  const ClipCorners far{{{0, 0, 1, 1}, {.5, 0, 2, 2}, {0, .5, .5, .5}}};
  const ClipCorners behind{{{0, 0, -.5, -1}, {.5, 0, -.5, -2}, {0, .5, -.2, -.5}}};
  for (const ClipCorners& kept : {near, far}) {
    const ClippedPolygon polygon = clip_triangle(kept, kAllPlanes, kTightD3d);
    REQUIRE(polygon.count == 3);
    for (std::size_t i = 0; i < 3; ++i) CHECK(std::memcmp(polygon.corner[i].position, kept[i].data(), sizeof kept[i]) == 0);
  }
  CHECK(clip_triangle(behind, kAllPlanes, kTightD3d).count == 0);
}

TEST_CASE("clipping: a vertex without w has no place", "[extremes][C1][case-22]") {
  const ClipCorners point{{{0, 0, 0, 0}, {.5, 0, .25, 1}, {0, .5, .25, 1}}};
  CHECK(clip_triangle(point, kAllPlanes, kTightD3d).count == 0);
  const ClipCorners direction{{{1, 0, 0, 0}, {0, -.5, .25, 1}, {0, .5, .25, 1}}};
  const ClippedPolygon strip = clip_triangle(direction, kAllPlanes, kTightD3d);
  REQUIRE(strip.count == 4);
  CHECK(test::ndc_area(strip) == Approx(1).epsilon(1e-14));
}

TEST_CASE("clipping: what remains is convex, inside, and made of the vertices", "[extremes][C1][C4][C6]") {
  Random random(41);
  int largest = 0;
  for (int i = 0; i < 4000; ++i) {
    const ClipCorners triangle{random_corner(random), random_corner(random), random_corner(random)};
    for (const ClipLimits& limits : {kTightGl, kTightD3d}) {
      INFO("seed 41, triangle " << i);
      const ClippedPolygon polygon = clip_triangle(triangle, kAllPlanes, limits);
      check_polygon(polygon, triangle, limits);
      largest = std::max(largest, polygon.count);
    }
  }
  CHECK(largest >= 7);
}

TEST_CASE("clipping: two halves leave as much as the whole", "[extremes][C2]") {
  Random random(42);
  for (int i = 0; i < 2000; ++i) {
    const ClipCorners whole{random_corner(random), random_corner(random), random_corner(random)};
    ClipCorners left = whole, right = whole;
    for (std::size_t axis = 0; axis < 4; ++axis) left[1][axis] = right[0][axis] = (whole[0][axis] + whole[1][axis]) / 2;
    INFO("seed 42, triangle " << i);
    const auto area = [](const ClipCorners& t) { return test::ndc_area(clip_triangle(t, kAllPlanes, kTightGl)); };
    CHECK(area(left) + area(right) == Approx(area(whole)).margin(1e-9));
  }
}

TEST_CASE("clipping: scaling by a power of two changes no bit of a direction", "[extremes][C3][case-24]") {
  Random random(43);
  for (int i = 0; i < 1000; ++i) {
    const ClipCorners triangle{random_corner(random), random_corner(random), random_corner(random)};
    const ClippedPolygon once = clip_triangle(triangle, kAllPlanes, kTightGl);
    for (const double scale : {0x1p-20, 0x1p20, 0x1p-100, 0x1p100}) {
      ClipCorners scaled = triangle;
      for (auto& corner : scaled)
        for (double& x : corner) x *= scale;
      const ClippedPolygon again = clip_triangle(scaled, kAllPlanes, kTightGl);
      REQUIRE(again.count == once.count);
      for (int c = 0; c < once.count; ++c)
        for (int axis = 0; axis < 4; ++axis) {
          const auto at = static_cast<std::size_t>(c);
          if (again.corner[at].position[axis] != once.corner[at].position[axis] * scale) FAIL("seed 43, triangle " << i);
        }
    }
  }
}

TEST_CASE("clipping: both triangles of an edge get the same vertices on it", "[extremes][C2][case-23]") {
  // The corners on the edge between the vertices 0 and 1, which are those without a share of 2.
  const auto on_edge = [](const ClippedPolygon& polygon) {
    std::vector<std::array<double, 4>> corners;
    for (int i = 0; i < polygon.count; ++i) {
      const ClippedCorner& c = polygon.corner[static_cast<std::size_t>(i)];
      if (c.weight[2] == 0) corners.push_back({c.position[0], c.position[1], c.position[2], c.position[3]});
    }
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  Random random(44);
  for (int i = 0; i < 4000; ++i) {
    const auto a = random_corner(random), b = random_corner(random), c = random_corner(random), d = random_corner(random);
    INFO("seed 44, pair " << i);
    const auto here = on_edge(clip_triangle(ClipCorners{a, b, c}, kAllPlanes, kTightGl));
    const auto there = on_edge(clip_triangle(ClipCorners{b, a, d}, kAllPlanes, kTightGl));
    // One triangle may be gone where the other still shows a bit of the edge.
    if (!here.empty() && !there.empty()) CHECK(here == there);
  }
}

}  // namespace tuberia
